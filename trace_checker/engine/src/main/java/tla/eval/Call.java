package tla.eval;

import java.util.List;

/** A call of an operator. */
final class Call implements Expr.Via {
  /** An argument as the frame of the called operator has it: a value or a {@link Thunk}. */
  interface Argument {
    Object of(Object[] frame);
  }

  private final Called called;
  private final Argument[] arguments;

  Call(Called called, List<Argument> arguments) {
    this.called = called;
    this.arguments = arguments.toArray(Argument[]::new);
  }

  @Override
  public Object[] enter(Object[] frame) {
    Object[] its = called.frame();
    for (int i = 0; i < arguments.length; i++) {
      its[i] = arguments[i].of(frame);
    }
    return its;
  }

  @Override
  public Expr target() {
    return called.body();
  }
}
