package tla.eval;

import tla.tree.ExprNode;
import tla.tree.OpDefNode;

/** The names at a place of the specification and their meaning, while it is compiled. */
final class Scope {
  /** The size of a frame, growing while its expressions are compiled. */
  static final class Slots {
    private int count;

    int take() {
      return count++;
    }

    int count() {
      return count;
    }
  }

  /**
   * The meaning of a name: a value in a slot; an expression, evaluated when it is first needed and
   * then kept in a slot, or (slot -1) evaluated every time; or an operator.
   */
  static final class Binding {
    final int slot;
    /** Whether the slot may hold a {@link Thunk}. */
    final boolean maybeThunk;
    final ExprNode node;
    final OpDefNode operator;
    /** Where the expression or operator was written. */
    final Scope scope;
    /** The compiled expression; null before it is compiled. */
    Expr compiled;

    private Binding(int slot, boolean maybeThunk, ExprNode node, OpDefNode operator, Scope scope) {
      this.slot = slot;
      this.maybeThunk = maybeThunk;
      this.node = node;
      this.operator = operator;
      this.scope = scope;
    }

    static Binding value(int slot) {
      return new Binding(slot, false, null, null, null);
    }

    static Binding argument(int slot) {
      return new Binding(slot, true, null, null, null);
    }

    static Binding lazy(int slot, ExprNode node, Scope scope) {
      return new Binding(slot, false, node, null, scope);
    }

    static Binding everyTime(ExprNode node, Scope scope) {
      return new Binding(-1, false, node, null, scope);
    }

    static Binding operator(OpDefNode operator, Scope scope) {
      return new Binding(-1, false, null, operator, scope);
    }
  }

  private final Object name;
  private final Binding binding;
  private final Scope outer;
  final Slots slots;
  /** Whether variables stand for their values in the next state. */
  final boolean primed;

  private Scope(Object name, Binding binding, Scope outer, Slots slots, boolean primed) {
    this.name = name;
    this.binding = binding;
    this.outer = outer;
    this.slots = slots;
    this.primed = primed;
  }

  /** A scope without names, for expressions in a frame. */
  static Scope empty(Slots slots, boolean primed) {
    return new Scope(null, null, null, slots, primed);
  }

  Scope with(Object name, Binding binding) {
    return new Scope(name, binding, this, slots, primed);
  }

  Scope primed(boolean primed) {
    return primed == this.primed ? this : new Scope(name, binding, outer, slots, primed);
  }

  /** Null if the name is not bound here. */
  Binding find(Object name) {
    for (Scope scope = this; scope != null; scope = scope.outer) {
      if (scope.name == name) {
        return scope.binding;
      }
    }
    return null;
  }
}
