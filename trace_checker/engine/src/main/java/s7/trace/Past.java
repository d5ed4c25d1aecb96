package s7.trace;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

import tla.eval.Shaped;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;

/**
 * The explained lines of a log that a report may need: the latest ones, and of the older ones the
 * last of each kind ({@link Contract#KIND}).
 */
final class Past {
  /** Lines of any kind that are kept. */
  static final int LATEST = 40;

  private final ArrayDeque<RecordValue> latest = new ArrayDeque<>();
  /** By kind; the latest line is the last. */
  private final Map<Object, Value> older = new LinkedHashMap<>(16, 0.75f, true);

  Past() {}

  Past(Past other) {
    latest.addAll(other.latest);
    older.putAll(other.older);
  }

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

  private static Object kind(RecordValue event) {
    return event instanceof Shaped shaped ? shaped.noted(Past::kindOf) : kindOf(event);
  }

  private static List<Object> kindOf(RecordValue event) {
    var kind = new Object[Contract.KIND.size()];
    for (int i = 0; i < kind.length; i++) {
      kind[i] = Values.field(event, Contract.KIND.get(i));
    }
    return Arrays.asList(kind);
  }
}
