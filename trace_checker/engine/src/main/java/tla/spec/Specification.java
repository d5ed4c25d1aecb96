package tla.spec;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.function.Supplier;

import tla.eval.Evaluator;
import tla.eval.State;
import tla.eval.Way;
import tla.tree.Module;
import tla.tree.OpDefNode;
import tlc2.value.impl.BoolValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.Value;

/**
 * The operators of a TLA+ module. {@link Evaluator} evaluates it, and an {@link Interpreter} the operators that the
 * evaluator leaves to it.
 *
 * <p>Every method throws an IllegalStateException for an operator that the module does not have, and
 * another RuntimeException where it cannot be evaluated.
 */
public final class Specification {
  private final Module root;
  private final Source source;
  private final Evaluator evaluator;
  private final Map<String, OpDefNode> operators = new HashMap<>();
  private final Interpreter interpreter;

  /**
   * @param times names of variables and fields that hold times; see {@link Evaluator}
   * @param interpreter evaluates what the evaluator leaves to it
   */
  public Specification(Module root, Set<String> times, Interpreter interpreter) {
    this.root = root;
    this.interpreter = interpreter;
    source = new Source(root);
    evaluator = new Evaluator(times, root.getVariableDecls());
  }

  /** The only state that satisfies the initial predicate {@code name}. */
  public State initialState(String name) {
    List<State> found = evaluator.initial(operator(name));
    return (isEnough(found) ? found : interpreter.initial(name, found)).get(0);
  }

  /** The successors of {@code state} under the action {@code name}, applied to {@code arguments}. */
  public List<State> successors(String name, State state, Value... arguments) {
    List<State> found = evaluator.successors(operator(name), state, arguments);
    return isEnough(found) ? found : interpreter.successors(name, found, state, arguments);
  }

  /** The value of a state function or state predicate. */
  public Value value(String name, State state, Value... arguments) {
    Value found = evaluator.value(operator(name), state, arguments);
    return isEnough(found) ? found : interpreter.value(name, found, state, arguments);
  }

  private boolean isEnough(Object found) {
    if (found != null && !interpreter.compares()) {
      return true;
    }
    evaluator.missed();
    return false;
  }

  /** A way through operators of this specification, which goes it faster from its second time on. */
  public Way remembered(Way way) {
    return interpreter.compares() ? way : evaluator.remembered(way);
  }

  /** The value of a state predicate. */
  public boolean holds(String name, State state, Value... arguments) {
    return ((BoolValue) value(name, state, arguments)).val;
  }

  /**
   * The reasons why the action {@code name} is not enabled, as far as its definition shows them.
   *
   * @param label the short text by which a failure names a record that an action is applied to, or
   *     null for none
   * @param numbers how the numbers are spelled that stand with this operand, null if as they are
   */
  public Set<Guards.Failure> failures(
      String name,
      Function<RecordValue, String> label,
      Function<String, IntFunction<String>> numbers,
      State state,
      Value... arguments) {
    OpDefNode operator = operator(name);
    return new Guards(evaluator, source, label, numbers)
        .of(operator, evaluator.place(operator, state, arguments));
  }

  /**
   * A number that is the same for states in which the state function {@code name} has the same value
   * and, as good as certainly, another for others.
   */
  public long key(String name, State state) {
    return evaluator.key(operator(name), state);
  }

  /**
   * Has each state tell which outcomes the decisions of these operators had on the way to it; before the
   * first evaluation.
   *
   * @return the decisions, in the order of the numbers that {@link Evaluator#mark} gives them
   */
  public Decisions tellDecisions(Set<String> names) {
    Decisions decisions = Decisions.of(names, root, source);
    evaluator.mark(decisions.size());
    return decisions;
  }

  /**
   * Watches with which strings, its last arguments, an operator is applied, before the first evaluation. A
   * module without it is not watched.
   */
  public void watch(String name) {
    if (arity(name) > 0) {
      evaluator.watch(operator(name));
    }
  }

  /** Begins a new collection of such strings. */
  public void forgetAsked() {
    evaluator.forgetAsked();
  }

  /** The strings since then; null if there may be others. */
  public Set<String> asked() {
    return evaluator.asked();
  }

  /** A value for which nothing counts as asked. */
  public <T> T aside(Supplier<T> value) {
    return evaluator.aside(value);
  }

  /** The number of parameters of an operator; -1 if the module does not have it. */
  public int arity(String name) {
    OpDefNode found = root.getOpDef(name);
    return found == null ? -1 : found.getArity();
  }

  private OpDefNode operator(String name) {
    OpDefNode known = operators.get(name);
    if (known == null) {
      known = root.getOpDef(name);
      if (known == null) {
        throw new IllegalStateException("the specification has no operator " + name);
      }
      operators.put(name, known);
    }
    return known;
  }
}
