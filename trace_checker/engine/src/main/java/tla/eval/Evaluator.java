package tla.eval;

import java.util.IdentityHashMap;
import java.util.Map;

import tla2sany.semantic.FormalParamNode;
import tla2sany.semantic.OpDefNode;
import tlc2.tool.StateVec;
import tlc2.tool.TLCState;
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
  private final Machine machine;
  private final Compiler compiler;
  private final Actions actions;
  private final Map<OpDefNode, Program> programs = new IdentityHashMap<>();
  private final Hash.Parts hashes = new Hash.Parts();
  private int leftToTlc;

  /** A compiled operator; {@code act} is null for a state function, both are if it is not supported. */
  private record Program(Object[] frame, Expr expr, Actions.Act act) {}

  /**
   * @param state some state of the specification
   */
  public Evaluator(TLCState state) {
    machine = new Machine(state.getVars());
    compiler = new Compiler(machine);
    actions = new Actions(compiler, machine);
  }

  /** The successors of {@code state} under an action; null if TLC has to find them. */
  public StateVec successors(OpDefNode operator, TLCState state, Value... arguments) {
    try {
      Program program = program(operator, true);
      if (program.act != null) {
        machine.load(state);
        machine.begin();
        System.arraycopy(arguments, 0, program.frame, 0, operator.getParams().length);
        program.act.run(program.frame);
        return machine.found();
      }
    } catch (RuntimeException e) {
      // TLC names the error.
    }
    leftToTlc++;
    return null;
  }

  /** The value of a state function; null if TLC has to find it. */
  public Value value(OpDefNode operator, TLCState state, Value... arguments) {
    try {
      Program program = program(operator, false);
      if (program.expr != null) {
        machine.load(state);
        System.arraycopy(arguments, 0, program.frame, 0, operator.getParams().length);
        return program.expr.eval(program.frame);
      }
    } catch (RuntimeException e) {
      // TLC names the error.
    }
    leftToTlc++;
    return null;
  }

  /**
   * A number that is the same for states in which a state function has the same value and, as good
   * as certainly, another for others.
   */
  public long key(OpDefNode operator, TLCState state) {
    Value value = value(operator, state);
    return value == null ? state.fingerPrint() : hashes.of(value);
  }

  /** The number of evaluations that were left to TLC. */
  public int leftToTlc() {
    return leftToTlc;
  }

  private Program program(OpDefNode operator, boolean action) {
    Program program = programs.get(operator);
    if (program == null) {
      program = compiled(operator, action);
      programs.put(operator, program);
    }
    return program;
  }

  private Program compiled(OpDefNode operator, boolean action) {
    var slots = new Scope.Slots();
    Scope scope = Scope.empty(slots, false);
    for (FormalParamNode parameter : operator.getParams()) {
      scope = scope.with(parameter, Scope.Binding.value(slots.take()));
    }
    Expr expr = null;
    Actions.Act act = null;
    try {
      if (action) {
        act = actions.compile(operator.getBody(), scope, f -> machine.emit());
      } else {
        expr = compiler.compile(operator.getBody(), scope);
      }
    } catch (Unsupported e) {
      return new Program(null, null, null);
    }
    return new Program(new Object[slots.count()], expr, act);
  }
}
