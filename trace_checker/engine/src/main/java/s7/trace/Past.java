package s7.trace;

import java.util.ArrayDeque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

import tlc2.value.impl.RecordValue;
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;

/**
 * The lines of a log that were explained, as far as a report may need them: the latest ones, and of
 * the older ones the last of each event, OB and MODE.
 */
final class Past {
  /** Lines kept whatever they are. */
  static final int LATEST = 40;

  private final ArrayDeque<RecordValue> latest = new ArrayDeque<>();
  /** By kind, the one that was put in last at the end. */
  private final Map<List<Object>, Value> older = new LinkedHashMap<>(16, 0.75f, true);

  void add(RecordValue event) {
    latest.addLast(event);
    if (latest.size() > LATEST) {
      RecordValue oldest = latest.removeFirst();
      older.put(kind(oldest), oldest);
    }
  }

  /** The lines as a sequence, the latest at its end. */
  Value lines() {
    var lines = new Value[older.size() + latest.size()];
    int i = 0;
    for (Value event : older.values()) {
      lines[i++] = event;
    }
    for (Value event : latest) {
      lines[i++] = event;
    }
    return new TupleValue(lines);
  }

  private static List<Object> kind(RecordValue event) {
    return List.of(
        Values.field(event, "event"), Values.field(event, "ob"), Values.field(event, "mode"));
  }
}
