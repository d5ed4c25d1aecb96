package tla.eval;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tla.tlc.FromSany;
import tla.tree.Module;
import tla2sany.semantic.OpDeclNode;
import tla2sany.semantic.OpDefNode;
import tlc2.tool.Action;
import tlc2.tool.EvalControl;
import tlc2.tool.StateVec;
import tlc2.tool.TLCState;
import tlc2.tool.impl.FastTool;
import tlc2.util.Context;
import tlc2.util.FP64;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.SetEnumValue;
import tlc2.value.impl.StringValue;
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;
import util.SimpleFilenameToStream;
import util.ToolIO;
import util.UniqueString;

class EvaluatorTest {
  private static FastTool tool;
  private static State initial;
  private static Module module;
  private static Evaluator evaluator;

  @BeforeAll
  static void load() throws Exception {
    ToolIO.out = new PrintStream(OutputStream.nullOutputStream());
    FP64.Init();
    String folder =
        Path.of(EvaluatorTest.class.getResource("/eval/Words.tla").toURI()).getParent().toString();
    tool = new FastTool(folder, "Words", "Words", new SimpleFilenameToStream(folder));
    module = FromSany.of(tool.getSpecProcessor().getRootModule(), Map.of());
    evaluator = new Evaluator(Set.of(), module.getVariableDecls());
    initial = ofTlc(tool.getInitStates().elementAt(0));
  }

  private static Stream<String> operators(String prefix) {
    return Arrays.stream(tool.getSpecProcessor().getRootModule().getOpDefs())
        .filter(o -> o.getOriginallyDefinedInModuleNode().getName().toString().equals("Words"))
        .filter(o -> o.getParams().length == 0)
        .map(o -> o.getName().toString())
        .filter(name -> name.startsWith(prefix));
  }

  static Stream<String> actions() {
    return operators("Act").filter(name -> !name.startsWith("ActErr"));
  }

  static Stream<String> values() {
    return operators("").filter(name -> !name.matches("(Act|Err|Tlc|Init).*"));
  }

  static Stream<String> withoutValue() {
    return operators("Err");
  }

  static Stream<String> withoutSuccessors() {
    return operators("ActErr");
  }

  static Stream<String> leftToTlc() {
    return operators("Tlc");
  }

  private static OpDefNode operator(String name) {
    return tool.getSpecProcessor().getRootModule().getOpDef(name);
  }

  /** The operator in the graph that the evaluator knows. */
  private static tla.tree.OpDefNode ours(String name) {
    return module.getOpDef(name);
  }

  private static OpDeclNode[] variables() {
    return tool.getSpecProcessor().getRootModule().getVariableDecls();
  }

  private static State ofTlc(TLCState state) {
    return new State(
        Arrays.stream(variables()).map(v -> (Value) state.lookup(v.getName())).toArray(Value[]::new));
  }

  private static TLCState forTlc(State state) {
    TLCState bound = TLCState.Empty.createEmpty();
    for (int i = 0; i < variables().length; i++) {
      bound.bind(variables()[i].getName(), state.value(i));
    }
    return bound;
  }

  private static Value byTlc(String name, State state, Value... arguments) {
    TLCState now = forTlc(state);
    OpDefNode operator = operator(name);
    return (Value)
        tool.eval(
            operator.getBody(), bind(operator, arguments), now, now.createEmpty(), EvalControl.Clear);
  }

  private static Context bind(OpDefNode operator, Value... arguments) {
    Context context = Context.Empty;
    for (int i = 0; i < arguments.length; i++) {
      context = context.cons(operator.getParams()[i], arguments[i]);
    }
    return context;
  }

  private static Value successorsByTlc(String name, State state, Value... arguments) {
    OpDefNode operator = operator(name);
    var action = new Action(operator.getBody(), bind(operator, arguments), operator);
    return asSet(tool.getNextStates(action, forTlc(state)));
  }

  private static Value asSet(StateVec states) {
    var records = new Value[states.size()];
    for (int i = 0; i < records.length; i++) {
      records[i] = new RecordValue(states.elementAt(i));
    }
    return new SetEnumValue(records, false);
  }

  private static Value asSet(List<State> states) {
    return new SetEnumValue(
        states.stream().map(state -> new RecordValue(forTlc(state))).toArray(Value[]::new), false);
  }

  /** The initial state, its successors, and the initial state again. */
  private static Stream<State> states() {
    return Stream.of(initial, next(), initial);
  }

  private static State next() {
    return evaluator.successors(ours("ActAssign"), initial).get(0);
  }

  @Test
  @DisplayName("the first states are those of TLC")
  void initialStates() {
    var found = evaluator.initial(ours("InitSeveral"));
    assertEquals(4, found.size());
    assertEquals(asSet(tool.getInitStates()), asSet(evaluator.initial(ours("Init"))));
  }

  @Test
  @DisplayName("values and successors that come again with other times are those of TLC")
  void times() {
    var remembering = new Evaluator(Set.of("number", "a"), module.getVariableDecls());
    State state = initial;
    for (int i = 0; i < 400; i++) {
      Value[] values = {IntValue.gen(i * 7 % 23), new StringValue(i % 3 == 0 ? "x" : "y")};
      UniqueString[] names = {UniqueString.uniqueStringOf("a"), UniqueString.uniqueStringOf("c")};
      var event = new RecordValue(names, values, false);
      Value value = remembering.value(ours("TimedValue"), state, event);
      assertEquals(byTlc("TimedValue", state, event), value);
      List<State> found = remembering.successors(ours("ActTimed"), state, event);
      assertEquals(successorsByTlc("ActTimed", state, event), asSet(found));
      state = i % 50 == 0 ? initial : found.get(i % found.size());
    }
    assertTrue(remembering.remembered() > 300, "remembered " + remembering.remembered());
  }

  @ParameterizedTest
  @DisplayName("values are those of TLC")
  @MethodSource("values")
  void value(String name) {
    states()
        .forEach(
            state -> {
              Value value = evaluator.value(ours(name), state);
              assertNotNull(value, "left to TLC");
              assertEquals(byTlc(name, state), value);
              assertEquals(Hash.of(byTlc(name, state)), Hash.of(value));
            });
  }

  @ParameterizedTest
  @DisplayName("successors are those of TLC")
  @MethodSource("actions")
  void successors(String name) {
    states()
        .forEach(
            state -> {
              List<State> found = evaluator.successors(ours(name), state);
              assertNotNull(found, "left to TLC");
              assertEquals(successorsByTlc(name, state), asSet(found));
            });
  }

  @ParameterizedTest
  @DisplayName("an operator that TLC cannot evaluate is left to TLC")
  @MethodSource("withoutValue")
  void error(String name) {
    assertThrows(RuntimeException.class, () -> byTlc(name, initial));
    assertNull(evaluator.value(ours(name), initial));
    assertNotNull(evaluator.value(ours("Arithmetic"), initial), "the next one is evaluated");
  }

  @ParameterizedTest
  @DisplayName("an action that TLC cannot evaluate is left to TLC")
  @MethodSource("withoutSuccessors")
  void errorInAction(String name) {
    assertNull(evaluator.successors(ours(name), initial));
    assertEquals(1, evaluator.successors(ours("ActAssign"), initial).size());
  }

  @ParameterizedTest
  @DisplayName("a construct that is not supported is left to TLC")
  @MethodSource("leftToTlc")
  void unsupported(String name) {
    assertNull(evaluator.value(ours(name), initial));
  }

  @Test
  @DisplayName("keys tell states apart by the value of a state function")
  void keys() {
    State next = next();
    assertNotEquals(evaluator.key(ours("vars"), initial), evaluator.key(ours("vars"), next));
    assertEquals(
        evaluator.key(ours("others"), initial), evaluator.key(ours("others"), next));
  }

  @Test
  @DisplayName("equal functions have the same hash, whatever TLC keeps them in")
  void hashes() {
    Value[] all = ((TupleValue) evaluator.value(ours("Domains"), initial)).elems;
    assertEquals(Hash.of(all[1]), Hash.of(all[2]));
    assertEquals(Hash.of(all[3]), Hash.of(all[4]));
    assertNotEquals(Hash.of(all[1]), Hash.of(all[3]));
  }
}
