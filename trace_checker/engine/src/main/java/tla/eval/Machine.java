package tla.eval;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

import tla.tree.OpDeclNode;
import tlc2.value.impl.FcnRcdValue;
import tlc2.value.impl.Value;

/** The variables of a specification in the current state and in the next one. */
final class Machine {
  /** The number of each variable. */
  final Map<OpDeclNode, Integer> numbers = new IdentityHashMap<>();

  final Value[] now;

  /** The values assigned so far; null elsewhere. */
  final Value[] next;

  final Marks marks = new Marks();

  final Asked asked = new Asked();

  /** The recording under way; null otherwise. */
  Recording recording;

  private final OpDeclNode[] variables;
  private List<State> found;

  /** The outcomes on the way to the current state. */
  private long[] before;

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
    load(state.values);
    before = state.outcomes;
  }

  /** Takes the first {@code values} as those of the current state. */
  void load(Value[] values) {
    Arrays.fill(next, null);
    System.arraycopy(values, 0, now, 0, now.length);
  }

  boolean isRecording() {
    return recording != null;
  }

  boolean member(Value element, Value set) {
    return recording == null ? Builtins.member(element, set) : recording.member(element, set);
  }

  boolean inDomain(Value function, Value x) {
    return recording != null && function instanceof FcnRcdValue f && f.intv == null
        ? recording.place(f, x) >= 0
        : Builtins.inDomain(function, x);
  }

  Value apply(Value function, Value x) {
    return recording != null && function instanceof FcnRcdValue f && f.intv == null
        ? f.values[recording.place(f, x)]
        : Builtins.apply(function, x);
  }

  boolean equal(Value a, Value b) {
    return recording == null ? Builtins.equal(a, b) : recording.equal(a, b);
  }

  /**
   * A next value of a variable: the object of the current one if they are equal, so that what was kept for it holds. All
   * values of a variable are of one type, so they can be compared.
   */
  Value next(int variable, Value value) {
    Value before = now[variable];
    return value == before || before == null || recording != null || !Builtins.equal(before, value) ? value : before;
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
    var state = new State(next.clone());
    state.outcomes = marks.pathAfter(before);
    found.add(state);
  }

  List<State> found() {
    return found;
  }
}
