package tla.eval;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

import tla2sany.semantic.OpDeclNode;
import tlc2.value.impl.Value;

/** The variables of a specification in the current state and in the next one. */
final class Machine {
  /** The number of each variable. */
  final Map<OpDeclNode, Integer> numbers = new IdentityHashMap<>();

  final Value[] now;

  /** The values assigned so far; null elsewhere. */
  final Value[] next;

  private final OpDeclNode[] variables;
  private List<State> found;

  Machine(OpDeclNode[] variables) {
    this.variables = variables;
    for (int i = 0; i < variables.length; i++) {
      numbers.put(variables[i], i);
    }
    now = new Value[variables.length];
    next = new Value[variables.length];
  }

  /** Takes {@code state} as the current one. */
  void load(State state) {
    Arrays.fill(next, null);
    System.arraycopy(state.values, 0, now, 0, now.length);
  }

  void begin() {
    found = new ArrayList<>(1);
  }

  /** Notes a successor: all variables are assigned. */
  void emit() {
    for (int i = 0; i < next.length; i++) {
      if (next[i] == null) {
        throw new IllegalStateException(variables[i].getName() + " is not assigned");
      }
    }
    found.add(new State(next.clone()));
  }

  List<State> found() {
    return found;
  }
}
