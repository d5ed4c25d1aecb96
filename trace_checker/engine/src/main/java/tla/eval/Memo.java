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
   * @param marks the outcomes of its evaluation count each time that its value is asked for; null if it has none
   * @param asked what its evaluation asks counts each time as well; null if that is nothing
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
      value = evaluated(frame);
      for (int i = 0; i < variables.length; i++) {
        last[i] = state[variables[i]];
      }
      return value;
    }
    if (marks != null) {
      marks.add(outcomes);
    }
    if (asked != null) {
      asked.add(asks);
    }
    return value;
  }

  private Value evaluated(Object[] frame) {
    if (asked == null) {
      return collecting(frame);
    }
    BitSet before = asked.begin();
    try {
      return collecting(frame);
    } finally {
      asks = asked.end(before);
    }
  }

  private Value collecting(Object[] frame) {
    if (marks == null) {
      return expr.eval(frame);
    }
    // Where an error ends the evaluation, the next one begins anew.
    marks.begin();
    Value evaluated = expr.eval(frame);
    outcomes = marks.end();
    return evaluated;
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
