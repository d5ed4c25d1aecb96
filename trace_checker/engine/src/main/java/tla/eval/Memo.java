package tla.eval;

import java.util.BitSet;

import tlc2.value.impl.Value;

/** Keeps the value of an expression until a variable that it depends on has another value. */
final class Memo implements Expr {
  private final Marks marks;
  private final Asked asked;
  private final Value[] state;
  private final int[] variables;
  private final Expr expr;
  private final Value[] last;
  private Value value;
  private Marks.Some outcomes;
  private BitSet asks;

  /**
   * @param marks the outcomes of its evaluation count each time that its value is asked for
   * @param asked what its evaluation asks counts each time as well
   * @param state the values of all variables
   * @param variables the numbers of all variables that the expression may depend on
   */
  Memo(Marks marks, Asked asked, Value[] state, int[] variables, Expr expr) {
    this.marks = marks;
    this.asked = asked;
    this.state = state;
    this.variables = variables;
    this.expr = expr;
    last = new Value[variables.length];
  }

  @Override
  public Value eval(Object[] frame) {
    if (value == null || !isSame()) {
      value = null;
      long[] outer = marks.begin();
      BitSet before = asked.begin();
      try {
        value = expr.eval(frame);
      } finally {
        outcomes = new Marks.Some(marks.end(outer));
        asks = asked.end(before);
      }
      for (int i = 0; i < variables.length; i++) {
        last[i] = state[variables[i]];
      }
    } else {
      marks.add(outcomes);
      asked.add(asks);
    }
    return value;
  }

  private boolean isSame() {
    for (int i = 0; i < variables.length; i++) {
      if (last[i] != state[variables[i]]) {
        return false;
      }
    }
    return true;
  }
}
