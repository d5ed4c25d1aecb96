package tla.eval;

import java.util.BitSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;

import tla.tree.FormalParamNode;
import tla.tree.OpDeclNode;
import tla.tree.OpDefNode;
import tla.tree.SemanticNode;
import tlc2.value.impl.Value;

/**
 * Evaluates operators of a specification as TLC's interpreter does, several times faster.
 *
 * <p>It compiles an operator at its first evaluation, from the semantic graph of TLC's parser: every
 * expression becomes an object that evaluates itself ({@link Expr}, {@link Actions}). This package
 * knows the part of TLA+ that traces need, and no specification. Values are TLC's own.
 *
 * <p>It is faster for three reasons. The compiler resolves names to slots of a frame. An expression
 * that depends on no variable is evaluated once, an expression that depends on some only when they
 * have changed ({@link Memo}). Successors are found by continuing with the next conjunct, so nothing
 * is copied before all variables have a value.
 *
 * <p>A result is null where the evaluator does not support a construct, and where evaluation ends in
 * an error; then TLC's interpreter has the last word. An evaluator serves one thread.
 */
public final class Evaluator {
  final Machine machine;
  final Compiler compiler;
  private final Map<OpDefNode, Program> programs = new IdentityHashMap<>();
  private final Hash.Parts hashes = new Hash.Parts();
  private final Memory memory;
  private long operators;

  /** The use of an operator: by its value, as a step, or as the predicate of the first states. */
  private enum Use {
    VALUE,
    STEP,
    INITIAL
  }

  /** A compiled operator; {@code act} is null for a state function, both are if it is not supported. */
  private record Program(
      Machine machine, long number, int parameters, Object[] frame, Expr expr, Actions.Act act)
      implements Memory.Operator {

    @Override
    public Value value(State state, Value... arguments) {
      machine.load(state);
      System.arraycopy(arguments, 0, frame, 0, parameters);
      return expr.eval(frame);
    }

    @Override
    public List<State> successors(State state, Value... arguments) {
      machine.load(state);
      System.arraycopy(arguments, 0, frame, 0, parameters);
      machine.begin();
      machine.marks.restart();
      machine.marks.begin();
      act.run(frame);
      Marks.Some outcomes = machine.marks.end();
      for (State found : machine.found()) {
        found.outcomes = outcomes.with(found.outcomes);
      }
      return machine.found();
    }
  }

  /** A way as an operator. */
  private record Whole(long number, Way way) implements Memory.Operator {
    @Override
    public Value value(State state, Value... arguments) {
      throw new UnsupportedOperationException();
    }

    @Override
    public List<State> successors(State state, Value... arguments) {
      return way.from(state, arguments[0]);
    }
  }

  /**
   * @param times names of variables and fields whose integers are other ones each time while all else
   *     comes again ({@link Memory}); they change no result, only the speed
   * @param variables all variables, in the order in which a {@link State} has their values
   */
  public Evaluator(Set<String> times, OpDeclNode... variables) {
    machine = new Machine(variables);
    compiler = new Compiler(machine);
    memory = new Memory(machine, variables, times);
  }

  /**
   * Has each state tell to which marked expressions the steps to it came ({@link State#commonOutcomes}): mark
   * k in bit 2k where it was true, or has another value, or is an action that was taken; in bit 2k + 1
   * where it was false.
   *
   * <p>Before the first evaluation.
   *
   * @param marks the number of marks ({@link SemanticNode#mark})
   */
  public void mark(int marks) {
    machine.marks.set(marks);
  }

  /** Tells with which strings, its last arguments, an operator is applied; before the first evaluation. */
  public void watch(OpDefNode operator) {
    machine.asked.watch(operator);
  }

  /** Begins a new collection of such strings. */
  public void forgetAsked() {
    machine.asked.clear();
  }

  /** The strings since then; null if there may be others. */
  public Set<String> asked() {
    return machine.asked.all();
  }

  /** Somebody else made an evaluation. */
  public void missed() {
    machine.asked.miss();
  }

  /** A value for which nothing counts as asked. */
  public <T> T aside(Supplier<T> value) {
    BitSet outer = machine.asked.begin();
    try {
      return value.get();
    } finally {
      machine.asked.drop(outer);
    }
  }

  /** The states that satisfy an initial predicate; null if TLC has to find them. */
  public List<State> initial(OpDefNode operator) {
    return states(operator, Use.INITIAL, new State(new Value[machine.now.length]));
  }

  /** The successors of {@code state} under an action; null if TLC has to find them. */
  public List<State> successors(OpDefNode operator, State state, Value... arguments) {
    return states(operator, Use.STEP, state, arguments);
  }

  private List<State> states(OpDefNode operator, Use use, State state, Value... arguments) {
    BitSet asked = machine.asked.collection();
    try {
      Program program = program(operator, use);
      if (program.act != null) {
        return use == Use.STEP && program.parameters == 1 && !machine.isRecording()
            ? memory.successors(program, state, arguments[0])
            : program.successors(state, arguments);
      }
    } catch (RuntimeException e) {
      failed(e, asked);
    }
    return null;
  }

  /** The same way, of which a part that depends on shapes alone is gone once ({@link Memory}). */
  public Way remembered(Way way) {
    var whole = new Whole(++operators, way);
    return (state, argument) -> memory.successors(whole, state, argument);
  }

  /** The value of a state function; null if TLC has to find it. */
  public Value value(OpDefNode operator, State state, Value... arguments) {
    BitSet asked = machine.asked.collection();
    try {
      Program program = program(operator, Use.VALUE);
      if (program.expr != null) {
        return program.parameters == 1 && !machine.isRecording()
            ? memory.value(program, state, arguments[0])
            : program.value(state, arguments);
      }
    } catch (RuntimeException e) {
      failed(e, asked);
    }
    return null;
  }

  /** TLC names the error, but not of a state with recorded integers, which it does not know. */
  private void failed(RuntimeException e, BitSet asked) {
    machine.asked.drop(asked);
    if (machine.isRecording()) {
      throw e;
    }
  }

  /**
   * A number that is the same for states in which a state function has the same value and, as good
   * as certainly, another for others.
   *
   * @throws IllegalArgumentException if the state function has no value
   */
  public long key(OpDefNode operator, State state) {
    Value value = value(operator, state);
    if (value == null) {
      throw new IllegalArgumentException(operator.getName() + " has no value");
    }
    return hashes.of(value);
  }

  /** The number of evaluations that were remembered ones. */
  long remembered() {
    return memory.hits();
  }

  /** The body of an operator in a state, with its parameters bound. */
  public Place place(OpDefNode operator, State state, Value... arguments) {
    Scope scope = parameters(operator, false);
    return new Place(this, state, scope, arguments.clone());
  }

  /** Whether an expression refers to the next state. */
  public boolean isAction(SemanticNode node) {
    return compiler.primes(node);
  }

  private Program program(OpDefNode operator, Use use) {
    Program program = programs.get(operator);
    if (program == null) {
      program = compiled(operator, use);
      programs.put(operator, program);
    }
    return program;
  }

  private Program compiled(OpDefNode operator, Use use) {
    Scope scope = parameters(operator, use == Use.INITIAL);
    Expr expr = null;
    Actions.Act act = null;
    try {
      if (use == Use.VALUE) {
        expr = compiler.compile(operator.getBody(), scope);
      } else {
        var actions = new Actions(compiler, machine, use == Use.INITIAL);
        act = machine.marks.underWay(operator, actions.compile(operator.getBody(), scope, f -> machine.emit()));
      }
    } catch (Unsupported e) {
      return new Program(machine, 0, 0, null, null, null);
    }
    int parameters = operator.getParams().length;
    var frame = new Object[scope.slots.count()];
    return new Program(machine, ++operators, parameters, frame, expr, act);
  }

  private static Scope parameters(OpDefNode operator, boolean primed) {
    Scope scope = Scope.empty(new Scope.Slots(), primed);
    for (FormalParamNode parameter : operator.getParams()) {
      scope = scope.with(parameter, Scope.Binding.value(scope.slots.take()));
    }
    return scope;
  }
}
