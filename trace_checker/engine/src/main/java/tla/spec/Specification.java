package tla.spec;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;

import tla.eval.Evaluator;
import tla2sany.semantic.FormalParamNode;
import tla2sany.semantic.ModuleNode;
import tla2sany.semantic.OpDefNode;
import tlc2.tool.Action;
import tlc2.tool.EvalControl;
import tlc2.tool.StateVec;
import tlc2.tool.TLCState;
import tlc2.tool.impl.FastTool;
import tlc2.util.Context;
import tlc2.util.FP64;
import tlc2.value.IValue;
import tlc2.value.impl.BoolValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.SetEnumValue;
import tlc2.value.impl.Value;
import util.SimpleFilenameToStream;

/**
 * The operators of a TLA+ module. TLC parses it, {@link Evaluator} evaluates it, and TLC's own
 * interpreter evaluates the operators that the evaluator leaves to it. With {@code
 * -Dtla.compare=true} both evaluate every operator, and the first difference is an error.
 *
 * <p>TLC keeps a specification in static fields, so one JVM can hold one at a time. This class calls
 * only methods that TLC 2.18 and the TLC of 2026 both have.
 *
 * <p>Every method throws an IllegalStateException for an operator that the module does not have, and
 * another RuntimeException where TLC cannot evaluate it.
 */
public final class Specification {
  private static final boolean COMPARE = Boolean.getBoolean("tla.compare");

  private final FastTool tool;
  private final ModuleNode root;
  private final Source source;
  private final Evaluator evaluator;
  private final Map<String, OpDefNode> operators = new HashMap<>();

  /**
   * Parses {@code module} and its configuration of the same name.
   *
   * @param folder the folder of the modules
   * @throws RuntimeException if TLC cannot read or parse them
   */
  public Specification(Path folder, String module) {
    FP64.Init(); // without it every state has the same fingerprint
    var resolver = new SimpleFilenameToStream(folder.toAbsolutePath().toString());
    tool = new FastTool(folder.toAbsolutePath().toString(), module, module, resolver);
    root = tool.getSpecProcessor().getRootModule();
    source = new Source(folder.toAbsolutePath());
    evaluator = new Evaluator(TLCState.Empty);
  }

  /** The only state that satisfies the module's initial predicate. */
  public TLCState initialState() {
    return tool.getInitStates().elementAt(0);
  }

  /** The successors of {@code state} under the action {@code name}, applied to {@code arguments}. */
  public StateVec successors(String name, TLCState state, Value... arguments) {
    OpDefNode operator = operator(name);
    StateVec found = evaluator.successors(operator, state, arguments);
    if (found != null && !COMPARE) {
      return found;
    }
    StateVec byTlc =
        tool.getNextStates(
            new Action(operator.getBody(), bind(operator, arguments), operator), state);
    if (COMPARE && found == null) {
      System.err.println("left to TLC: " + name);
    }
    if (found != null && !asSet(found).equals(asSet(byTlc))) {
      throw new IllegalStateException("the evaluator and TLC differ in the successors of " + name);
    }
    return byTlc;
  }

  /** The value of a state function or state predicate. */
  public Value value(String name, TLCState state, Value... arguments) {
    OpDefNode operator = operator(name);
    Value found = evaluator.value(operator, state, arguments);
    if (found != null && !COMPARE) {
      return found;
    }
    IValue byTlc =
        tool.eval(
            operator.getBody(),
            bind(operator, arguments),
            state,
            state.createEmpty(),
            EvalControl.Clear);
    if (COMPARE && found == null) {
      System.err.println("left to TLC: " + name);
    }
    if (found != null && !found.equals(byTlc)) {
      throw new IllegalStateException("the evaluator and TLC differ in the value of " + name);
    }
    return (Value) byTlc;
  }

  private static Value asSet(StateVec states) {
    var records = new Value[states.size()];
    for (int i = 0; i < records.length; i++) {
      records[i] = new RecordValue(states.elementAt(i));
    }
    return new SetEnumValue(records, false);
  }

  /** The value of a state predicate. */
  public boolean holds(String name, TLCState state, Value... arguments) {
    return ((BoolValue) value(name, state, arguments)).val;
  }

  /**
   * The reasons why the action {@code name} is not enabled, as far as its definition shows them.
   *
   * @param label the short text by which a failure names a record that an action is applied to, or
   *     null for none
   */
  public Set<Guards.Failure> failures(
      String name, Function<RecordValue, String> label, TLCState state, Value... arguments) {
    OpDefNode operator = operator(name);
    return new Guards(tool, source, label, state).of(operator, bind(operator, arguments));
  }

  /**
   * A number that is the same for states in which the state function {@code name} has the same value
   * and, as good as certainly, another for others.
   */
  public long key(String name, TLCState state) {
    return evaluator.key(operator(name), state);
  }

  /** The number of parameters of an operator; -1 if the module does not have it. */
  public int arity(String name) {
    OpDefNode found = root.getOpDef(name);
    return found == null ? -1 : found.getArity();
  }

  private OpDefNode operator(String name) {
    return operators.computeIfAbsent(
        name,
        n -> {
          OpDefNode found = root.getOpDef(n);
          if (found == null) {
            throw new IllegalStateException("the specification has no operator " + n);
          }
          return found;
        });
  }

  /** Binds the operator's parameters. */
  private static Context bind(OpDefNode operator, Value... arguments) {
    Context context = Context.Empty;
    FormalParamNode[] parameters = operator.getParams();
    for (int i = 0; i < parameters.length; i++) {
      context = context.cons(parameters[i], arguments[i]);
    }
    return context;
  }
}
