package tla.spec;

import java.util.List;

import tla.eval.State;
import tlc2.value.impl.Value;

/**
 * Evaluates operators that the evaluator leaves to it. Every method is given what the evaluator has {@code found}, or
 * null, and throws a RuntimeException where it cannot evaluate the operator.
 */
public interface Interpreter {
  /** None: there is no value where the evaluator has none. */
  Interpreter NONE =
      new Interpreter() {
        @Override
        public boolean compares() {
          return false;
        }

        @Override
        public List<State> initial(String name, List<State> found) {
          throw nobody(name);
        }

        @Override
        public List<State> successors(String name, List<State> found, State state, Value... arguments) {
          throw nobody(name);
        }

        @Override
        public Value value(String name, Value found, State state, Value... arguments) {
          throw nobody(name);
        }

        private RuntimeException nobody(String name) {
          return new UnsupportedOperationException(name + " is beyond this engine: try --engine jvm");
        }
      };

  /** Whether it is asked for every operator, to be compared with the evaluator. */
  boolean compares();

  /** The states that satisfy the initial predicate {@code name}. */
  List<State> initial(String name, List<State> found);

  /** The successors of a state under the action {@code name}, applied to {@code arguments}. */
  List<State> successors(String name, List<State> found, State state, Value... arguments);

  /** The value of a state function or state predicate. */
  Value value(String name, Value found, State state, Value... arguments);
}
