package tla.eval;

import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.Map;

import tla2sany.semantic.OpDeclNode;
import tlc2.tool.StateVec;
import tlc2.tool.TLCState;
import tlc2.value.impl.Value;
import util.UniqueString;

/** The variables of a specification in the current state and in the next one. */
final class Machine {
  /** The number of each variable. */
  final Map<OpDeclNode, Integer> numbers = new IdentityHashMap<>();

  final Value[] now;

  /** The values assigned so far; null elsewhere. */
  final Value[] next;

  private final UniqueString[] names;
  private TLCState loaded;
  private StateVec found;

  Machine(OpDeclNode[] variables) {
    names = new UniqueString[variables.length];
    for (int i = 0; i < names.length; i++) {
      names[i] = variables[i].getName();
      numbers.put(variables[i], i);
    }
    now = new Value[names.length];
    next = new Value[names.length];
  }

  /** Takes {@code state} as the current one. */
  void load(TLCState state) {
    Arrays.fill(next, null);
    if (state == loaded) {
      return;
    }
    for (int i = 0; i < names.length; i++) {
      now[i] = (Value) state.lookup(names[i]);
    }
    loaded = state;
  }

  void begin() {
    found = new StateVec(1);
  }

  /** Notes a successor: all variables are assigned. */
  void emit() {
    TLCState state = loaded.createEmpty();
    for (int i = 0; i < names.length; i++) {
      if (next[i] == null) {
        throw new IllegalStateException(names[i] + " is not assigned");
      }
      state.bind(names[i], next[i]);
    }
    found.addElement(state);
  }

  StateVec found() {
    return found;
  }
}
