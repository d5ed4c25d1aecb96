package tla.eval;

import tlc2.value.impl.Value;

/** An argument that is evaluated when it is first needed. */
final class Thunk {
  private final Expr expr;
  private final Object[] frame;
  private Value value;

  Thunk(Expr expr, Object[] frame) {
    this.expr = expr;
    this.frame = frame;
  }

  Value force() {
    if (value == null) {
      value = expr.eval(frame);
    }
    return value;
  }
}
