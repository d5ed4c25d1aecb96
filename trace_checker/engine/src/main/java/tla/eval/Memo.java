package tla.eval;

import tlc2.value.impl.Value;

/** Keeps the value of an expression until a variable that it depends on has another value. */
final class Memo implements Expr {
  private final Value[] state;
  private final int[] variables;
  private final Expr expr;
  private final Value[] last;
  private Value value;

  /**
   * @param state the values of all variables
   * @param variables the numbers of all variables that the expression may depend on
   */
  Memo(Value[] state, int[] variables, Expr expr) {
    this.state = state;
    this.variables = variables;
    this.expr = expr;
    last = new Value[variables.length];
  }

  @Override
  public Value eval(Object[] frame) {
    if (value == null || !isSame()) {
      value = null;
      value = expr.eval(frame);
      for (int i = 0; i < variables.length; i++) {
        last[i] = state[variables[i]];
      }
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
