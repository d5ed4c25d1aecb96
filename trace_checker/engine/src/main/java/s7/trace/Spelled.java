package s7.trace;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.IntFunction;

import s7.log.Days;
import s7.log.Fields;

/** Normalised values as a log spells them, and lines in short. */
final class Spelled {
  private static final int MS_PER_MINUTE = 60_000;
  private static final int NOT_LOGGED = -1;

  private static final Set<String> WORDS =
      Set.of("period", "sign", "ret", "status", "cause", "id", "error_info", "ev");
  private static final Set<String> BYTES = Set.of("mode", "flt_id", "strt_info");
  private static final Set<String> SHOWN_BYTES = Set.of("flt_id", "strt_info");

  /** The causes of a STOP; that of a request is an OB. */
  private static final Set<String> CAUSES = Set.of("cause", "e.cause", "stopCause");

  private static final Set<String> TRUTHS =
      Set.of("active", "blocked", "loaded", "entries_off", "local", "activate", "caught_up", "second_time");
  private static final Set<String> OF_THE_ENGINE = Set.of("line", "step", "until", "counter");
  private static final List<String> DATE = List.of("year", "month", "day", "hour", "minute", "second", "ms");

  private Spelled() {}

  static int number(Object value) {
    return ((Number) value).intValue();
  }

  /** Such as {@code 16#0201}. */
  static String hex(int value, int digits) {
    String text = Integer.toHexString(value & (digits == 2 ? 0xFF : 0xFFFF)).toUpperCase();
    return "16#" + "0000".substring(0, digits - text.length()) + text;
  }

  /** A moment, minutes and milliseconds, with seconds and milliseconds. */
  static String moment(Object at) {
    return Days.iso(milliseconds(at));
  }

  static long milliseconds(Object at) {
    var moment = (Fields) at;
    return (long) moment.number("min") * MS_PER_MINUTE + moment.number("ms");
  }

  /** The object of a log's line for a normalised event, which may lack fields; a call without {@code ret} gets null. */
  static Fields line(Fields event) {
    var line = new Fields();
    for (int i = 0; i < event.size(); i++) {
      if (!OF_THE_ENGINE.contains(event.name(i))) {
        line.put(event.name(i), value(event.name(i), event.value(i)));
      }
    }
    String name = event.text("event");
    if (isCall(name)) {
      // Operands that the engine does not tell, since a line without them has the same number.
      if (!name.endsWith("_AIRT") && !line.has("ob")) {
        line.put("ob", 0);
      }
      if (name.equals("SRT_DINT") && !line.has("dtime")) {
        line.put("dtime", -1);
      }
      if (!line.has("ret")) {
        line.put("ret", null);
      }
    }
    return line;
  }

  static boolean isCall(String name) {
    return name.equals(name.toUpperCase());
  }

  private static Object value(String name, Object value) {
    if (name.equals("info")) {
      return info((Fields) value);
    }
    if (name.equals("up")) {
      return milliseconds(value);
    }
    if (name.equals("sdt")) {
      var parts = DATE.stream().mapToInt(part -> ((Fields) value).number(part)).toArray();
      return Days.spelled(parts).replaceAll("(:00)?\\.000$", "");
    }
    if (value instanceof Fields) {
      return moment(value);
    }
    if (!(value instanceof Number)) {
      return value;
    }
    int number = number(value);
    if (TRUTHS.contains(name)) {
      return number != 0;
    }
    if (name.equals("ret") && number == NOT_LOGGED) {
      return null;
    }
    return WORDS.contains(name) ? "W#" + hex(number, 4) : BYTES.contains(name) ? "B#" + hex(number, 2) : value;
  }

  private static Fields info(Fields given) {
    var info = new Fields();
    for (int i = 0; i < given.size(); i++) {
      Object value = given.value(i);
      boolean logged = value instanceof Fields time ? time.number("min") != NOT_LOGGED : number(value) != NOT_LOGGED;
      if (logged) {
        info.put(given.name(i), value(given.name(i), value));
      }
    }
    return info;
  }

  /** A line's object without its time in one short text, such as {@code SET_TINT ob=10 period=W#16#0201}. */
  static String text(Fields line) {
    var parts = new ArrayList<String>();
    parts.add(line.text("event"));
    for (int i = 0; i < line.size(); i++) {
      if (!Set.of("event", "at", "up").contains(line.name(i))) {
        parts.add(line.name(i) + "=" + text(line.value(i)));
      }
    }
    return String.join(" ", parts);
  }

  private static String text(Object value) {
    if (!(value instanceof Fields object)) {
      return String.valueOf(value);
    }
    var parts = new ArrayList<String>();
    for (int i = 0; i < object.size(); i++) {
      parts.add(object.name(i) + "=" + text(object.value(i)));
    }
    return "{" + String.join(", ", parts) + "}";
  }

  /**
   * What the specification allows in the place of a line, such as {@code start ob=80 flt_id=16#05}; a value that it
   * leaves open is left out.
   */
  static String allowed(Fields allowed) {
    var text = new StringBuilder(allowed.text("event"));
    if (given(allowed, "ob") > 0) {
      text.append(" ob=").append(allowed.number("ob"));
    }
    String value = allowedValue(allowed);
    return value.isEmpty() ? text.toString() : text + " " + allowed.text("field") + "=" + value;
  }

  /** The value that the field must have; empty if there is no field, or its value is open. */
  static String allowedValue(Fields allowed) {
    String field = allowed.has("field") ? allowed.text("field") : "";
    if (field.equals("time")) {
      return moment(allowed.get("time"));
    }
    int value = given(allowed, "value");
    return field.isEmpty() || value == NOT_LOGGED ? "" : value(field, value);
  }

  /** Words and bytes in hexadecimal. */
  static String value(String field, int value) {
    if (TRUTHS.contains(field)) {
      return String.valueOf(value != 0);
    }
    boolean word = WORDS.contains(field);
    return word ? hex(value, 4) : SHOWN_BYTES.contains(field) ? hex(value, 2) : String.valueOf(value);
  }

  /** How a formula spells the numbers of an operand, a name or a field such as {@code e.ret}; null for no codes. */
  static IntFunction<String> numbers(String operand) {
    String name = operand.substring(operand.lastIndexOf('.') + 1);
    String field = CAUSES.contains(operand) ? "cause" : name.equals("cause") ? "ob" : name;
    return WORDS.contains(field) || SHOWN_BYTES.contains(field) ? number -> value(field, number) : null;
  }

  static int given(Fields object, String name) {
    return object.has(name) ? object.number(name) : 0;
  }

  /** What the specification allows, as values of a line's fields. */
  static Fields instead(Fields allowed) {
    var line = new Fields().put("event", allowed.text("event"));
    if (given(allowed, "ob") > 0) {
      line.put("ob", allowed.number("ob"));
    }
    String field = allowed.has("field") ? allowed.text("field") : "";
    if (!field.isEmpty()) {
      Object value = value(field, field.equals("time") ? allowed.get("time") : (Object) given(allowed, "value"));
      if ("start".equals(allowed.text("event"))) {
        line.put("info", new Fields().put(field, value));
      } else {
        line.put(field, value);
      }
    }
    return line;
  }

  /**
   * The lines in the place of a rejected one, texts: itself with what is allowed, or that before it; null where
   * any call is allowed.
   */
  static List<String> inPlace(Fields allowed, boolean late, byte[] given, String at) {
    Fields instead = instead(allowed);
    Fields line = Fields.of(given);
    if (instead.text("event").equals("call")) {
      return null;
    }
    boolean ofAnother = instead.has("ob") && !String.valueOf(instead.get("ob")).equals(String.valueOf(line.get("ob")));
    if (late || ofAnother || !instead.get("event").equals(line.get("event"))) {
      String before = new Fields().put("at", at).with(instead).toString();
      return List.of(before, new String(given, StandardCharsets.UTF_8));
    }
    if (instead.has("info") && line.has("info")) {
      instead.put("info", line.object("info").with(instead.object("info")));
    }
    return List.of(line.with(instead).toString());
  }
}
