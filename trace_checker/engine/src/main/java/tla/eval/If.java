package tla.eval;

import tlc2.value.impl.Value;

/** IF THEN ELSE. */
final class If implements Expr {
  private final Expr condition;
  private final Expr then;
  private final Expr otherwise;

  If(Expr... parts) {
    condition = parts[0];
    then = parts[1];
    otherwise = parts[2];
  }

  private Expr chosen(Object[] frame) {
    return condition.test(frame) ? then : otherwise;
  }

  @Override
  public Value eval(Object[] frame) {
    return chosen(frame).eval(frame);
  }

  @Override
  public boolean test(Object[] frame) {
    return chosen(frame).test(frame);
  }

  @Override
  public int number(Object[] frame) {
    return chosen(frame).number(frame);
  }
}
