package s7.trace;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonParser;
import tla.json.Json;
import tla.spec.Guards;
import tlc2.tool.StateVec;
import tlc2.tool.TLCState;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.Value;

/**
 * The set of specification states that explain a log so far.
 *
 * <p>The set goes from line to line: time elapses to the line, any number of silent steps follows,
 * the line is observed. All three are operators of the specification ({@link Contract}); this class
 * does not know their meaning.
 */
final class Explanation {
  /** The most states that are followed; nobody can follow the open questions of a log with more. */
  static final int MOST_STATES = 20_000;

  /** Situations and candidates that a report can show. */
  private static final int MOST_SHOWN = 3;

  private static final int MOST_CANDIDATES = 16;
  private static final int MOST_NEAR = 8;

  /**
   * Why no state is left.
   *
   * @param late whether another event had to come before this one
   * @param expected the events that were possible in its place, or had to come before it
   * @param requirements the requirements that decide
   * @param states the number of states before the event
   * @param situations the states that come nearest to it
   * @param candidates the actions that might have explained it, each with its false conjunct
   */
  record Refusal(
      boolean late,
      List<JsonElement> expected,
      Set<String> requirements,
      int states,
      List<JsonElement> situations,
      Set<Guards.Failure> candidates) {}

  private final Contract spec;
  private final Past past = new Past();
  private List<TLCState> states;

  /**
   * Starts a log.
   *
   * @param header the normalised header, an object as JSON
   * @throws NotCovered if the header asks for a reading or profile that the specification does not
   *     have
   */
  Explanation(Contract spec, Json header) {
    this.spec = spec;
    try {
      begin(header);
    } catch (NotCovered e) {
      throw e;
    } catch (RuntimeException e) {
      throw NotCovered.because("at the header", e);
    }
  }

  private void begin(Json header) {
    Value h = spec.header(header);
    JsonArray open = spec.notCovered(h);
    if (!open.isEmpty()) {
      throw new NotCovered("the header asks for what the specification does not cover: " + open);
    }
    states = list(spec.begin(h));
  }

  /** How many states explain the log so far. */
  int size() {
    return states.size();
  }

  /** One of the situations in which the CPU may be after the log so far. */
  JsonElement situation() {
    return spec.situation(states.get(0));
  }

  /**
   * Observes one event.
   *
   * @param event the normalised event, an object as JSON
   * @return null if it is explained, else why not; the states then stay as before the event
   * @throws NotCovered if more states explain the log than can be followed, or if the
   *     specification cannot be evaluated for this event
   */
  Refusal observe(Json event) {
    try {
      return observed(spec.event(event));
    } catch (NotCovered e) {
      throw e;
    } catch (RuntimeException e) {
      JsonElement name = JsonParser.parseString(event.toString()).getAsJsonObject().get("event");
      throw NotCovered.because("at the event " + name, e);
    }
  }

  private Refusal observed(RecordValue event) {
    List<TLCState> stuck = new ArrayList<>();
    List<TLCState> arrived = elapse(event, stuck);
    if (arrived.isEmpty()) {
      // Where changes of mode may be unseen, every state goes on, round in circles.
      List<TLCState> late = stuck.isEmpty() ? states : stuck;
      return refusal(Contract.Failing.TOO_LATE, late, late, event);
    }
    List<TLCState> ready = closure(arrived, event);
    List<TLCState> after = new ArrayList<>(ready.size());
    for (TLCState state : ready) {
      addAll(after, spec.observe(state, event));
    }
    if (after.isEmpty()) {
      return refusal(Contract.Failing.UNEXPLAINED, ready, nearest(ready, event), event);
    }
    states = distinct(after);
    past.add(event);
    return null;
  }

  /** The states after time has elapsed to the event; states that cannot get there go to {@code stuck}. */
  private List<TLCState> elapse(Value event, List<TLCState> stuck) {
    if (states.size() == 1 && spec.arrived(states.get(0), event)) {
      return states;
    }
    List<TLCState> arrived = new ArrayList<>();
    var open = new ArrayDeque<TLCState>(states);
    var seen = new HashSet<Long>();
    int lonely = 0;
    while (!open.isEmpty()) {
      TLCState state = open.poll();
      if (spec.arrived(state, event)) {
        arrived.add(state);
        continue;
      }
      StateVec next = spec.elapse(state, event);
      if (next.size() == 0) {
        stuck.add(state);
      }
      // A single state that goes on alone, the usual case, needs no fingerprint, unless it goes
      // round in circles.
      boolean alone =
          open.isEmpty() && next.size() == 1 && arrived.isEmpty() && ++lonely < MOST_STATES;
      for (int i = 0; i < next.size(); i++) {
        if (alone || seen.add(spec.key(next.elementAt(i)))) {
          open.add(next.elementAt(i));
        }
      }
      limit(open.size());
    }
    return distinct(arrived);
  }

  private List<TLCState> closure(List<TLCState> from, Value event) {
    List<TLCState> closed = from;
    Set<Long> seen = null;
    for (int i = 0; i < closed.size(); i++) {
      TLCState state = closed.get(i);
      if (!spec.stirs(state, event)) {
        continue;
      }
      StateVec next = spec.silent(state, event);
      if (next.size() > 0 && seen == null) {
        closed = new ArrayList<>(closed);
        seen = new HashSet<>();
        for (TLCState known : closed) {
          seen.add(spec.key(known));
        }
      }
      for (int k = 0; k < next.size(); k++) {
        if (seen.add(spec.key(next.elementAt(k)))) {
          closed.add(next.elementAt(k));
        }
      }
      limit(closed.size());
    }
    return closed;
  }

  /** The states that come nearest to the event, by the specification's own measure. */
  private List<TLCState> nearest(List<TLCState> from, Value event) {
    List<TLCState> nearest = new ArrayList<>();
    int least = Integer.MAX_VALUE;
    for (TLCState state : from) {
      int distance = spec.distance(state, event);
      if (distance < least) {
        least = distance;
        nearest.clear();
      }
      if (distance == least) {
        nearest.add(state);
      }
    }
    return nearest;
  }

  private Refusal refusal(
      Contract.Failing failing, List<TLCState> from, List<TLCState> near, Value event) {
    Value lines = past.lines();
    var allowed = new TreeMap<String, JsonElement>();
    for (TLCState state : from) {
      for (JsonElement e : spec.expected(failing, state, event)) {
        allowed.put(e.toString(), e);
      }
    }
    var requirements = new TreeSet<String>();
    for (TLCState state : near) {
      for (JsonElement r : spec.deciding(failing, state, event, lines)) {
        requirements.add(r.getAsString());
      }
    }
    var situations = new LinkedHashMap<String, JsonElement>();
    var candidates = new LinkedHashSet<Guards.Failure>();
    for (TLCState state : near.subList(0, Math.min(near.size(), MOST_NEAR))) {
      JsonElement situation = spec.situation(state);
      if (situations.size() < MOST_SHOWN) {
        situations.put(situation.toString(), situation);
      }
      for (Guards.Failure failure : failures(failing, state, event)) {
        if (candidates.size() < MOST_CANDIDATES) {
          candidates.add(failure);
        }
      }
    }
    return new Refusal(
        failing == Contract.Failing.TOO_LATE,
        new ArrayList<>(allowed.values()),
        requirements,
        from.size(),
        new ArrayList<>(situations.values()),
        candidates);
  }

  /** None if they cannot be found: a report without candidates is better than no report. */
  private Set<Guards.Failure> failures(Contract.Failing failing, TLCState state, Value event) {
    try {
      return spec.failures(failing, state, event);
    } catch (RuntimeException | StackOverflowError e) {
      return Set.of();
    }
  }

  private List<TLCState> distinct(List<TLCState> from) {
    if (from.size() < 2) {
      return from;
    }
    var seen = new HashSet<Long>();
    var distinct = new ArrayList<TLCState>(from.size());
    for (TLCState state : from) {
      if (seen.add(spec.key(state))) {
        distinct.add(state);
      }
    }
    return distinct;
  }

  private List<TLCState> list(StateVec vector) {
    var list = new ArrayList<TLCState>(vector.size());
    addAll(list, vector);
    return distinct(list);
  }

  private static void addAll(List<TLCState> list, StateVec vector) {
    for (int i = 0; i < vector.size(); i++) {
      list.add(vector.elementAt(i));
    }
    limit(list.size());
  }

  private static void limit(int size) {
    if (size > MOST_STATES) {
      throw new NotCovered(
          "more than " + MOST_STATES + " states explain the log; choose readings in the header");
    }
  }
}
