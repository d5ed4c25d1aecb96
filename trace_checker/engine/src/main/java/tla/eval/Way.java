package tla.eval;

import java.util.List;

import tlc2.value.impl.Value;

/**
 * A way from a state to others, made of evaluations of operators and of choices that depend on their
 * results alone.
 */
public interface Way {
  /**
   * The states at the end of the way.
   *
   * @param argument the value that the operators on the way are applied to
   */
  List<State> from(State state, Value argument);
}
