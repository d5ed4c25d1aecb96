package s7.trace;

import java.util.ArrayDeque;
import java.util.LinkedHashMap;
import java.util.Map;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;

/**
 * The lines of a log that were explained, as far as a report may need them: the latest ones, and of
 * the older ones the last of each event, OB and MODE.
 */
final class Past {
  /** Lines kept whatever they are. */
  static final int LATEST = 40;

  private static final String[] KIND = {"event", "ob", "mode"};

  private record Line(String kind, Value event) {}

  private final ArrayDeque<Line> latest = new ArrayDeque<>();
  private final Map<String, Value> older = new LinkedHashMap<>();

  void add(JsonObject json, Value event) {
    latest.addLast(new Line(kind(json), event));
    if (latest.size() > LATEST) {
      Line oldest = latest.removeFirst();
      older.remove(oldest.kind);
      older.put(oldest.kind, oldest.event);
    }
  }

  /** The lines as a sequence, the latest at its end. */
  Value lines() {
    var lines = new Value[older.size() + latest.size()];
    int i = 0;
    for (Value event : older.values()) {
      lines[i++] = event;
    }
    for (Line line : latest) {
      lines[i++] = line.event;
    }
    return new TupleValue(lines);
  }

  private static String kind(JsonObject json) {
    var kind = new StringBuilder();
    for (String field : KIND) {
      JsonElement value = json.get(field);
      kind.append(value == null ? "" : value.getAsString()).append('/');
    }
    return kind.toString();
  }
}
