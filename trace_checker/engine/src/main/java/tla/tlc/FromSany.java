package tla.tlc;

import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;

import tla2sany.semantic.ASTConstants;
import tla2sany.semantic.LevelConstants;
import tla2sany.semantic.LevelNode;
import tla2sany.semantic.ModuleNode;
import tla.tree.AtNode;
import tla.tree.ExprNode;
import tla.tree.ExprOrOpArgNode;
import tla.tree.FormalParamNode;
import tla.tree.LetInNode;
import tla.tree.Location;
import tla.tree.Module;
import tla.tree.NumeralNode;
import tla.tree.OpApplNode;
import tla.tree.OpArgNode;
import tla.tree.OpDeclNode;
import tla.tree.OpDefNode;
import tla.tree.OtherNode;
import tla.tree.SemanticNode;
import tla.tree.StringNode;
import tla.tree.SymbolNode;

/** Takes the graph from that of SANY. */
public final class FromSany {
  /** Modules whose operators tla.eval.Builtins defines, not their TLA+ text. */
  private static final Set<String> STANDARD_MODULES =
      Set.of("Naturals", "Integers", "Sequences", "FiniteSets", "Reals", "TLC", "Bags");

  private final Map<Object, SymbolNode> symbols = new IdentityHashMap<>();
  private final Map<Object, OpApplNode> components = new IdentityHashMap<>();

  private FromSany() {}

  /** The graph of a module with all that it extends. */
  public static Module of(ModuleNode root, Map<String, Supplier<String>> texts) {
    var from = new FromSany();
    return new Module(
        texts,
        Arrays.stream(root.getVariableDecls()).map(from::symbol).toArray(OpDeclNode[]::new),
        Arrays.stream(root.getOpDefs()).map(from::symbol).toArray(OpDefNode[]::new));
  }

  private static SemanticNode.Place place(tla2sany.semantic.SemanticNode node) {
    return () -> {
      var at = node.getLocation();
      return new Location(at.source(), at.beginLine(), at.beginColumn(), at.endLine(), at.endColumn());
    };
  }

  private static boolean isAction(LevelNode node) {
    return node.getLevel() >= LevelConstants.ActionLevel;
  }

  private SymbolNode symbol(tla2sany.semantic.SymbolNode symbol) {
    SymbolNode known = symbols.get(symbol);
    if (known == null) {
      known = made(symbol);
      symbols.put(symbol, known);
    }
    return known;
  }

  private SymbolNode made(tla2sany.semantic.SymbolNode symbol) {
    String name = symbol.getName().toString();
    SemanticNode.Place place = place(symbol);
    if (symbol instanceof tla2sany.semantic.FormalParamNode) {
      return new FormalParamNode(place, name);
    }
    if (!(symbol instanceof tla2sany.semantic.OpDefNode definition)) {
      return new OpDeclNode(place, name);
    }
    var module = definition.getOriginallyDefinedInModuleNode();
    boolean defined =
        definition.getKind() == ASTConstants.UserDefinedOpKind
            && (module == null || !STANDARD_MODULES.contains(module.getName().toString()));
    FormalParamNode[] parameters = defined ? parameters(definition.getParams()) : new FormalParamNode[0];
    boolean constant = !defined || definition.getLevel() == LevelConstants.ConstantLevel;
    var made = new OpDefNode(place, name, defined, constant, parameters);
    if (defined) {
      made.hasBody(() -> (ExprNode) node(definition.getBody()));
    }
    return made;
  }

  private FormalParamNode[] parameters(tla2sany.semantic.FormalParamNode... all) {
    return Arrays.stream(all).map(this::symbol).toArray(FormalParamNode[]::new);
  }

  private ExprOrOpArgNode node(tla2sany.semantic.SemanticNode node) {
    if (node == null) {
      return null;
    }
    SemanticNode.Place place = place(node);
    if (node instanceof tla2sany.semantic.NumeralNode numeral) {
      return new NumeralNode(place, numeral.val());
    }
    if (node instanceof tla2sany.semantic.StringNode string) {
      return new StringNode(place, string.getRep());
    }
    if (node instanceof tla2sany.semantic.AtNode at) {
      return new AtNode(place, components.get(at.getExceptComponentRef()));
    }
    if (node instanceof tla2sany.semantic.OpArgNode argument) {
      return new OpArgNode(place, symbol(argument.getOp()));
    }
    if (node instanceof tla2sany.semantic.LetInNode let) {
      var made = new LetInNode(place, isAction(let));
      made.has(
          Arrays.stream(let.getLets()).map(this::symbol).toArray(OpDefNode[]::new), (ExprNode) node(let.getBody()));
      return made;
    }
    if (node instanceof tla2sany.semantic.OpApplNode apply) {
      return application(apply, place);
    }
    return new OtherNode(place, node.getClass().getSimpleName());
  }

  private OpApplNode application(tla2sany.semantic.OpApplNode apply, SemanticNode.Place place) {
    var made = new OpApplNode(place, isAction(apply));
    components.put(apply, made);
    SymbolNode operator = symbol(apply.getOperator());
    if (apply.getBdedQuantBounds() != null && apply.getBdedQuantBounds().length > 0) {
      made.binds(
          Arrays.stream(apply.getBdedQuantSymbolLists()).map(this::parameters).toArray(FormalParamNode[][]::new),
          Arrays.stream(apply.getBdedQuantBounds()).map(this::node).toArray(ExprNode[]::new),
          apply.isBdedQuantATuple().clone());
    }
    made.applies(operator, Arrays.stream(apply.getArgs()).map(this::node).toArray(ExprOrOpArgNode[]::new));
    return made;
  }
}
