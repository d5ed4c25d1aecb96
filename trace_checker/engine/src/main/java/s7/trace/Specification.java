package s7.trace;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;

import s7.trace.eval.Evaluator;
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
 * The operators of a TLA+ module: parsed by TLC, evaluated by {@link Evaluator}, and by TLC's own
 * interpreter where that leaves it to TLC. With {@code -Ds7.trace.compare=true} both evaluate
 * everything, and the first difference is an error.
 *
 * <p>TLC keeps a specification in static fields, so one JVM can hold one at a time. Only methods
 * that TLC 2.18 and the TLC of 2026 both have are called.
 */
final class Specification {
  private static final boolean COMPARE = Boolean.getBoolean("s7.trace.compare");

  private final FastTool tool;
  private final ModuleNode root;
  private final Source source;
  private final Evaluator evaluator;
  private final OpDefNode distinct;
  private final Map<String, OpDefNode> operators = new HashMap<>();

  /**
   * Parses {@code module} and its configuration of the same name.
   *
   * @param folder where the modules are
   * @throws RuntimeException if TLC cannot read or parse them
   */
  Specification(Path folder, String module) {
    FP64.Init(); // without it every state has the same fingerprint
    var resolver = new SimpleFilenameToStream(folder.toAbsolutePath().toString());
    tool = new FastTool(folder.toAbsolutePath().toString(), module, module, resolver);
    root = tool.getSpecProcessor().getRootModule();
    source = new Source(folder.toAbsolutePath());
    evaluator = new Evaluator(TLCState.Empty);
    distinct = root.getOpDef("Distinct");
  }

  /** The only state that satisfies the module's initial predicate. */
  TLCState initialState() {
    return tool.getInitStates().elementAt(0);
  }

  /** The successors of {@code state} under the action {@code name}, applied to {@code arguments}. */
  StateVec successors(String name, TLCState state, Value... arguments) {
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
  Value value(String name, TLCState state, Value... arguments) {
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

  boolean holds(String name, TLCState state, Value... arguments) {
    return ((BoolValue) value(name, state, arguments)).val;
  }

  /** Why the action {@code name} is not enabled, as far as its definition shows it. */
  Set<Guards.Failure> failures(String name, TLCState state, Value... arguments) {
    OpDefNode operator = operator(name);
    return new Guards(tool, source, state).of(operator, bind(operator, arguments));
  }

  /**
   * A number that is the same for states that need not be told apart, and another for others: by
   * the operator Distinct, which is also the VIEW of the configuration, or else by all variables.
   */
  long key(TLCState state) {
    return distinct == null ? state.fingerPrint() : evaluator.key(distinct, state);
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

  /** Binds the operator's parameters; arguments that it does not take are left over. */
  private static Context bind(OpDefNode operator, Value... arguments) {
    Context context = Context.Empty;
    FormalParamNode[] parameters = operator.getParams();
    for (int i = 0; i < parameters.length; i++) {
      context = context.cons(parameters[i], arguments[i]);
    }
    return context;
  }
}
