package tla.tlc;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

import tla.eval.State;
import tla.spec.Interpreter;
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
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;
import util.FilenameToStream;

/**
 * TLC's own interpreter of a module, set up when it is first needed. With {@code -Dtla.compare=true} it evaluates every
 * operator, and the first difference from the evaluator is an error. To set it up costs much more than to parse the module, since
 * TLC evaluates all constant definitions.
 *
 * <p>TLC keeps a specification in static fields, so one JVM can hold one at a time. This class calls
 * only methods that TLC 2.18 and the TLC of 2026 both have. Its methods throw a RuntimeException
 * where TLC cannot evaluate an operator.
 */
final class Tlc implements Interpreter {
  private static final boolean COMPARE = Boolean.getBoolean("tla.compare");

  private final Path folder;
  private final String module;
  private final FilenameToStream resolver;
  private FastTool tool;
  private ModuleNode root;
  private OpDeclNode[] variables;

  Tlc(Path folder, String module, FilenameToStream resolver) {
    this.folder = folder;
    this.module = module;
    this.resolver = resolver;
  }

  private FastTool tool() {
    if (tool == null) {
      FP64.Init(); // without it every state has the same fingerprint
      tool = new FastTool(folder.toString(), module, module, resolver);
      root = tool.getSpecProcessor().getRootModule();
      variables = root.getVariableDecls();
    }
    return tool;
  }

  @Override
  public boolean compares() {
    return COMPARE;
  }

  @Override
  public List<State> initial(String name, List<State> found) {
    return compared(name, found, tool().getInitStates(), new State());
  }

  @Override
  public List<State> successors(String name, List<State> found, State state, Value... arguments) {
    FastTool interpreter = tool();
    OpDefNode operator = root.getOpDef(name);
    var action = new Action(operator.getBody(), bind(operator, arguments), operator);
    return compared(name, found, interpreter.getNextStates(action, state(state)), state);
  }

  @Override
  public Value value(String name, Value found, State state, Value... arguments) {
    FastTool interpreter = tool();
    OpDefNode operator = root.getOpDef(name);
    TLCState now = state(state);
    var value =
        (Value)
            interpreter.eval(operator.getBody(), bind(operator, arguments), now, now.createEmpty(), EvalControl.Clear);
    differs(name, found == null, found == null || found.equals(value));
    return value;
  }

  private List<State> compared(String name, List<State> found, StateVec vector, State before) {
    List<State> states = states(vector);
    states.forEach(state -> state.follow(before));
    differs(name, found == null, found == null || asSet(found).equals(asSet(states)));
    return states;
  }

  private static void differs(String name, boolean left, boolean same) {
    if (COMPARE && left) {
      System.err.println("left to TLC: " + name);
    }
    if (!same) {
      throw new IllegalStateException("the evaluator and TLC differ in " + name);
    }
  }

  private Set<Value> asSet(List<State> states) {
    var values = new HashSet<Value>();
    for (State state : states) {
      var all = new Value[variables.length];
      for (int i = 0; i < all.length; i++) {
        all[i] = state.value(i);
      }
      values.add(new TupleValue(all));
    }
    return values;
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
