package tla.eval;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

import tla.tree.OpDeclNode;
import tlc2.value.impl.Value;
import util.UniqueString;

/**
 * Remembers evaluations of operators by the shape of their inputs, the state and one argument: what
 * differs between two inputs of one shape are times, and of those it knows how they decide.
 *
 * <p>An operator is recorded when a shape has come some times. A construct that the recording
 * does not know ends it; the shape is then evaluated as usual.
 */
final class Memory {
  /** The most shapes that are known; then all are forgotten. */
  private static final int MOST_SHAPES = 50_000;

  /** The most steps of recordings that are kept, some 60 MB with all that belongs to them. */
  private static final int MOST_STEPS = 1_000_000;

  /** A recording with few steps needs as much room as one with so many. */
  private static final int LEAST_STEPS = 100;

  private final Machine machine;
  private final Shapes shapes;
  private final boolean[] areTimes;
  private final Value[] inputs;
  private final int[] registers = new int[1 << 12];
  private final Trial trial = new Trial();
  private final Numbered<Remembered<Kept<Part>>> values = new Numbered<>();
  private final Numbered<Remembered<Kept<Next[]>>> successors = new Numbered<>();
  private long hits;
  private long steps;
  private Value argument;
  private long argumentShape;

  /** An operator with one parameter. */
  interface Operator {
    /** Another number for each operator. */
    long number();

    Value value(State state, Value... argument);

    List<State> successors(State state, Value... argument);
  }

  /** What an evaluation led to, and what it asked. */
  private static final class Kept<T> {
    final T outcome;
    final BitSet asks;

    /** The collection that has what it asked. */
    BitSet into;

    Kept(T outcome, BitSet asks) {
      this.outcome = outcome;
      this.asks = asks;
    }
  }

  /** A successor: the values that are not those of the state before, by their places, and the shapes of all. */
  private static final class Next {
    final int[] places;
    final Part[] values;
    final long[] shapes;
    final long shape;
    final long[] outcomes;

    /** The last union with outcomes, which are the same most times. */
    long[] before;

    long[] union;

    Next(int[] places, Part[] values, long[] shapes, long[] outcomes) {
      this.places = places;
      this.values = values;
      this.shapes = shapes;
      this.outcomes = outcomes;
      shape = all(shapes);
      union = outcomes;
    }

    long[] outcomesAfter(long[] outcomesBefore) {
      if (before != outcomesBefore) {
        before = outcomesBefore;
        union = Marks.union(before, outcomes);
      }
      return union;
    }
  }

  Memory(Machine machine, OpDeclNode[] variables, Set<String> times) {
    this.machine = machine;
    shapes = new Shapes(times);
    inputs = new Value[variables.length + 1];
    areTimes = new boolean[inputs.length];
    for (int i = 0; i < variables.length; i++) {
      areTimes[i] = shapes.areTimes(UniqueString.uniqueStringOf(variables[i].getName()));
    }
  }

  /** The value of a state function. */
  Value value(Operator operator, State state, Value of) {
    if (!trial.isOn()) {
      return operator.value(state, of);
    }
    Remembered<Kept<Part>> remembered = remembered(values, key(operator, state, of));
    Part known = outcome(remembered);
    if (known == null && remembered.worthRecording()) {
      record(remembered, (recording, s, argument) -> recording.part(operator.value(s, argument)));
      known = outcome(remembered);
    }
    if (known != null) {
      return known.built(registers, inputs);
    }
    return operator.value(state, of);
  }

  /** The successors of a state under an action. */
  List<State> successors(Operator operator, State state, Value of) {
    if (!trial.isOn()) {
      return operator.successors(state, of);
    }
    Remembered<Kept<Next[]>> remembered = remembered(successors, key(operator, state, of));
    Next[] known = outcome(remembered);
    if (known == null && remembered.worthRecording()) {
      record(remembered, (recording, s, argument) -> nexts(recording, operator.successors(s, argument)));
      known = outcome(remembered);
    }
    if (known == null) {
      return shaped(operator.successors(state, of), state);
    }
    var found = new State[known.length];
    for (int i = 0; i < found.length; i++) {
      found[i] = state(known[i], state);
    }
    return Arrays.asList(found);
  }

  long hits() {
    return hits;
  }

  private <T> Remembered<T> remembered(Numbered<Remembered<T>> all, long key) {
    Remembered<T> remembered = all.get(key);
    trial.found(remembered != null);
    if (remembered == null) {
      remembered = new Remembered<>();
      all.put(key, remembered);
    }
    return remembered;
  }

  private long key(Operator operator, State state, Value of) {
    if (values.size() + successors.size() > MOST_SHAPES || steps > MOST_STEPS) {
      values.clear();
      successors.clear();
      steps = 0;
    }
    if (state.shapes == null) {
      shape(state, null);
    }
    System.arraycopy(state.values, 0, inputs, 0, state.values.length);
    inputs[state.values.length] = of;
    if (of != argument) {
      argument = of;
      argumentShape = of instanceof Shaped shaped ? shaped.shape(shapes) : shapes.of(of, false);
    }
    return Hash.mix(Hash.mix(state.shape + operator.number()) + argumentShape);
  }

  /** These states, whose shapes are known: most of their values are those of the state before. */
  private List<State> shaped(List<State> found, State before) {
    for (State each : found) {
      if (each.shapes == null) {
        shape(each, before);
      }
    }
    return found;
  }

  private void shape(State state, State before) {
    state.shapes = new long[state.values.length];
    for (int i = 0; i < state.shapes.length; i++) {
      state.shapes[i] =
          before != null && state.values[i] == before.values[i]
              ? before.shapes[i]
              : shapes.of(state.values[i], areTimes[i]);
    }
    state.shape = all(state.shapes);
  }

  private static long all(long[] shapes) {
    long all = 0;
    for (long each : shapes) {
      all = Hash.mix(all + each);
    }
    return all;
  }

  private <T> T outcome(Remembered<Kept<T>> remembered) {
    try {
      Kept<T> known = remembered.outcome(inputs, registers);
      if (known == null) {
        return null;
      }
      hits++;
      if (known.into != machine.asked.collection()) {
        machine.asked.add(known.asks);
        known.into = machine.asked.collection();
      }
      return known.outcome;
    } catch (ArithmeticException e) {
      return null; // TLC has the last word about numbers that are too large.
    }
  }

  /** An evaluation in a state with recorded integers. */
  private interface Evaluation<T> {
    T in(Recording recording, State state, Value argument);
  }

  private <T> void record(Remembered<Kept<T>> remembered, Evaluation<T> evaluation) {
    var recording = new Recording(shapes);
    BitSet outer = machine.asked.begin();
    T outcome = null;
    try {
      var recorded = new Value[inputs.length];
      for (int i = 0; i < inputs.length; i++) {
        recorded[i] = recording.recorded(inputs[i], areTimes[i], i);
      }
      machine.recording = recording;
      int variables = inputs.length - 1;
      var state = new State(Arrays.copyOf(recorded, variables));
      outcome = evaluation.in(recording, state, recorded[variables]);
      steps += LEAST_STEPS + recording.steps().size();
    } catch (RuntimeException e) {
      outcome = null;
    } finally {
      machine.recording = null;
    }
    var kept = new Kept<T>(outcome, machine.asked.end(outer));
    if (outcome == null || !remembered.add(recording, kept)) {
      remembered.giveUp();
    }
  }

  private Next[] nexts(Recording recording, List<State> found) {
    var nexts = new Next[found.size()];
    for (int i = 0; i < nexts.length; i++) {
      Value[] values = found.get(i).values;
      int[] places = IntStream.range(0, values.length).filter(k -> recording.input(values[k]) != k).toArray();
      Part[] parts = IntStream.of(places).mapToObj(k -> recording.part(values[k])).toArray(Part[]::new);
      var its = new long[values.length];
      for (int k = 0; k < values.length; k++) {
        its[k] = shapes.of(values[k], areTimes[k]);
      }
      nexts[i] = new Next(places, parts, its, found.get(i).outcomes);
    }
    return nexts;
  }

  private State state(Next next, State before) {
    Value[] values = before.values.clone();
    for (int i = 0; i < next.places.length; i++) {
      values[next.places[i]] = next.values[i].built(registers, inputs);
    }
    var state = new State(values);
    state.shapes = next.shapes;
    state.shape = next.shape;
    state.outcomes = next.outcomesAfter(before.outcomes);
    return state;
  }
}
