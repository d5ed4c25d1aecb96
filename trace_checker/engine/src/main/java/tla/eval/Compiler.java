package tla.eval;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import tla.tree.AtNode;
import tla.tree.ExprNode;
import tla.tree.ExprOrOpArgNode;
import tla.tree.FormalParamNode;
import tla.tree.LetInNode;
import tla.tree.NumeralNode;
import tla.tree.OpApplNode;
import tla.tree.OpDeclNode;
import tla.tree.OpDefNode;
import tla.tree.OtherNode;
import tla.tree.SemanticNode;
import tla.tree.StringNode;
import tla.tree.SymbolNode;
import tlc2.value.impl.BoolValue;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.IntervalValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.SetEnumValue;
import tlc2.value.impl.StringValue;
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;
import util.UniqueString;

/** Compiles expressions: SANY's semantic graph to {@link Expr}. */
final class Compiler {
  /** Larger operators are compiled once and called; smaller ones are written out. */
  private static final int LARGEST_INLINE = 60;

  /** Smaller expressions are not worth remembering. */
  private static final int LEAST_MEMO = 4;

  private final Machine machine;
  private final Facts.Collector facts;
  private final Map<Shared, Expr> memos = new HashMap<>();
  private final Map<OpDefNode, Memo.Values> values = new HashMap<>();
  private final Map<Shared, Called> calls = new HashMap<>();

  /** An operator in the current state or in the next one. */
  private record Shared(OpDefNode operator, boolean primed) {}

  Compiler(Machine machine) {
    this.machine = machine;
    facts = new Facts.Collector(machine.numbers, machine.asked);
  }

  boolean primes(SemanticNode node) {
    return facts.of(node).primes;
  }

  /**
   * Compiles an expression. An expression that depends on nothing is evaluated once. An expression
   * that depends on variables alone is evaluated again only when a variable has another value, if
   * its size makes that worthwhile.
   */
  Expr compile(SemanticNode node, Scope scope) {
    return machine.marks.telling(node, silent(node, scope));
  }

  /** The expression as if it were not marked. */
  private Expr silent(SemanticNode node, Scope scope) {
    if (!(node instanceof OpApplNode apply)) {
      return plain(node, scope);
    }
    Facts its = facts.of(node);
    if (!its.closed() || apply.getOperator() instanceof OpDeclNode) {
      return plain(node, scope);
    }
    boolean definition =
        apply.getOperator() instanceof OpDefNode operator && operator.isDefined();
    if (its.constant() || its.size >= LEAST_MEMO && (definition || its.variables.cardinality() == 1)) {
      if (definition && apply.getArgs().length == 0) {
        var key = new Shared((OpDefNode) apply.getOperator(), scope.primed);
        Expr known = memos.get(key);
        if (known == null) {
          known = memo(its, node, scope.primed, values.computeIfAbsent(key.operator, k -> new Memo.Values()));
          memos.put(key, known);
        }
        return known;
      }
      return memo(its, node, scope.primed, new Memo.Values());
    }
    return plain(node, scope);
  }

  private Expr memo(Facts its, SemanticNode node, boolean primed, Memo.Values values) {
    var slots = new Scope.Slots();
    Expr body = plain(node, Scope.empty(slots, primed));
    return new Memo(
        its.marked && machine.marks.isSet() ? machine.marks : null,
        its.asks ? machine.asked : null,
        primed ? machine.next : machine.now,
        its.variables.stream().toArray(),
        f -> body.eval(new Object[slots.count()]),
        values);
  }

  private Expr plain(SemanticNode node, Scope scope) {
    if (node instanceof NumeralNode numeral) {
      return constant(IntValue.gen(numeral.val()));
    }
    if (node instanceof StringNode string) {
      return constant(new StringValue(string.getRep()));
    }
    if (node instanceof AtNode at) {
      int slot = scope.find(at.getExceptComponentRef()).slot;
      return f -> (Value) f[slot];
    }
    if (node instanceof LetInNode let) {
      var lazy = new ArrayList<Integer>();
      Scope inner = let(let, scope, lazy);
      return Entering.of(lazy, compile(let.getBody(), inner));
    }
    if (node instanceof OpApplNode apply) {
      Expr made = application(apply, scope);
      return machine.asked.isWatched(apply.getOperator()) ? noting(apply, made, scope) : made;
    }
    String kind = node instanceof OtherNode other ? other.kind() : node.getClass().getSimpleName();
    throw new Unsupported("an expression of the kind " + kind);
  }

  /** An application that tells its last argument. */
  private Expr noting(OpApplNode apply, Expr made, Scope scope) {
    ExprOrOpArgNode[] arguments = apply.getArgs();
    Expr string = compile(arguments[arguments.length - 1], scope);
    return f -> {
      machine.asked.note(string.eval(f));
      return made.eval(f);
    };
  }

  private static Expr constant(Value value) {
    return f -> value;
  }

  /** The scope of a LET's body; {@code lazy} gets the slots that must be empty before it. */
  Scope let(LetInNode let, Scope scope, List<Integer> lazy) {
    Scope inner = scope;
    for (OpDefNode definition : let.getLets()) {
      if (definition.getParams().length > 0) {
        inner = inner.with(definition, Scope.Binding.operator(definition, inner));
      } else {
        inner = inner.with(definition, delayed(definition.getBody(), inner, lazy));
      }
    }
    return inner;
  }

  /** A binding to an expression that is evaluated when it is needed. */
  Scope.Binding delayed(ExprNode node, Scope scope, List<Integer> lazy) {
    // The next state changes while successors are looked for.
    if (isTrivial(node) || primes(node)) {
      return Scope.Binding.everyTime(node, scope);
    }
    int slot = scope.slots.take();
    lazy.add(slot);
    return Scope.Binding.lazy(slot, node, scope);
  }

  /** Whether evaluating it again is as cheap as keeping its value. */
  private boolean isTrivial(SemanticNode node) {
    if (node instanceof OpApplNode apply) {
      SymbolNode operator = apply.getOperator();
      return operator instanceof FormalParamNode
          || operator instanceof OpDeclNode
          || operator.getName().equals("$RcdSelect") && isTrivial(apply.getArgs()[0]);
    }
    return node instanceof NumeralNode || node instanceof StringNode;
  }

  /** The scope of an operator's body that is written out at this place. */
  Scope inlined(OpDefNode operator, ExprOrOpArgNode[] arguments, Scope scope, List<Integer> lazy) {
    Scope.Binding local = scope.find(operator);
    Scope inner =
        local == null ? Scope.empty(scope.slots, scope.primed) : local.scope.primed(scope.primed);
    FormalParamNode[] parameters = operator.getParams();
    for (int i = 0; i < parameters.length; i++) {
      if (!(arguments[i] instanceof ExprNode argument)) {
        throw new Unsupported("an operator as argument of " + operator.getName());
      }
      inner = inner.with(parameters[i], delayed(argument, scope, lazy));
    }
    return inner;
  }

  private Expr reference(Object name, Scope scope) {
    Scope.Binding binding = scope.find(name);
    if (binding == null) {
      throw new Unsupported("a name that is not bound");
    }
    int slot = binding.slot;
    if (binding.operator != null) {
      throw new Unsupported("an operator as a value");
    }
    if (binding.node == null) {
      return binding.maybeThunk
          ? f -> {
            Object value = f[slot];
            if (value instanceof Thunk thunk) {
              value = thunk.force();
              f[slot] = value;
            }
            return (Value) value;
          }
          : f -> (Value) f[slot];
    }
    Facts its = facts.of(binding.node);
    boolean otherState = scope.primed != binding.scope.primed && !its.constant();
    if (slot < 0 || otherState) {
      return compile(binding.node, binding.scope.primed(scope.primed));
    }
    if (binding.compiled == null) {
      binding.compiled = compile(binding.node, binding.scope);
    }
    Expr expr = binding.compiled;
    return f -> {
      Object value = f[slot];
      if (value == null) {
        value = expr.eval(f);
        f[slot] = value;
      }
      return (Value) value;
    };
  }

  private Expr application(OpApplNode node, Scope scope) {
    SymbolNode operator = node.getOperator();
    if (operator instanceof OpDeclNode variable) {
      Integer number = machine.numbers.get(variable);
      if (number == null) {
        throw new Unsupported("the constant " + variable.getName());
      }
      return variable(number, scope.primed);
    }
    if (operator instanceof FormalParamNode) {
      return reference(operator, scope);
    }
    if (operator instanceof OpDefNode definition && definition.isDefined()) {
      Scope.Binding local = scope.find(definition);
      if (local != null && local.operator == null) {
        return reference(definition, scope);
      }
      return definition(definition, node.getArgs(), scope);
    }
    if (node.getBdedQuantBounds() != null && node.getBdedQuantBounds().length > 0) {
      return new Quantifiers(this).compile(node, scope);
    }
    return builtin(operator.getName(), node, scope);
  }

  private Expr variable(int number, boolean primed) {
    Value[] state = primed ? machine.next : machine.now;
    return f -> {
      Value value = state[number];
      if (value == null) {
        throw new IllegalStateException("a variable without a value");
      }
      return value;
    };
  }

  private Expr definition(OpDefNode operator, ExprOrOpArgNode[] arguments, Scope scope) {
    Facts its = facts.of(operator.getBody());
    boolean local = scope.find(operator) != null;
    if (local || its.primes || its.size <= LARGEST_INLINE) {
      var lazy = new ArrayList<Integer>();
      Scope inner = inlined(operator, arguments, scope, lazy);
      return Entering.of(lazy, compile(operator.getBody(), inner));
    }
    var key = new Shared(operator, scope.primed);
    Called called = calls.computeIfAbsent(key, k -> new Called(this, operator, scope.primed));
    return new Call(called, Arrays.stream(arguments).map(a -> argument(a, scope)).toList());
  }

  /** Compiles an argument of a called operator. */
  private Call.Argument argument(ExprOrOpArgNode node, Scope scope) {
    Expr expr = compile(node, scope);
    if (node instanceof NumeralNode || node instanceof StringNode || isKnown(node, scope)) {
      return expr::eval;
    }
    return f -> new Thunk(expr, f);
  }

  /** Whether the value is certainly at hand. */
  private static boolean isKnown(SemanticNode node, Scope scope) {
    if (!(node instanceof OpApplNode apply)) {
      return false;
    }
    if (apply.getOperator() instanceof OpDeclNode) {
      return !scope.primed;
    }
    Scope.Binding binding = scope.find(apply.getOperator());
    return binding != null && binding.node == null && !binding.maybeThunk;
  }

  Expr[] compile(SemanticNode[] nodes, Scope scope) {
    return Arrays.stream(nodes).map(node -> compile(node, scope)).toArray(Expr[]::new);
  }

  private Expr builtin(String name, OpApplNode node, Scope scope) {
    switch (name) {
      case "$IfThenElse":
        return new If(compile(node.getArgs(), scope));
      case "$Case":
        return choice(node, scope);
      case "$RcdConstructor":
        return record(node, scope);
      case "$Except":
        return new Except(this, node, scope);
      case "\\in":
        return member(node.getArgs()[0], node.getArgs()[1], scope);
      case "\\notin":
        Expr in = member(node.getArgs()[0], node.getArgs()[1], scope);
        return (Expr.Test) f -> !in.test(f);
      case "'":
        if (scope.primed) {
          throw new Unsupported("a primed expression that is primed");
        }
        return compile(node.getArgs()[0], scope.primed(true));
      case "ENABLED":
        return enabled(node.getArgs()[0], scope);
      case "=":
        return equality(node.getArgs(), scope);
      case "/=", "#":
        Expr equal = equality(node.getArgs(), scope);
        return (Expr.Test) f -> !equal.test(f);
      default:
        return simple(name, node, compile(node.getArgs(), scope));
    }
  }

  /** Whether an action has a successor; the next state that is under way stays as it is. */
  private Expr enabled(SemanticNode action, Scope scope) {
    if (scope.primed) {
      throw new Unsupported("ENABLED in the next state");
    }
    var found = new boolean[1];
    Actions.Act act = new Actions(this, machine, false).compile(action, scope, f -> found[0] = true);
    return (Expr.Test)
        f -> {
          Value[] underWay = machine.next.clone();
          Arrays.fill(machine.next, null);
          found[0] = false;
          act.run(f);
          System.arraycopy(underWay, 0, machine.next, 0, underWay.length);
          return found[0];
        };
  }

  /** The operators that evaluate their operands and no more. */
  private Expr simple(String name, OpApplNode node, Expr[] x) {
    Expr a = x.length > 0 ? x[0] : null;
    Expr b = x.length > 1 ? x[1] : null;
    return switch (name) {
      case "TRUE" -> (Expr.Test) f -> true;
      case "FALSE" -> (Expr.Test) f -> false;
      case "BOOLEAN" -> constant(booleans());
      case "\\lnot" -> (Expr.Test) f -> !a.test(f);
      case "=>" -> (Expr.Test) f -> !a.test(f) || b.test(f);
      case "\\equiv" -> (Expr.Test) f -> a.test(f) == b.test(f);
      case "\\land", "$ConjList" -> all(x);
      case "\\lor", "$DisjList" -> any(x);
      case "+" -> new Arithmetic(machine, Operation.ADD, a, b);
      case "-" -> new Arithmetic(machine, Operation.SUBTRACT, a, b);
      case "*" -> new Arithmetic(machine, Operation.MULTIPLY, a, b);
      case "-." -> new Arithmetic(machine, Operation.SUBTRACT, constant(IntValue.gen(0)), a);
      case "\\div" -> new Arithmetic(machine, Operation.DIVIDE, a, b);
      case "%" -> new Arithmetic(machine, Operation.MODULO, a, b);
      case "<" -> new Comparison(machine, Operation.LESS, a, b);
      case "\\leq", "<=", "=<" -> new Comparison(machine, Operation.LESS_OR_EQUAL, a, b);
      case ">" -> new Comparison(machine, Operation.LESS, b, a);
      case "\\geq", ">=" -> new Comparison(machine, Operation.LESS_OR_EQUAL, b, a);
      case ".." -> f -> new IntervalValue(a.number(f), b.number(f));
      case "\\subseteq" -> (Expr.Test) f -> Builtins.subset(a.eval(f), b.eval(f));
      case "\\union", "\\cup" -> f -> Builtins.cup(a.eval(f), b.eval(f));
      case "\\intersect", "\\cap" -> f -> Builtins.cap(a.eval(f), b.eval(f));
      case "\\" -> f -> Builtins.minus(a.eval(f), b.eval(f));
      case "UNION" -> f -> Builtins.union(a.eval(f));
      case "SUBSET" -> f -> Builtins.powerset(a.eval(f));
      case "DOMAIN" -> f -> Builtins.domain(a.eval(f));
      case "$SetEnumerate" -> f -> new SetEnumValue(values(x, f), false);
      case "$Tuple" -> f -> new TupleValue(values(x, f));
      case "$FcnApply" -> f -> machine.apply(a.eval(f), b.eval(f));
      case "$RcdSelect" -> new Field(a, ((StringNode) node.getArgs()[1]).getRep());
      case "Cardinality" -> (Expr.Num) f -> Builtins.cardinality(a.eval(f));
      case "Len" -> (Expr.Num) f -> Builtins.tuple(a.eval(f)).elems.length;
      case "Append" -> f -> Builtins.append(a.eval(f), b.eval(f));
      case "\\o" -> f -> Builtins.concatenation(a.eval(f), b.eval(f));
      case "Head" -> f -> Builtins.tuple(a.eval(f)).elems[0];
      case "SubSeq" -> f -> Builtins.section(a.eval(f), b.number(f), x[2].number(f));
      default -> throw new Unsupported("the operator " + name);
    };
  }

  private static Value booleans() {
    return new SetEnumValue(new Value[] {BoolValue.ValFalse, BoolValue.ValTrue}, false);
  }

  static Value[] values(Expr[] exprs, Object[] frame) {
    var values = new Value[exprs.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = exprs[i].eval(frame);
    }
    return values;
  }

  private static Expr.Test all(Expr[] x) {
    return f -> {
      for (Expr each : x) {
        if (!each.test(f)) {
          return false;
        }
      }
      return true;
    };
  }

  private static Expr.Test any(Expr[] x) {
    return f -> {
      for (Expr each : x) {
        if (each.test(f)) {
          return true;
        }
      }
      return false;
    };
  }

  /** CASE as a chain of IFs; it has no value if no case holds. */
  private Expr choice(OpApplNode node, Scope scope) {
    ExprOrOpArgNode[] arms = node.getArgs();
    Expr chain =
        f -> {
          throw new IllegalStateException("no CASE holds");
        };
    for (int i = arms.length - 1; i >= 0; i--) {
      ExprOrOpArgNode[] arm = ((OpApplNode) arms[i]).getArgs();
      Expr then = compile(arm[1], scope);
      chain = arm[0] == null ? then : new If(compile(arm[0], scope), then, chain);
    }
    return chain;
  }

  private Expr record(OpApplNode node, Scope scope) {
    int n = node.getArgs().length;
    var names = new UniqueString[n];
    var places = new Value[n];
    var exprs = new Expr[n];
    for (int i = 0; i < n; i++) {
      ExprOrOpArgNode[] pair = ((OpApplNode) node.getArgs()[i]).getArgs();
      names[i] = ((StringNode) pair[0]).getRep();
      places[i] = IntValue.gen(i);
      exprs[i] = compile(pair[1], scope);
    }
    // TLC keeps the fields of a record in its own order: it sorts the names once, here.
    var sorted = new RecordValue(names, places, false);
    sorted.normalize();
    var inOrder = new Expr[n];
    for (int i = 0; i < n; i++) {
      inOrder[i] = exprs[((IntValue) sorted.values[i]).val];
    }
    return f -> new RecordValue(sorted.names, values(inOrder, f), true);
  }

  private Expr equality(ExprOrOpArgNode[] operands, Scope scope) {
    for (int i = 0; i < 2; i++) {
      if (isEmptySet(operands[i])) {
        return empty(operands[1 - i], scope);
      }
    }
    Expr a = compile(operands[0], scope);
    Expr b = compile(operands[1], scope);
    if (a instanceof Expr.Num && b instanceof Expr.Num) {
      return new Comparison(machine, Operation.EQUAL, a, b);
    }
    return (Expr.Test) f -> machine.equal(a.eval(f), b.eval(f));
  }

  private static boolean isEmptySet(SemanticNode node) {
    return isOperator(node, "$SetEnumerate") && ((OpApplNode) node).getArgs().length == 0;
  }

  private static boolean isOperator(SemanticNode node, String name) {
    return node instanceof OpApplNode apply && apply.getOperator().getName().equals(name);
  }

  /** Whether a set is empty; a subset need not be built to know. */
  private Expr empty(SemanticNode set, Scope scope) {
    if (isOperator(set, "$SubsetOf") && !facts.of(set).closed()) {
      Expr some = new Quantifiers(this).someInSubset((OpApplNode) set, scope);
      return (Expr.Test) f -> !some.test(f);
    }
    Expr s = compile(set, scope);
    return (Expr.Test) f -> Builtins.isEmpty(s.eval(f));
  }

  /** Whether x is in a set; the set is built only where necessary. */
  private Expr member(SemanticNode element, SemanticNode set, Scope scope) {
    Expr x = compile(element, scope);
    if (set instanceof OpApplNode apply && !facts.of(set).closed()) {
      ExprOrOpArgNode[] parts = apply.getArgs();
      switch (apply.getOperator().getName()) {
        case "$SetEnumerate":
          Expr[] each = compile(parts, scope);
          return (Expr.Test) f -> contains(each, x.eval(f), f);
        case "\\union", "\\cup":
          Expr left = member(element, parts[0], scope);
          Expr right = member(element, parts[1], scope);
          return (Expr.Test) f -> left.test(f) || right.test(f);
        case "DOMAIN":
          Expr function = compile(parts[0], scope);
          return (Expr.Test) f -> machine.inDomain(function.eval(f), x.eval(f));
        default:
          break;
      }
    }
    Expr s = compile(set, scope);
    return (Expr.Test) f -> machine.member(x.eval(f), s.eval(f));
  }

  private boolean contains(Expr[] elements, Value x, Object[] frame) {
    for (Expr element : elements) {
      if (machine.equal(element.eval(frame), x)) {
        return true;
      }
    }
    return false;
  }
}
