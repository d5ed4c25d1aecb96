package s7.importing;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Pattern;

import s7.log.Fields;
import s7.log.Quoting;
import s7.log.Unusable;

/** CSV, one event a row, by a map from the log's fields to its columns. */
final class Table {
  private static final String MAP = "column map";
  private static final String EVENT = "event";
  private static final String AT = "at";

  /** Fields that hold a date and time. */
  private static final Set<String> TIMES = Set.of(AT, "to", "sdt", "info.time");

  private static final Set<String> KNOWN =
      Set.of("columns", "values", "others", "times", "delimiter", "encoding", "newest_first");

  private static final Pattern INTEGER = Pattern.compile("-?[0-9]{1,18}");

  private record Row(int number, List<String> cells) {
    String place() {
      return "line " + number;
    }
  }

  /** Field of the log -> heading of its column. */
  private final Fields columns;

  /** Field -> text of a cell -> value in the log; null leaves out the field, or the row. */
  private final Fields values;

  /** Field -> value in the log for any other text. */
  private final Fields others;

  private final Times times;
  private final char delimiter;
  private final boolean newestFirst;

  private Table(Fields map) {
    columns = (Fields) map.get("columns");
    values = part(map, "values");
    others = part(map, "others");
    times = map.get("times") == null ? null : new Times(map.text("times"));
    String between = map.has("delimiter") ? map.text("delimiter") : ",";
    newestFirst = Boolean.TRUE.equals(map.get("newest_first"));
    for (String field : List.of(AT, EVENT)) {
      if (!columns.has(field)) {
        throw new Unusable('"' + field + "\" among the columns", "none").of(MAP);
      }
    }
    if (between.length() != 1) {
      throw new Unusable("a delimiter of one character", Quoting.inMarks(between)).of(MAP);
    }
    delimiter = between.charAt(0);
  }

  private static Fields part(Fields map, String name) {
    return map.has(name) ? map.object(name) : new Fields();
  }

  /** How rows are read, as a JSON text says, whose bytes are the first 256 characters of Unicode. */
  static Table of(String map) {
    String expected = "a JSON object with columns, see docs/checking/import.md";
    Fields read;
    try {
      read = Fields.of(map.getBytes(StandardCharsets.ISO_8859_1));
    } catch (Unusable wrong) {
      throw new Unusable(expected, wrong.asJson().text("found")).of(MAP);
    }
    String wrong = wrong(read);
    if (wrong != null) {
      throw new Unusable(expected, wrong).of(MAP);
    }
    return new Table(read);
  }

  /** What is wrong in a map; null if nothing. */
  private static String wrong(Fields map) {
    for (int i = 0; i < map.size(); i++) {
      String name = map.name(i);
      Object value = map.value(i);
      boolean fits =
          switch (name) {
            case "columns" -> value instanceof Fields fields && all(fields, String.class::isInstance);
            case "values" ->
                value instanceof Fields fields
                    && all(fields, each -> each instanceof Fields texts && all(texts, Table::isScalar));
            case "others" -> value instanceof Fields fields && all(fields, Table::isScalar);
            case "newest_first" -> value instanceof Boolean;
            case "times" -> value == null || value instanceof String;
            default -> value instanceof String;
          };
      if (!KNOWN.contains(name) || !fits) {
        return Quoting.inMarks(name) + (KNOWN.contains(name) ? " of another type" : ", an unknown field");
      }
    }
    return map.has("columns") ? null : "no columns";
  }

  private static boolean all(Fields fields, Predicate<Object> fits) {
    for (int i = 0; i < fields.size(); i++) {
      if (!fits.test(fields.value(i))) {
        return false;
      }
    }
    return true;
  }

  private static boolean isScalar(Object value) {
    return value == null || value instanceof String || value instanceof Long;
  }

  /** The events of the rows; a wrong value shows when the whole log is checked. */
  Recording convert(String text, Recording.Span chosen) {
    var recording = new Recording();
    var csv = new Csv(text, delimiter);
    List<String> headings = csv.next();
    List<Integer> places = places(headings == null ? List.of() : headings, recording);
    var rows = new ArrayList<Row>();
    for (List<String> cells = csv.next(); cells != null; cells = csv.next()) {
      if (!cells.isEmpty()) {
        var row = new Row(csv.line(), cells);
        if (cells.size() != headings.size()) {
          throw new Unusable(headings.size() + " cells", "another number of them").of(row.place());
        }
        rows.add(row);
      }
    }
    if (newestFirst) {
      Collections.reverse(rows);
    }
    for (Row row : recording.select(rows, Row::number, chosen)) {
      Fields event = event(row, places);
      if (event.get(EVENT) == null) {
        recording.skip("left out by the column map", 1);
      } else {
        recording.add(row.place(), event);
      }
    }
    if (!recording.events.isEmpty()) {
      recording.header.put("clock", recording.events.get(0).event().get(AT));
    }
    recording.header.put("records", List.of());
    return recording;
  }

  /** The places of the fields' columns among the headings. */
  private List<Integer> places(List<String> headings, Recording recording) {
    var places = new ArrayList<Integer>();
    for (int i = 0; i < columns.size(); i++) {
      int place = headings.lastIndexOf(columns.value(i));
      if (place < 0) {
        throw new Unusable(
                "the heading " + Quoting.inMarks((String) columns.value(i)),
                Quoting.inMarks(String.join(String.valueOf(delimiter), headings)))
            .of("line 1");
      }
      places.add(place);
    }
    List<String> unused =
        headings.stream()
            .filter(heading -> !places.contains(headings.lastIndexOf(heading)))
            .map(Quoting::inMarks)
            .toList();
    if (!unused.isEmpty()) {
      recording.remarks.add("columns not used: " + String.join(", ", unused));
    }
    return places;
  }

  private Fields event(Row row, List<Integer> places) {
    Fields event = new Fields().put(EVENT, null).put(AT, null);
    for (int i = 0; i < columns.size(); i++) {
      String field = columns.name(i);
      Object value;
      try {
        value = value(field, row.cells.get(places.get(i)).strip());
      } catch (Unusable wrong) {
        throw wrong.inside(field).of(row.place());
      }
      int dot = field.indexOf('.');
      if (value != null && dot < 0) {
        event.put(field, value);
      } else if (value != null) {
        String outer = field.substring(0, dot);
        if (!(event.get(outer) instanceof Fields)) {
          event.put(outer, new Fields());
        }
        event.object(outer).put(field.substring(dot + 1), value);
      }
    }
    return event;
  }

  /** What the log says for a cell; an empty one says nothing. */
  private Object value(String field, String cell) {
    Fields known = values.has(field) ? values.object(field) : new Fields();
    if (known.has(cell)) {
      return known.get(cell);
    }
    if (cell.isEmpty()) {
      return null;
    }
    if (others.has(field)) {
      return others.get(field);
    }
    if (times != null && TIMES.contains(field)) {
      return times.read(cell);
    }
    return INTEGER.matcher(cell).matches() ? (Object) Long.valueOf(cell) : cell;
  }
}
