package tla.eval;

import tla.tree.FormalParamNode;
import tla.tree.OpApplNode;
import tla.tree.SemanticNode;
import tlc2.value.impl.SetEnumValue;
import tlc2.value.impl.Value;
import tlc2.value.impl.ValueVec;

/** Compiles the expressions that bind variables to the elements of sets. */
final class Quantifiers {
  /** A bound variable, given by its slot, and its set. */
  record Bound(int slot, Expr set) {}

  /** The work for an assignment to the bound variables; false to go no further. */
  interface Step {
    boolean at(Object[] frame);
  }

  private final Compiler compiler;

  Quantifiers(Compiler compiler) {
    this.compiler = compiler;
  }

  /** Binds the variables of {@code node}; {@code bounds} gets a slot and a set for each. */
  Scope bind(OpApplNode node, Scope scope, java.util.List<Bound> bounds) {
    Scope inner = scope;
    for (int i = 0; i < node.getBdedQuantBounds().length; i++) {
      if (node.isBdedQuantATuple()[i]) {
        throw new Unsupported("a tuple of bound variables");
      }
      Expr set = compiler.compile(node.getBdedQuantBounds()[i], scope);
      for (FormalParamNode variable : node.getBdedQuantSymbolLists()[i]) {
        int slot = scope.slots.take();
        bounds.add(new Bound(slot, set));
        inner = inner.with(variable, Scope.Binding.value(slot));
      }
    }
    return inner;
  }

  Expr compile(OpApplNode node, Scope scope) {
    var bounds = new java.util.ArrayList<Bound>();
    Scope inner = bind(node, scope, bounds);
    SemanticNode bodyNode = node.getArgs()[0];
    Expr body = compiler.compile(bodyNode, inner);
    Bound[] all = bounds.toArray(Bound[]::new);
    Bound only = all.length == 1 ? all[0] : null;
    String name = node.getOperator().getName();
    if (only == null && !name.equals("$BoundedExists") && !name.equals("$BoundedForall")
        && !name.equals("$SetOfAll")) {
      throw new Unsupported(name + " with several variables");
    }
    return switch (name) {
      case "$BoundedExists" -> some(all, body);
      case "$BoundedForall" -> {
        Step each = body::test;
        yield (Expr.Test) f -> each(all, 0, f, each);
      }
      case "$SetOfAll" -> f -> image(all, body, f);
      case "$SubsetOf" -> f -> subset(only, body, f);
      case "$BoundedChoose" -> f -> choose(only, body, f);
      case "$FcnConstructor" -> f -> function(only, body, f);
      default -> throw new Unsupported("the operator " + name);
    };
  }

  /** Whether {@code {x \\in S : P(x)}} has an element; the subset is not built. */
  Expr someInSubset(OpApplNode node, Scope scope) {
    var bounds = new java.util.ArrayList<Bound>();
    Scope inner = bind(node, scope, bounds);
    Expr body = compiler.compile(node.getArgs()[0], inner);
    return some(bounds.toArray(Bound[]::new), body);
  }

  private static Expr some(Bound[] all, Expr body) {
    Step none = f -> !body.test(f);
    return (Expr.Test) f -> !each(all, 0, f, none);
  }

  /** Takes the step for every assignment, until a step returns false. */
  static boolean each(Bound[] bounds, int from, Object[] frame, Step step) {
    if (from == bounds.length) {
      return step.at(frame);
    }
    Bound bound = bounds[from];
    ValueVec elements = Builtins.elements(bound.set.eval(frame));
    for (int i = 0; i < elements.size(); i++) {
      frame[bound.slot] = elements.elementAt(i);
      if (!each(bounds, from + 1, frame, step)) {
        return false;
      }
    }
    return true;
  }

  private static Value image(Bound[] bounds, Expr body, Object[] frame) {
    var values = new ValueVec();
    each(
        bounds,
        0,
        frame,
        f -> {
          values.addElement(body.eval(f));
          return true;
        });
    return new SetEnumValue(values, false);
  }

  private static Value subset(Bound bound, Expr body, Object[] frame) {
    Value set = bound.set.eval(frame);
    ValueVec elements = Builtins.elements(set);
    var kept = new ValueVec();
    for (int i = 0; i < elements.size(); i++) {
      frame[bound.slot] = elements.elementAt(i);
      if (body.test(frame)) {
        kept.addElement(elements.elementAt(i));
      }
    }
    // The same set stays the same object, so expressions that depend on it keep their values.
    return kept.size() == elements.size() ? set : new SetEnumValue(kept, true);
  }

  private static Value choose(Bound bound, Expr body, Object[] frame) {
    ValueVec elements = Builtins.elements(bound.set.eval(frame));
    for (int i = 0; i < elements.size(); i++) {
      frame[bound.slot] = elements.elementAt(i);
      if (body.test(frame)) {
        return elements.elementAt(i);
      }
    }
    throw new IllegalStateException("nothing to CHOOSE");
  }

  private static Value function(Bound bound, Expr body, Object[] frame) {
    Value domain = bound.set.eval(frame);
    ValueVec elements = Builtins.elements(domain);
    var values = new Value[elements.size()];
    for (int i = 0; i < values.length; i++) {
      frame[bound.slot] = elements.elementAt(i);
      values[i] = body.eval(frame);
    }
    return Builtins.function(domain, values);
  }
}
