package tla.eval;

import tlc2.value.impl.IntValue;
import tlc2.value.impl.Value;

/** An arithmetic operator applied to two integers. */
final class Arithmetic implements Expr.Num {
  private final Machine machine;
  private final Operation operation;
  private final Expr a;
  private final Expr b;

  Arithmetic(Machine machine, Operation operation, Expr a, Expr b) {
    this.machine = machine;
    this.operation = operation;
    this.a = a;
    this.b = b;
  }

  @Override
  public Value eval(Object[] frame) {
    return machine.recording == null
        ? IntValue.gen(number(frame))
        : machine.recording.computed(operation, a.eval(frame), b.eval(frame));
  }

  @Override
  public int number(Object[] frame) {
    return machine.recording == null
        ? operation.on(a.number(frame), b.number(frame))
        : ((IntValue) eval(frame)).val;
  }
}
