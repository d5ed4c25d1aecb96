package tla.eval;

import java.util.BitSet;
import java.util.List;

import tlc2.value.impl.Value;

/** A state of a specification: the values of its variables, in the order of their declarations. */
public final class State {
  final Value[] values;

  /** The shapes of the values ({@link Shapes}) and of all of them; null before they are known. */
  long[] shapes;

  long shape;

  /** The outcomes of {@link Marks} on the way to this state; null for none. */
  long[] outcomes;

  /**
   * @param values the values of all variables; the array belongs to the state from now on
   */
  public State(Value... values) {
    this.values = values;
  }

  /** This state follows another one by a step of which nothing is told. */
  public void follow(State before) {
    outcomes = before.outcomes;
  }

  /** Another way leads to this state as well: only the outcomes of both ways remain. */
  public void alsoBy(State other) {
    outcomes = Marks.common(outcomes, other.outcomes);
  }

  /** The outcomes of marked expressions that the ways to all these states have in common. */
  public static BitSet commonOutcomes(List<State> states) {
    long[] common = states.isEmpty() ? null : states.get(0).outcomes;
    for (State state : states) {
      common = Marks.common(common, state.outcomes);
    }
    return common == null ? new BitSet() : BitSet.valueOf(common);
  }

  /** The outcomes of marked expressions on the way to any of these states. */
  public static BitSet allOutcomes(List<State> states) {
    long[] all = null;
    for (State state : states) {
      all = Marks.union(all, state.outcomes);
    }
    return all == null ? new BitSet() : BitSet.valueOf(all);
  }

  /** The value of the variable with this number. */
  public Value value(int variable) {
    return values[variable];
  }
}
