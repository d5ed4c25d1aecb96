package tla.eval;

import tla.tree.ExprOrOpArgNode;
import tla.tree.OpApplNode;
import tlc2.value.impl.Value;

/** {@code [f EXCEPT ![x].y = z, ...]}: the changes one after the other. */
final class Except implements Expr {
  private final Expr function;
  private final Change[] changes;

  /** The path, the new value, and the slot of the old value, which {@code @} reads. */
  private record Change(Expr[] path, Expr value, int old) {}

  Except(Compiler compiler, OpApplNode node, Scope scope) {
    ExprOrOpArgNode[] parts = node.getArgs();
    function = compiler.compile(parts[0], scope);
    changes = new Change[parts.length - 1];
    for (int i = 0; i < changes.length; i++) {
      var part = (OpApplNode) parts[i + 1];
      Expr[] path = compiler.compile(((OpApplNode) part.getArgs()[0]).getArgs(), scope);
      int old = scope.slots.take();
      Scope inner = scope.with(part, Scope.Binding.value(old));
      changes[i] = new Change(path, compiler.compile(part.getArgs()[1], inner), old);
    }
  }

  @Override
  public Value eval(Object[] frame) {
    Value result = function.eval(frame);
    for (Change change : changes) {
      result = changed(result, change, 0, frame);
    }
    return result;
  }

  private static Value changed(Value from, Change change, int depth, Object[] frame) {
    if (depth == change.path.length) {
      frame[change.old] = from;
      return change.value.eval(frame);
    }
    Value x = change.path[depth].eval(frame);
    Value inner = changed(Builtins.apply(from, x), change, depth + 1, frame);
    return Builtins.except(from, x, inner);
  }
}
