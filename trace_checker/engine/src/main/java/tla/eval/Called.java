package tla.eval;

import tla.tree.FormalParamNode;
import tla.tree.OpDefNode;

/** An operator that is compiled once, when it is first called, and has a frame for each call. */
final class Called {
  private final Compiler compiler;
  private final OpDefNode operator;
  private final Scope.Slots slots = new Scope.Slots();
  private final boolean primed;
  private Expr body;

  Called(Compiler compiler, OpDefNode operator, boolean primed) {
    this.compiler = compiler;
    this.operator = operator;
    this.primed = primed;
  }

  Expr body() {
    if (body == null) {
      Scope scope = Scope.empty(slots, primed);
      for (FormalParamNode parameter : operator.getParams()) {
        scope = scope.with(parameter, Scope.Binding.argument(slots.take()));
      }
      body = compiler.compile(operator.getBody(), scope);
    }
    return body;
  }

  /** A frame whose first slots are for the parameters. */
  Object[] frame() {
    body();
    return new Object[slots.count()];
  }
}
