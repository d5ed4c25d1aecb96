package s7.trace;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.TreeMap;
import java.util.TreeSet;

import s7.log.Fields;
import tla.eval.State;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.Value;

/** The times at which something may change if no line comes, by the time elapsed: the first few of them. */
final class Times {
  /** Times that are looked at: now, and when something happens by itself. */
  private static final int MOST = 4;

  private static final int MS_PER_MINUTE = 60_000;

  /** Steps by which time goes on. */
  private static final int MOST_STEPS = 10_000;

  /** A time, and the events that are due by then where nothing may come later. */
  record Time(Value clocks, LinkedHashMap<String, Object> due, TreeSet<String> requirements) {
    Time(Value clocks, Contract spec) {
      this(clocks, new LinkedHashMap<>(), spec.requirements());
    }
  }

  private final Contract spec;
  private final Value past;
  private final TreeMap<String, Time> found = new TreeMap<>();
  private final TreeMap<String, Value> behind = new TreeMap<>();
  private final TreeMap<String, Value> ends = new TreeMap<>();
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

  /**
   * Now, whenever something happens by itself, when something is late, and when something comes to nothing, its last
   * moment and the next one; in their order.
   */
  List<Time> all() {
    stuck.forEach(this::late);
    ends.forEach((key, clocks) -> found.putIfAbsent(key, new Time(clocks, spec)));
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
      Time present = new Time(spec.present(state), spec);
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
      if (standsStill(state, next)) {
        comesToNothing(state);
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

  /** Whether a step of time takes none: something comes to nothing on the way. */
  private boolean standsStill(State state, List<State> next) {
    Value present = spec.present(state);
    return next.stream().anyMatch(each -> spec.present(each).equals(present));
  }

  /** Looks for the last moment before that, and adds it and the next one. */
  private void comesToNothing(State state) {
    Value present = spec.present(state);
    int last = 0;
    int gone = elapsed(spec.tooLateNow(state)) - elapsed(present);
    while (gone - last > 1) {
      int middle = (last + gone) / 2;
      if (standsStill(state, spec.elapse(state, spec.instant(later(present, middle))))) {
        gone = middle;
      } else {
        last = middle;
      }
    }
    if (last == 0) {
      return; // a start point or a missing OB: it takes no time at all
    }
    for (int ms : new int[] {last, gone}) {
      Value clocks = later(present, ms);
      ends.put(sortable(clocks), clocks);
    }
  }

  private static int elapsed(Value clocks) {
    Fields up = Values.object(clocks).object(Contract.UP);
    return up.number(Contract.MINUTES) * MS_PER_MINUTE + up.number(Contract.MILLISECONDS);
  }

  /** Both clocks so many milliseconds later. */
  private Value later(Value clocks, int ms) {
    Fields json = Values.object(clocks);
    for (String name : List.of(Contract.AT, Contract.UP)) {
      Fields moment = json.object(name);
      int sum = moment.number(Contract.MILLISECONDS) + ms;
      moment.put(Contract.MINUTES, moment.number(Contract.MINUTES) + sum / MS_PER_MINUTE);
      moment.put(Contract.MILLISECONDS, sum % MS_PER_MINUTE);
    }
    return Values.like(clocks, json);
  }

  /** Time cannot go on from {@code state}: something has to come. */
  private void late(State state) {
    Value limit = spec.lastInTime(state);
    Time time = found.computeIfAbsent(sortable(limit), key -> new Time(limit, spec));
    RecordValue later = spec.instant(spec.tooLateNow(state));
    for (Object due : spec.expected(Contract.Failing.TOO_LATE, state, later)) {
      time.due.put(due.toString(), due);
    }
    for (Object id : spec.deciding(Contract.Failing.TOO_LATE, state, later, past)) {
      time.requirements.add((String) id);
    }
  }

  /** A text by which times are in the order of the time elapsed. */
  private static String sortable(Value clocks) {
    Fields json = Values.object(clocks);
    var text = new StringBuilder();
    for (String name : List.of(Contract.UP, Contract.AT)) {
      // As many digits for each.
      text.append(1_000_000_000_000L + json.object(name).number(Contract.MINUTES));
      text.append(1_000_000 + json.object(name).number(Contract.MILLISECONDS));
    }
    return text.toString();
  }
}
