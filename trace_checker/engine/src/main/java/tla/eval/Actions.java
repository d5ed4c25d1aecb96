package tla.eval;

import java.util.ArrayList;

import tla.tree.ExprOrOpArgNode;
import tla.tree.LetInNode;
import tla.tree.OpApplNode;
import tla.tree.OpDeclNode;
import tla.tree.OpDefNode;
import tla.tree.SemanticNode;
import tlc2.value.impl.Value;
import tlc2.value.impl.ValueVec;

/**
 * Compiles actions to programs that find all successors. As in TLC, conjuncts are taken in their
 * order: the first that names a variable's next value assigns it, the others are tests.
 */
final class Actions {
  /** Finds all ways to satisfy an action and, for each, runs the part that comes after it. */
  interface Act {
    void run(Object[] frame);
  }

  private final Compiler compiler;
  private final Machine machine;
  private final boolean initial;

  /**
   * @param initial whether the actions are predicates of the first states, in which a variable itself
   *     stands for its next value
   */
  Actions(Compiler compiler, Machine machine, boolean initial) {
    this.compiler = compiler;
    this.machine = machine;
    this.initial = initial;
  }

  /**
   * @param then the part that comes after the action
   */
  Act compile(SemanticNode node, Scope scope, Act then) {
    if (initial || compiler.primes(node)) {
      if (node instanceof LetInNode let) {
        var lazy = new ArrayList<Integer>();
        Scope inner = compiler.let(let, scope, lazy);
        return entering(lazy, compile(let.getBody(), inner, then));
      }
      if (node instanceof OpApplNode apply) {
        return application(apply, scope, then);
      }
    }
    return test(node, scope, then);
  }

  private Act test(SemanticNode node, Scope scope, Act then) {
    Expr expr = compiler.compile(node, scope);
    return f -> {
      if (expr.test(f)) {
        then.run(f);
      }
    };
  }

  private static Act entering(ArrayList<Integer> lazy, Act body) {
    if (lazy.isEmpty()) {
      return body;
    }
    int[] slots = Entering.slots(lazy);
    return f -> {
      Entering.empty(slots, f);
      body.run(f);
    };
  }

  private Act application(OpApplNode node, Scope scope, Act then) {
    ExprOrOpArgNode[] x = node.getArgs();
    if (node.getOperator() instanceof OpDefNode operator && operator.isDefined()) {
      Scope.Binding local = scope.find(operator);
      if (local != null && local.operator == null) {
        return compile(local.node, local.scope, then);
      }
      var lazy = new ArrayList<Integer>();
      Scope inner = compiler.inlined(operator, x, scope, lazy);
      return machine.marks.underWay(operator, entering(lazy, compile(operator.getBody(), inner, then)));
    }
    return switch (node.getOperator().getName()) {
      case "$ConjList", "\\land" -> conjunction(x, scope, then);
      case "$DisjList", "\\lor" -> disjunction(x, scope, then);
      case "$IfThenElse" ->
          choice(compiler.compile(x[0], scope), compile(x[1], scope, then), compile(x[2], scope, then));
      case "$Case" -> cases(x, scope, then);
      case "$BoundedExists" -> some(node, scope, then);
      case "=>" -> choice(compiler.compile(x[0], scope), compile(x[1], scope, then), then);
      case "=" -> {
        int variable = primed(x[0]);
        yield variable < 0
            ? test(node, scope, then)
            : assign(variable, compiler.compile(x[1], scope), then);
      }
      case "\\in" -> {
        int variable = primed(x[0]);
        yield variable < 0
            ? test(node, scope, then)
            : assignAny(variable, compiler.compile(x[1], scope), then);
      }
      case "UNCHANGED" -> unchanged(x[0], scope, then);
      default -> test(node, scope, then);
    };
  }

  private Act conjunction(ExprOrOpArgNode[] conjuncts, Scope scope, Act then) {
    Act rest = then;
    for (int i = conjuncts.length - 1; i >= 0; i--) {
      rest = compile(conjuncts[i], scope, rest);
    }
    return rest;
  }

  private Act disjunction(ExprOrOpArgNode[] disjuncts, Scope scope, Act then) {
    var acts = new Act[disjuncts.length];
    for (int i = 0; i < acts.length; i++) {
      acts[i] = compile(disjuncts[i], scope, then);
    }
    return f -> {
      for (Act act : acts) {
        act.run(f);
      }
    };
  }

  private static Act choice(Expr condition, Act then, Act otherwise) {
    return f -> (condition.test(f) ? then : otherwise).run(f);
  }

  private Act cases(ExprOrOpArgNode[] arms, Scope scope, Act then) {
    Act chain =
        f -> {
          throw new IllegalStateException("no CASE holds");
        };
    for (int i = arms.length - 1; i >= 0; i--) {
      ExprOrOpArgNode[] arm = ((OpApplNode) arms[i]).getArgs();
      Act act = compile(arm[1], scope, then);
      chain = arm[0] == null ? act : choice(compiler.compile(arm[0], scope), act, chain);
    }
    return chain;
  }

  private Act some(OpApplNode node, Scope scope, Act then) {
    var bounds = new ArrayList<Quantifiers.Bound>();
    Scope inner = new Quantifiers(compiler).bind(node, scope, bounds);
    Act body = compile(node.getArgs()[0], inner, then);
    var all = bounds.toArray(Quantifiers.Bound[]::new);
    Quantifiers.Step each =
        f -> {
          body.run(f);
          return true;
        };
    return f -> Quantifiers.each(all, 0, f, each);
  }

  /** The number of the variable if the expression is a variable's next value, else -1. */
  private int primed(SemanticNode node) {
    if (initial) {
      return node instanceof OpApplNode apply && apply.getOperator() instanceof OpDeclNode variable
          ? machine.numbers.get(variable)
          : -1;
    }
    if (node instanceof OpApplNode prime
        && prime.getOperator().getName().equals("'")
        && prime.getArgs()[0] instanceof OpApplNode inner
        && inner.getOperator() instanceof OpDeclNode variable) {
      return machine.numbers.get(variable);
    }
    return -1;
  }

  private Act assign(int variable, Expr expr, Act then) {
    Value[] next = machine.next;
    return f -> {
      Value value = expr.eval(f);
      if (next[variable] == null) {
        next[variable] = machine.next(variable, value);
        then.run(f);
        next[variable] = null;
      } else if (machine.equal(next[variable], value)) {
        then.run(f);
      }
    };
  }

  private Act assignAny(int variable, Expr set, Act then) {
    Value[] next = machine.next;
    return f -> {
      Value values = set.eval(f);
      if (next[variable] != null) {
        if (Builtins.member(next[variable], values)) {
          then.run(f);
        }
        return;
      }
      ValueVec elements = Builtins.elements(values);
      for (int i = 0; i < elements.size(); i++) {
        next[variable] = elements.elementAt(i);
        then.run(f);
      }
      next[variable] = null;
    };
  }

  /** A variable, a tuple, or an operator that stands for one of the two. */
  private Act unchanged(SemanticNode node, Scope scope, Act then) {
    if (node instanceof OpApplNode apply) {
      if (apply.getOperator() instanceof OpDeclNode variable) {
        int number = machine.numbers.get(variable);
        return assign(number, f -> machine.now[number], then);
      }
      if (apply.getOperator().getName().equals("$Tuple")) {
        Act rest = then;
        for (int i = apply.getArgs().length - 1; i >= 0; i--) {
          rest = unchanged(apply.getArgs()[i], scope, rest);
        }
        return rest;
      }
      if (apply.getOperator() instanceof OpDefNode operator
          && operator.isDefined()
          && operator.getParams().length == 0) {
        return unchanged(operator.getBody(), scope, then);
      }
    }
    throw new Unsupported("UNCHANGED of something else than variables");
  }
}
