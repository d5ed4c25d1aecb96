package tla.spec;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

import tla.eval.State;
import tla2sany.semantic.FormalParamNode;
import tla2sany.semantic.ModuleNode;
import tla2sany.semantic.OpDeclNode;
import tla2sany.semantic.OpDefNode;
import tlc2.tool.Action;
import tlc2.tool.EvalControl;
import tlc2.tool.StateVec;
import tlc2.tool.TLCState;
import tlc2.tool.impl.FastTool;
import tlc2.util.Context;
import tlc2.util.FP64;
import tlc2.value.impl.Value;
import util.FilenameToStream;

/**
 * TLC's own interpreter of a module. To set it up costs much more than to parse the module, since
 * TLC evaluates all constant definitions.
 *
 * <p>TLC keeps a specification in static fields, so one JVM can hold one at a time. This class calls
 * only methods that TLC 2.18 and the TLC of 2026 both have. Its methods throw a RuntimeException
 * where TLC cannot evaluate an operator.
 */
final class Interpreter {
  private final FastTool tool;
  private final ModuleNode root;
  private final OpDeclNode[] variables;

  Interpreter(Path folder, String module, FilenameToStream resolver) {
    FP64.Init(); // without it every state has the same fingerprint
    tool = new FastTool(folder.toString(), module, module, resolver);
    root = tool.getSpecProcessor().getRootModule();
    variables = root.getVariableDecls();
  }

  List<State> initial() {
    return states(tool.getInitStates());
  }

  List<State> successors(String name, State state, Value... arguments) {
    OpDefNode operator = root.getOpDef(name);
    var action = new Action(operator.getBody(), bind(operator, arguments), operator);
    return states(tool.getNextStates(action, state(state)));
  }

  Value value(String name, State state, Value... arguments) {
    OpDefNode operator = root.getOpDef(name);
    TLCState now = state(state);
    return (Value)
        tool.eval(
            operator.getBody(), bind(operator, arguments), now, now.createEmpty(), EvalControl.Clear);
  }

  private static Context bind(OpDefNode operator, Value... arguments) {
    Context context = Context.Empty;
    FormalParamNode[] parameters = operator.getParams();
    for (int i = 0; i < parameters.length; i++) {
      context = context.cons(parameters[i], arguments[i]);
    }
    return context;
  }

  private TLCState state(State state) {
    TLCState bound = TLCState.Empty.createEmpty();
    for (int i = 0; i < variables.length; i++) {
      if (state.value(i) != null) {
        bound.bind(variables[i].getName(), state.value(i));
      }
    }
    return bound;
  }

  private List<State> states(StateVec vector) {
    var states = new ArrayList<State>(vector.size());
    for (int i = 0; i < vector.size(); i++) {
      TLCState found = vector.elementAt(i);
      var values = new Value[variables.length];
      for (int k = 0; k < values.length; k++) {
        values[k] = (Value) found.lookup(variables[k].getName());
      }
      states.add(new State(values));
    }
    return states;
  }
}
