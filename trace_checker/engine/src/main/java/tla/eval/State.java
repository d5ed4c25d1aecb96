package tla.eval;

import tlc2.value.impl.Value;

/** A state of a specification: the values of its variables, in the order of their declarations. */
public final class State {
  final Value[] values;

  /** The shapes of the values ({@link Shapes}) and of all of them; null before they are known. */
  long[] shapes;

  long shape;

  /**
   * @param values the values of all variables; the array belongs to the state from now on
   */
  public State(Value... values) {
    this.values = values;
  }

  /** The value of the variable with this number. */
  public Value value(int variable) {
    return values[variable];
  }
}
