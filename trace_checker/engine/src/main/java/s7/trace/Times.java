package s7.trace;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.TreeMap;
import java.util.TreeSet;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import tla.eval.State;
import tla.json.Values;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.Value;

/** The times at which something may change if no line comes, by the time elapsed: the first few of them. */
final class Times {
  /** Times that are looked at: now, and when something happens by itself. */
  private static final int MOST = 4;

  /** Steps by which time goes on. */
  private static final int MOST_STEPS = 10_000;

  /** A time, and the events that are due by then where nothing may come later. */
  record Time(Value clocks, List<JsonElement> due, TreeSet<String> requirements) {
    Time(Value clocks) {
      this(clocks, new ArrayList<>(), new TreeSet<>());
    }
  }

  private final Contract spec;
  private final Value past;
  private final TreeMap<String, Time> found = new TreeMap<>();
  private final TreeMap<String, Value> behind = new TreeMap<>();
  private final List<State> stuck = new ArrayList<>();
  private final boolean endless;

  /**
   * Looks ahead.
   *
   * @param from the states in which the CPU may be
   * @param past the lines before, as {@link Past} keeps them
   */
  Times(Contract spec, List<State> from, Value past) {
    this.spec = spec;
    this.past = past;
    endless = look(from);
  }

  /** Now, whenever something happens by itself, and when something is late; in their order. */
  List<Time> all() {
    stuck.forEach(this::late);
    return new ArrayList<>(found.values());
  }

  /** The clocks at these times, and just behind each, when all that waited then is late; by the time elapsed. */
  TreeMap<String, Value> clocks() {
    var clocks = new TreeMap<String, Value>(behind);
    found.forEach((key, time) -> clocks.put(key, time.clocks));
    for (State state : stuck) {
      Value limit = spec.lastInTime(state);
      clocks.put(sortable(limit), limit);
    }
    return clocks;
  }

  /** Whether a line may come at any later time. */
  boolean endless() {
    return endless;
  }

  private boolean look(List<State> from) {
    var open = new ArrayDeque<State>(from);
    var seen = new HashSet<Long>();
    boolean goesOn = false;
    int steps = 0;
    while (!open.isEmpty()) {
      State state = open.poll();
      Time present = new Time(spec.present(state));
      found.putIfAbsent(sortable(present.clocks), present);
      Value later = spec.tooLateNow(state);
      behind.putIfAbsent(sortable(later), later);
      if (found.size() >= MOST || ++steps > MOST_STEPS) {
        return true;
      }
      RecordValue end = spec.instant(spec.endOfTime(state));
      if (spec.arrived(state, end)) {
        goesOn = true;
        continue;
      }
      List<State> next = spec.elapse(state, end);
      if (next.isEmpty()) {
        stuck.add(state);
      }
      for (State each : next) {
        if (spec.arrived(each, end)) {
          goesOn = true;
        } else if (seen.add(spec.key(each))) {
          open.add(each);
        }
      }
    }
    return goesOn;
  }

  /** Time cannot go on from {@code state}: something has to come. */
  private void late(State state) {
    Value limit = spec.lastInTime(state);
    Time time = found.computeIfAbsent(sortable(limit), key -> new Time(limit));
    RecordValue later = spec.instant(spec.tooLateNow(state));
    for (JsonElement due : spec.expected(Contract.Failing.TOO_LATE, state, later)) {
      if (!time.due.contains(due)) {
        time.due.add(due);
      }
    }
    for (JsonElement id : spec.deciding(Contract.Failing.TOO_LATE, state, later, past)) {
      time.requirements.add(id.getAsString());
    }
  }

  /** A text by which times are in the order of the time elapsed. */
  private static String sortable(Value clocks) {
    var json = Values.toJson(clocks).getAsJsonObject();
    var up = json.getAsJsonObject("up");
    var at = json.getAsJsonObject("at");
    return String.format(
        "%012d %06d %012d %06d", part(up, "min"), part(up, "ms"), part(at, "min"), part(at, "ms"));
  }

  private static int part(JsonObject moment, String name) {
    return moment.get(name).getAsInt();
  }
}
