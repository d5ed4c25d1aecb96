package tla.eval;

import tlc2.value.impl.Value;

/** Keeps the value of an expression until a variable that it depends on has another value. */
final class Memo implements Expr {
  private final Marks marks;
  private final Value[] state;
  private final int[] variables;
  private final Expr expr;
  private final Value[] last;
  private Value value;
  private long[] outcomes;

  /**
   * @param marks the outcomes of its evaluation count each time that its value is asked for
   * @param state the values of all variables
   * @param variables the numbers of all variables that the expression may depend on
   */
  Memo(Marks marks, Value[] state, int[] variables, Expr expr) {
    this.marks = marks;
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
      value = expr.eval(frame);
      outcomes = marks.end(outer);
      for (int i = 0; i < variables.length; i++) {
        last[i] = state[variables[i]];
      }
    } else {
      marks.add(outcomes);
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
