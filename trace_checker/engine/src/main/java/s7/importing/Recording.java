package s7.importing;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToIntFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import s7.log.Fields;
import s7.log.Quoting;
import s7.log.Unusable;

/** What a source gives: the events, oldest first. */
final class Recording {
  /** An event of the log and the place in the source that tells of it. */
  record Placed(String place, Fields event) {}

  /** Numbers of entries. */
  record Span(long first, long last) {
    private static final Pattern WRITTEN = Pattern.compile("([0-9]{0,10})-([0-9]{0,10})");

    /** Such as {@code 5-20}, {@code 5-}, {@code -20}; null for null. */
    static Span of(String text) {
      if (text == null) {
        return null;
      }
      Matcher parts = WRITTEN.matcher(text);
      if (!parts.matches() || text.equals("-")) {
        throw new Unusable("numbers of entries such as 5-20, 5- or -20", Quoting.inMarks(text)).of("--entries");
      }
      String last = parts.group(2);
      return new Span(Long.parseLong("0" + parts.group(1)), last.isEmpty() ? Long.MAX_VALUE : Long.parseLong(last));
    }
  }

  final List<Placed> events = new ArrayList<>();

  /** Those of the header's fields that the source tells. */
  final Fields header = new Fields();

  /** How many entries there were. */
  int read;

  /** Why entries gave no event, and how many of them. */
  final Map<String, Integer> skipped = new LinkedHashMap<>();

  /** Sentences about the limits of the log. */
  final List<String> remarks = new ArrayList<>();

  /** The OBs that an entry shows as started, and those that an entry says could not be, with the first such place. */
  final Map<Integer, String> started = new LinkedHashMap<>();

  final Map<Integer, String> missing = new LinkedHashMap<>();

  void add(String place, Fields event) {
    events.add(new Placed(place, event));
  }

  /** Counts entries that give no event. */
  void skip(String reason, int count) {
    if (count > 0) {
      skipped.merge(reason, count, Integer::sum);
    }
  }

  /** The entries whose numbers are chosen, all if that is null; the others count as skipped. */
  <E> List<E> select(List<E> entries, ToIntFunction<E> number, Span chosen) {
    var kept = new ArrayList<E>();
    for (E entry : entries) {
      int its = number.applyAsInt(entry);
      if (chosen == null || (its >= chosen.first && its <= chosen.last)) {
        kept.add(entry);
      }
    }
    read = entries.size();
    skip("outside --entries", entries.size() - kept.size());
    if (kept.isEmpty()) {
      throw new Unusable(
          "an entry to import",
          entries.isEmpty()
              ? "no entry"
              : "entries "
                  + number.applyAsInt(entries.get(0))
                  + " to "
                  + number.applyAsInt(entries.get(entries.size() - 1)));
    }
    return kept;
  }

  /** What is to be said of it: how much was read, what was left out and why, what the log does not tell. */
  List<String> told(Fields complete) {
    var told = new ArrayList<String>();
    int left = skipped.values().stream().mapToInt(Integer::intValue).sum();
    told.add(read + " entries read, " + left + " skipped; " + events.size() + " events written");
    skipped.forEach((reason, count) -> told.add(count + " skipped: " + reason));
    var records = new ArrayList<String>();
    complete.list("records").forEach(kind -> records.add((String) kind));
    told.add("recorded completely: " + (records.isEmpty() ? "nothing" : String.join(", ", records)));
    remarks.forEach(remark -> told.add("note: " + remark));
    List<?> loaded = complete.list("obs");
    missing.forEach(
        (ob, place) -> {
          if (loaded.contains((long) ob)) {
            told.add(
                "note: " + place + ": OB " + ob + " could not be started (priority 16#FE), as if it were not loaded; "
                    + "--obs names it");
          }
        });
    started.forEach(
        (ob, place) -> {
          if (!loaded.contains((long) ob)) {
            told.add("note: " + place + ": OB " + ob + " was started, so it is loaded; --obs does not name it");
          }
        });
    return told;
  }
}
