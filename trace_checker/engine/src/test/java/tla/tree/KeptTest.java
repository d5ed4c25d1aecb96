package tla.tree;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.StreamSupport;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tla.tlc.Modules;
import util.ToolIO;

/** The graph of the specification from SANY, and the same from a file. */
class KeptTest {
  private static Module parsed;

  /** Each symbol by its number: the same symbol has the same one wherever it is used. */
  private final Map<SymbolNode, Integer> symbols = new HashMap<>();

  private final Map<OpApplNode, Integer> parts = new HashMap<>();
  private final List<String> text = new ArrayList<>();

  @BeforeAll
  static void parse() {
    ToolIO.out = new PrintStream(OutputStream.nullOutputStream());
    parsed = new Modules(Path.of("..", "..", "spec"), "Explain").parsed();
    OpDefNode observe = parsed.getOpDef("Observe");
    parsed.mark(
        Set.of("Observe"),
        List.of(
            new Module.Marked(1, observe, observe),
            new Module.Marked(3, observe, ((OpApplNode) observe.getBody()).getArgs()[1])));
  }

  private static List<String> described(Module module) {
    var test = new KeptTest();
    for (OpDeclNode variable : module.getVariableDecls()) {
      test.symbol(variable);
    }
    StreamSupport.stream(module.definitions().spliterator(), false)
        .sorted(Comparator.comparing(SymbolNode::getName))
        .forEach(test::symbol);
    new TreeMap<>(module.texts()).forEach((name, text) -> test.text.add(name + text.get()));
    test.text.add(module.markedFor().toString());
    for (Module.Marked each : module.marked()) {
      test.text.add(each.kind() + " " + each.definition().getName() + " " + each.node().getLocation());
    }
    return test.text;
  }

  private int symbol(SymbolNode symbol) {
    Integer known = symbols.get(symbol);
    if (known != null) {
      return known;
    }
    int number = symbols.size();
    symbols.put(symbol, number);
    text.add(number + " " + symbol.getClass() + symbol.getName() + " " + symbol.mark + " " + symbol.getLocation());
    if (symbol instanceof OpDefNode definition) {
      text.add(definition.isDefined() + " " + definition.isConstant() + " " + definition.getArity());
      for (FormalParamNode parameter : definition.getParams()) {
        symbol(parameter);
      }
      node(definition.getBody());
    }
    return number;
  }

  private void node(SemanticNode node) {
    if (node == null) {
      text.add("nothing");
      return;
    }
    boolean action = node instanceof ExprNode expr && expr.isAction();
    text.add(node.getClass() + " " + node.mark + " " + action + " " + node.getLocation());
    if (node instanceof NumeralNode numeral) {
      text.add("" + numeral.val());
    } else if (node instanceof StringNode string) {
      text.add(string.getRep().toString());
    } else if (node instanceof OtherNode other) {
      text.add(other.kind());
    } else if (node instanceof AtNode at) {
      text.add("of " + parts.get(at.getExceptComponentRef()));
    } else if (node instanceof OpArgNode argument) {
      text.add("" + symbol(argument.getOp()));
    } else if (node instanceof LetInNode let) {
      for (OpDefNode each : let.getLets()) {
        text.add("" + symbol(each));
      }
      node(let.getBody());
    } else {
      application((OpApplNode) node);
    }
  }

  private void application(OpApplNode apply) {
    parts.put(apply, parts.size());
    text.add("" + symbol(apply.getOperator()));
    for (int i = 0; apply.getBdedQuantBounds() != null && i < apply.getBdedQuantBounds().length; i++) {
      text.add("" + apply.isBdedQuantATuple()[i]);
      for (FormalParamNode each : apply.getBdedQuantSymbolLists()[i]) {
        text.add("" + symbol(each));
      }
      node(apply.getBdedQuantBounds()[i]);
    }
    for (SemanticNode each : apply.getArgs()) {
      node(each);
    }
  }

  @Test
  @DisplayName("the graph from a file is that of SANY, node for node, with marks and locations")
  void same(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("kept");
    Modules.keep(parsed, file);
    List<String> all = described(parsed);
    assertTrue(all.size() > 10_000);
    assertEquals(all, described(Modules.kept(file)));
  }

  @Test
  @DisplayName("a file that is damaged, cut off, of another form or missing is none")
  void damaged(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("kept");
    assertNull(Modules.kept(file));
    Modules.keep(parsed, file);
    byte[] whole = Files.readAllBytes(file);
    Files.write(file, Arrays.copyOf(whole, whole.length / 2));
    assertNull(Modules.kept(file));
    whole[whole.length / 3]++;
    Files.write(file, whole);
    assertNull(Modules.kept(file));
    Files.write(file, new byte[0]);
    assertNull(Modules.kept(file));
  }
}
