package s7.trace;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.ToLongFunction;

import s7.log.Fields;
import tla.eval.State;
import tla.spec.Guards;
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

  /** The most states that are followed where the specification can keep definite facts instead. */
  private static final int LOOSE_STATES = 1_000;

  /** From so many states on, those meet that can. */
  private static final int MANY_STATES = 128;

  /** From so many on after states have met, for so many lines: what made them many goes on. */
  private static final int SOME_STATES = 16;

  private static final int SOON = 16;

  /** The most steps for a log, and those that each line adds, where {@link #WIDE} states or more are followed. */
  private static final int WORK = 30_000;

  private static final int WORK_OF_A_LINE = 10;
  private static final int WIDE = 32;

  /** What a state costs that meets others, in steps. */
  private static final int MEETING = 4;

  /**
   * Each so many lines, and steps of time, a state is asked if there is too much in it: a prime, since several states
   * take turns.
   */
  private static final int NOW_AND_THEN = 17;

  /** The most steps of several states from one line to the next. */
  private static final int MOST_STEPS = 1_000_000;

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
      Collection<?> expected,
      Set<String> requirements,
      int states,
      Collection<?> situations,
      Set<Guards.Failure> candidates) {
    /** What it is, in a sentence. */
    String message() {
      return late
          ? "something had to come before this line"
          : "no behaviour of the specification explains this line";
    }

    Fields asJson() {
      return new Fields().put("late", late).put("expected", expected).put("requirements", requirements);
    }
  }

  private final Contract spec;
  private final Past past;
  private final Set<Object> startedObs = new HashSet<>();
  private final Set<Integer> classes = new TreeSet<>();
  private List<State> states;
  private int most = LOOSE_STATES;
  private boolean loosened;
  private boolean partial;
  private boolean widened;

  /** Whether so many states are followed that definite facts alone are no way out. */
  private boolean crowded;

  private int fewest = MANY_STATES;
  private int met = -SOON;
  private int lines;
  private int largest;
  private long steps;
  private long work;

  /** Whether a line is judged: questions about what may come next are no work for the log. */
  private boolean judging;
  private Set<String> asked;
  private boolean refused;

  /** More states explain the log than are followed. */
  static final class TooMany extends RuntimeException {
    private static final long serialVersionUID = 1L;

    TooMany(String why) {
      super(why + "; choose readings in the header");
    }
  }

  /**
   * Starts a log.
   *
   * @param header the normalised header
   * @throws NotCovered if the header asks for a reading or profile that the specification does not
   *     have
   */
  Explanation(Contract spec, Fields header) {
    this.spec = spec;
    past = new Past();
    try {
      begin(header);
    } catch (NotCovered e) {
      throw e;
    } catch (RuntimeException e) {
      throw NotCovered.because("at the header", e);
    }
  }

  private void begin(Fields header) {
    Value h = spec.header(header);
    List<?> open = spec.notCovered(h);
    if (!open.isEmpty()) {
      throw new NotCovered("the specification does not cover these choices of the header: " + open);
    }
    states = spec.begin(h);
    limit(states.size());
    states = distinct(states);
    partial = spec.partial(states.get(0));
    loosened = spec.loose(states.get(0));
  }

  private Explanation(Explanation other) {
    spec = other.spec;
    past = new Past(other.past);
    states = other.states;
    most = other.most;
    partial = other.partial;
    loosened = other.loosened;
    crowded = other.crowded;
    lines = other.lines;
    work = other.work;
  }

  /** An explanation of the same log that goes on by itself. */
  Explanation branch() {
    return new Explanation(this);
  }

  /** The same with at most so many of its states, from everywhere among them. */
  Explanation sample(int most) {
    Explanation some = branch();
    if (states.size() > most) {
      some.states = new ArrayList<>();
      for (int i = 0; i < most; i++) {
        some.states.add(states.get((int) ((long) i * states.size() / most)));
      }
    }
    return some;
  }

  /** The same log after a line that leads to these states, whichever way. */
  Explanation at(List<State> after) {
    Explanation next = branch();
    limit(after.size());
    next.states = distinct(after, spec::keyAfterLine);
    return next;
  }

  /** How many states explain the log so far. */
  int size() {
    return states.size();
  }

  /** The states that explain the log so far. */
  List<State> states() {
    return states;
  }

  /** The explained lines that a report may need. */
  Value past() {
    return past.lines();
  }

  /** The states in which time has elapsed to the event; none if something had to come before. */
  List<State> arrivals(RecordValue event) {
    return elapse(event, new ArrayList<>());
  }

  /** The priority classes in which OBs have started, each OB for the first time. */
  Set<Integer> classes() {
    return classes;
  }

  /** The outcomes of the decisions that all explanations of the log so far have in common. */
  BitSet outcomes() {
    return State.commonOutcomes(states);
  }

  /** The outcomes of the decisions in some of the explanations, not in all of them. */
  BitSet openOutcomes() {
    BitSet open = State.allOutcomes(states);
    open.andNot(outcomes());
    return open;
  }

  /** One of the situations in which the CPU may be after the log so far. */
  Fields situation() {
    return spec.situation(states.get(0));
  }

  /**
   * Observes one event.
   *
   * @param event an event of the specification
   * @return null if it is explained, else why not; the states then stay as before the event
   * @throws NotCovered if more states explain the log than can be followed, or if the
   *     specification cannot be evaluated for this event
   */
  Refusal observe(RecordValue event) {
    try {
      return observed(event);
    } catch (NotCovered e) {
      throw e;
    } catch (RuntimeException e) {
      throw NotCovered.because("at the event \"" + spec.name(event) + "\"", e);
    }
  }

  /** Whether definite facts alone count now: the log leaves much out, or too many states explained it. */
  boolean loosened() {
    return loosened;
  }

  /** Whether the log leaves kinds of event out. */
  boolean partial() {
    return partial;
  }

  /** Whether states were made fewer or smaller that allow at least as much. */
  boolean widened() {
    return widened;
  }

  /** The most states that explained the log at a time, those on the way to a line included. */
  int largest() {
    return largest;
  }

  /** How often a state was followed by a step of time, by a silent step or by a line. */
  long steps() {
    return steps;
  }

  private Refusal observed(RecordValue event) {
    judging = true;
    try {
      while (true) {
        try {
          return followed(event);
        } catch (TooMany e) {
          loosen(e);
        }
      }
    } finally {
      judging = false;
    }
  }

  /**
   * Goes on with definite facts, or with more states than before where all have to be followed; at last
   * with definite facts whatever the log.
   *
   * @throws NotCovered if there is nothing to give up
   */
  void loosen(TooMany why) {
    List<State> facts = facts(crowded ? spec::lastResort : spec::loosen);
    if (!facts.isEmpty()) {
      states = distinct(facts);
      loosened = true;
    } else if (!crowded) {
      most = MOST_STATES;
      crowded = true;
    } else {
      throw new NotCovered(why.getMessage());
    }
  }

  private List<State> facts(Function<State, List<State>> of) {
    List<State> facts = new ArrayList<>();
    for (State state : states) {
      facts.addAll(of.apply(state));
    }
    return facts;
  }

  private Refusal followed(RecordValue event) {
    List<State> alone = states.size() == 1 ? spec.alone(states.get(0), event) : List.of();
    if (!alone.isEmpty()) {
      steps++;
      return explained(alone, event);
    }
    List<State> stuck = new ArrayList<>();
    List<State> arrived = elapse(event, stuck);
    if (arrived.isEmpty()) {
      // Where OBs start and end unseen, every state goes on, round in circles.
      List<State> late =
          nearest(Contract.Failing.TOO_LATE, stuck.isEmpty() ? states : stuck, event);
      return refusal(Contract.Failing.TOO_LATE, late, late, event);
    }
    List<State> ready = meets() ? few(closure(few(arrived), event)) : closure(arrived, event);
    List<State> after = new ArrayList<>(ready.size());
    work(ready.size(), ready.size());
    for (State state : ready) {
      steps++;
      after.addAll(spec.observe(state, event));
      limit(after.size());
    }
    if (after.isEmpty()) {
      List<State> near = nearest(Contract.Failing.UNEXPLAINED, ready, event);
      return refusal(Contract.Failing.UNEXPLAINED, ready, near, event);
    }
    return explained(after, event);
  }

  private Refusal explained(List<State> after, RecordValue event) {
    limit(after.size());
    List<State> now = distinct(after, spec::keyAfterLine);
    if ((lines + 1) % NOW_AND_THEN == 0) {
      now = distinct(now.stream().map(this::smaller).toList());
    }
    states = few(now); // where it gives up, the line is still to come
    lines++;
    past.add(event);
    Object ob = spec.startedOb(event);
    if (ob != null && startedObs.add(ob)) {
      classes.add(spec.runningClass(states.get(0)));
    }
    return null;
  }

  private State smaller(State state) {
    List<State> small = spec.crowd(state);
    widened |= !small.isEmpty();
    return small.isEmpty() ? state : small.get(0);
  }

  /** These states; where there are many of them, those meet that can. */
  private List<State> few(List<State> from) {
    if (from.size() <= most()) {
      return from;
    }
    List<State> few = new ArrayList<>();
    for (List<State> group : places(from)) {
      few.addAll(meeting(group));
    }
    met(few.size());
    return distinct(few);
  }

  /** Whether states meet early, and on the way through a moment: it has been necessary before, and is told. */
  private boolean meets() {
    return crowded || widened;
  }

  /** So many states are left as they are. */
  private int most() {
    return lines - met < SOON && meets() ? Math.min(fewest, SOME_STATES) : fewest;
  }

  /** The states by the places where they can meet. */
  private Collection<List<State>> places(List<State> from) {
    Map<Long, List<State>> places = new LinkedHashMap<>();
    for (State state : from) {
      places.computeIfAbsent(spec.meetingPlace(state), place -> new ArrayList<>()).add(state);
    }
    return places.values();
  }

  /** The state that the states of a place become; themselves if they become none. */
  private List<State> meeting(List<State> group) {
    work(group.size() > 1 ? MEETING * group.size() : 0, Integer.MAX_VALUE);
    List<State> one = group.size() > 1 ? spec.meet(group) : List.of();
    widened |= !one.isEmpty();
    return one.isEmpty() ? group : List.of(smaller(one.get(0)));
  }

  private void met(int left) {
    met = lines;
    // Those that cannot meet are not asked again at once.
    fewest = Math.max(MANY_STATES, 2 * left);
  }

  /** The states after time has elapsed to the event; states that cannot get there go to {@code stuck}. */
  private List<State> elapse(Value event, List<State> stuck) {
    if (states.size() == 1 && spec.arrived(states.get(0), event)) {
      return states;
    }
    List<State> arrived = new ArrayList<>();
    var open = new ArrayDeque<State>(states);
    var seen = new HashSet<Long>();
    var circle = new Circle();
    while (!open.isEmpty()) {
      State state = open.poll();
      if (spec.arrived(state, event)) {
        arrived.add(state);
        continue;
      }
      steps++;
      work(1, open.size());
      List<State> next = spec.elapse(state, event);
      if (next.size() == 0) {
        stuck.add(state);
      }
      // A single state that goes on alone, the usual case, is not remembered: it may take millions
      // of steps.
      boolean alone = open.isEmpty() && next.size() == 1 && arrived.isEmpty();
      for (State each : next) {
        if (alone ? !circle.closes(each) : seen.add(spec.key(each))) {
          open.add(steps % NOW_AND_THEN == 0 ? smaller(each) : each);
        }
      }
      limit(open.size());
      if (seen.size() > MOST_STEPS) {
        throw new NotCovered("more than " + MOST_STEPS + " steps of time lead to the line");
      }
    }
    return distinct(arrived);
  }

  /**
   * Tells when a state that goes on alone comes back to where it was, in memory that does not grow:
   * it keeps one state of the past, of a later step each time that the number of steps has doubled.
   */
  private final class Circle {
    private long steps;
    private long kept;

    boolean closes(State state) {
      // Most circles are short, and most ways are no circle: the first steps need no key.
      if (++steps < MOST_STATES) {
        return false;
      }
      long key = spec.key(state);
      if (steps > MOST_STATES && key == kept) {
        return true;
      }
      if (steps == MOST_STATES || Long.bitCount(steps) == 1) {
        kept = key;
      }
      return false;
    }
  }

  /** The states {@code from}, and those to which silent steps lead just before the event. */
  List<State> closure(List<State> from, Value event) {
    return closure(from, event, Integer.MAX_VALUE);
  }

  /** As {@link #closure(List, Value)}; no further once there are more than {@code most}. */
  List<State> closure(List<State> from, Value event, int most) {
    List<State> closed = from;
    Set<Long> seen = null;
    int ahead = MANY_STATES;
    for (int i = 0; i < closed.size() && closed.size() <= most; i++) {
      State state = closed.get(i);
      if (!spec.stirs(state, event)) {
        continue;
      }
      steps++;
      work(1, closed.size());
      List<State> next = spec.silent(state, event);
      if (next.size() > 0 && seen == null) {
        closed = new ArrayList<>(closed);
        seen = new HashSet<>();
        for (State known : closed) {
          seen.add(spec.key(known));
        }
      }
      for (int k = 0; k < next.size(); k++) {
        if (seen.add(spec.key(next.get(k)))) {
          closed.add(next.get(k));
        }
      }
      if (seen != null && closed.size() > ahead && most == Integer.MAX_VALUE && meets()) {
        List<State> left = new ArrayList<>();
        i = meetOnTheWay(closed, i + 1, seen, left) - 1;
        closed = left;
        // Where what has met comes apart again, it is left so at last.
        ahead = 2 * Math.max(ahead, closed.size());
      }
      limit(closed.size());
    }
    return closed;
  }

  /**
   * Those meet that can, of states of which the first {@code followed} have been followed.
   *
   * @param seen the keys of all states so far
   * @param left gets the states, those first that have been followed
   * @return how many of them have been followed
   */
  private int meetOnTheWay(List<State> from, int followed, Set<Long> seen, List<State> left) {
    Set<Long> done = new HashSet<>();
    for (State state : from.subList(0, followed)) {
      done.add(spec.key(state));
    }
    Map<Long, State> open = new LinkedHashMap<>();
    for (List<State> group : places(from)) {
      for (State state : meeting(group)) {
        long key = spec.key(state);
        if (done.contains(key)) {
          left.add(state);
        } else {
          open.put(key, state);
        }
      }
    }
    seen.addAll(open.keySet());
    int before = left.size();
    left.addAll(open.values());
    met(left.size());
    return before;
  }

  /** The states that come nearest to the event, by the specification's own measure. */
  private List<State> nearest(Contract.Failing failing, List<State> from, Value event) {
    List<State> nearest = new ArrayList<>();
    int least = Integer.MAX_VALUE;
    for (State state : from) {
      int distance = spec.distance(failing, state, event);
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

  /** These states and the targets of silent steps, also of steps that the event does not need. */
  private List<State> withSilent(List<State> from) {
    List<State> all = new ArrayList<>(from);
    for (State state : from) {
      all.addAll(spec.silent(state, spec.noEvent()));
    }
    return all;
  }

  /**
   * The open questions whose letter the verdict depends on so far, not only its reasons; null if it may
   * depend on any.
   */
  Set<String> asked() {
    return refused ? asked : spec.asked();
  }

  private Refusal refusal(
      Contract.Failing failing, List<State> from, List<State> near, Value event) {
    refused = true;
    asked = spec.asked();
    Value lines = past.lines();
    var allowed = new TreeMap<String, Object>();
    for (State state : failing == Contract.Failing.TOO_LATE ? from : withSilent(from)) {
      for (Object e : spec.expected(failing, state, event)) {
        allowed.put(e.toString(), e);
      }
    }
    TreeSet<String> requirements = spec.requirements();
    for (State state : near) {
      for (Object id : spec.deciding(failing, state, event, lines)) {
        requirements.add((String) id);
      }
    }
    var situations = new LinkedHashMap<String, Fields>();
    var candidates = new LinkedHashSet<Guards.Failure>();
    for (State state : near.subList(0, Math.min(near.size(), MOST_NEAR))) {
      Fields situation = spec.situation(state);
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
        allowed.values(),
        requirements,
        from.size(),
        situations.values(),
        candidates);
  }

  /** None if they cannot be found: a report without candidates is better than no report. */
  private Set<Guards.Failure> failures(Contract.Failing failing, State state, Value event) {
    try {
      return spec.failures(failing, state, event);
    } catch (RuntimeException | StackOverflowError e) {
      return Set.of();
    }
  }

  private List<State> distinct(List<State> from) {
    return distinct(from, spec::key);
  }

  private static List<State> distinct(List<State> from, ToLongFunction<State> key) {
    if (from.size() < 2) {
      return from;
    }
    var seen = new HashMap<Long, State>();
    var distinct = new ArrayList<State>(from.size());
    for (State state : from) {
      State known = seen.putIfAbsent(key.applyAsLong(state), state);
      if (known == null) {
        distinct.add(state);
      } else {
        known.alsoBy(state);
      }
    }
    return distinct;
  }

  private void limit(int size) {
    largest = Math.max(largest, size);
    if (size > most) {
      throw new TooMany("more than " + most + " states explain the log");
    }
  }

  /**
   * Counts steps where so many states are followed. Hundreds of states are few, but not at each of thousands of lines:
   * then it is as with too many states.
   */
  private void work(int more, int among) {
    if (!judging || among < WIDE) {
      return;
    }
    work += more;
    long most = (crowded ? 2 : 1) * WORK + (long) WORK_OF_A_LINE * lines;
    if (work > most && !loosened) {
      throw new TooMany("following many states took more than " + most + " steps");
    }
  }
}
