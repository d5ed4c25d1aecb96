package tla.eval;

/** A comparison of two integers. */
final class Comparison implements Expr.Test {
  private final Machine machine;
  private final Operation comparison;
  private final Expr a;
  private final Expr b;

  Comparison(Machine machine, Operation comparison, Expr a, Expr b) {
    this.machine = machine;
    this.comparison = comparison;
    this.a = a;
    this.b = b;
  }

  @Override
  public boolean test(Object[] frame) {
    return machine.recording == null
        ? comparison.on(a.number(frame), b.number(frame)) != 0
        : machine.recording.compared(comparison, a.eval(frame), b.eval(frame));
  }
}
