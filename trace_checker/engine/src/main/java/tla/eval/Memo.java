package tla.eval;

import tlc2.value.impl.Value;

/** Remembers the value of an expression as long as the variables that it depends on have theirs. */
final class Memo implements Expr {
  private final Value[] state;
  private final int[] variables;
  private final Expr expr;
  private final Value[] last;
  private Value value;

  /**
   * @param state the values of all variables
   * @param variables the numbers of those on which the expression depends, at most
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
