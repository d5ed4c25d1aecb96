package s7.trace;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;

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
import tlc2.value.impl.Value;
import util.SimpleFilenameToStream;

/**
 * The operators of a TLA+ module, evaluated by TLC's own interpreter.
 *
 * <p>TLC keeps a specification in static fields, so one JVM can hold one at a time. Only methods
 * that TLC 2.18 and the TLC of 2026 both have are called.
 */
final class Specification {

  private final FastTool tool;
  private final ModuleNode root;
  private final Source source;
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
  }

  /** The only state that satisfies the module's initial predicate. */
  TLCState initialState() {
    return tool.getInitStates().elementAt(0);
  }

  /** The successors of {@code state} under the action {@code name}, applied to {@code argument}. */
  StateVec successors(String name, TLCState state, Value... arguments) {
    OpDefNode operator = operator(name);
    return tool.getNextStates(
        new Action(operator.getBody(), bind(operator, arguments), operator), state);
  }

  /** The value of a state function or state predicate. */
  Value value(String name, TLCState state, Value... arguments) {
    OpDefNode operator = operator(name);
    IValue value =
        tool.eval(
            operator.getBody(),
            bind(operator, arguments),
            state,
            state.createEmpty(),
            EvalControl.Clear);
    return (Value) value;
  }

  boolean holds(String name, TLCState state, Value... arguments) {
    return ((BoolValue) value(name, state, arguments)).val;
  }

  /** Why the action {@code name} is not enabled, as far as its definition shows it. */
  Set<Guards.Failure> failures(String name, TLCState state, Value... arguments) {
    OpDefNode operator = operator(name);
    return new Guards(tool, source, state).of(operator, bind(operator, arguments));
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
