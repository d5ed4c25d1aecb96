package tla.tree;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

import util.UniqueString;

/** Makes the bytes of a graph for {@link Kept}. */
final class Keeping {
  private final Module module;
  private final List<String> strings;
  private final Map<String, Integer> numbers = new HashMap<>();
  private final Map<SymbolNode, Integer> definitions = new IdentityHashMap<>();
  private final Map<SymbolNode, Integer> parameters = new IdentityHashMap<>();
  private final Map<SymbolNode, Integer> declared = new IdentityHashMap<>();
  private final Map<OpApplNode, Integer> components = new IdentityHashMap<>();
  private final List<OpDefNode> order = new ArrayList<>();
  private final List<FormalParamNode> bound = new ArrayList<>();
  private final List<OpDeclNode> others = new ArrayList<>();
  private final Map<SemanticNode, Integer> places = new IdentityHashMap<>();
  private final Bytes locations = new Bytes();
  private int located;

  private Keeping(Module module) {
    this.module = module;
    var all = new HashSet<String>();
    module.definitions().forEach(each -> collect(each, all, new HashSet<>()));
    for (OpDeclNode variable : module.getVariableDecls()) {
      all.add(variable.getName());
      all.add(variable.getLocation().source());
    }
    all.addAll(module.markedFor());
    all.addAll(module.texts().keySet());
    // TLC orders strings by their numbers, which they get one after the other.
    strings =
        all.stream().sorted(Comparator.comparingInt(each -> UniqueString.uniqueStringOf(each).getTok())).toList();
    for (String each : strings) {
      numbers.put(each, numbers.size());
    }
  }

  static byte[] bytes(Module module) {
    byte[] bytes = new Keeping(module).bytes();
    return ByteBuffer.allocate(Integer.BYTES + bytes.length).putInt(Kept.sum(bytes, 0)).put(bytes).array();
  }

  private void collect(SymbolNode symbol, Set<String> into, Set<SymbolNode> seen) {
    into.add(symbol.getName());
    into.add(symbol.getLocation().source());
    if (symbol instanceof OpDefNode definition && seen.add(symbol)) {
      for (FormalParamNode each : definition.getParams()) {
        collect(each, into, seen);
      }
      collect(definition.getBody(), into, seen);
    }
  }

  private void collect(SemanticNode node, Set<String> into, Set<SymbolNode> seen) {
    if (node == null) {
      return;
    }
    into.add(node.getLocation().source());
    if (node instanceof StringNode string) {
      into.add(string.getRep().toString());
    } else if (node instanceof OtherNode other) {
      into.add(other.kind());
    } else if (node instanceof OpArgNode argument) {
      collect(argument.getOp(), into, seen);
    } else if (node instanceof LetInNode let) {
      for (OpDefNode each : let.getLets()) {
        collect(each, into, seen);
      }
      collect(let.getBody(), into, seen);
    } else if (node instanceof OpApplNode apply) {
      collect(apply.getOperator(), into, seen);
      for (SemanticNode each : apply.getArgs()) {
        collect(each, into, seen);
      }
      for (int i = 0; apply.getBdedQuantBounds() != null && i < apply.getBdedQuantBounds().length; i++) {
        collect(apply.getBdedQuantBounds()[i], into, seen);
        for (FormalParamNode each : apply.getBdedQuantSymbolLists()[i]) {
          collect(each, into, seen);
        }
      }
    }
  }

  private byte[] bytes() {
    for (OpDeclNode variable : module.getVariableDecls()) {
      number(variable);
    }
    int variables = others.size();
    module.definitions().forEach(this::number);
    int top = order.size();
    var bodies = new Bytes();
    var heads = new Bytes();
    // More definitions come with the bodies.
    for (int i = 0; i < order.size(); i++) {
      definition(order.get(i), heads, bodies);
    }
    var all = new Bytes();
    all.number(Kept.FORM);
    all.number(strings.size());
    for (String each : strings) {
      all.text(each);
    }
    all.number(others.size());
    all.number(variables);
    for (OpDeclNode each : others) {
      symbol(each, all);
    }
    all.number(bound.size());
    for (FormalParamNode each : bound) {
      symbol(each, all);
    }
    all.number(components.size());
    all.number(order.size());
    all.number(top);
    all.writeBytes(heads.toByteArray());
    all.number(module.markedFor().size());
    module.markedFor().stream().sorted().forEach(each -> all.number(numbers.get(each)));
    all.number(module.marked().size());
    for (Module.Marked each : module.marked()) {
      all.number(each.kind());
      all.number(definitions.get(each.definition()));
      all.number(each.node() == each.definition() ? 0 : 1 + places.get(each.node()));
    }
    all.number(module.texts().size());
    module.texts().forEach(
        (name, text) -> {
          all.number(numbers.get(name));
          all.text(text.get());
        });
    all.number(bodies.size());
    all.writeBytes(bodies.toByteArray());
    all.writeBytes(locations.toByteArray());
    return all.toByteArray();
  }

  private void symbol(SymbolNode symbol, Bytes to) {
    to.number(numbers.get(symbol.getName()));
    to.number(place(symbol));
  }

  /** The number of a place, which the location has from now on. */
  private int place(SemanticNode node) {
    Location at = node.getLocation();
    short16(numbers.get(at.source()));
    short16(at.beginLine());
    short16(at.beginColumn());
    short16(at.endLine());
    short16(at.endColumn());
    places.put(node, located);
    return located++;
  }

  private void short16(int number) {
    locations.write(number >>> 8);
    locations.write(number);
  }

  private void definition(OpDefNode definition, Bytes heads, Bytes bodies) {
    symbol(definition, heads);
    boolean hasBody = definition.getBody() != null;
    heads.number((hasBody ? 1 : 0) | (definition.isDefined() ? 2 : 0) | (definition.isConstant() ? 4 : 0));
    heads.number(definition.mark + 1);
    heads.number(definition.getParams().length);
    for (FormalParamNode each : definition.getParams()) {
      heads.number(number(each));
    }
    if (hasBody) {
      heads.number(bodies.size());
      heads.number(located);
      node(definition.getBody(), bodies);
    }
  }

  private int number(SymbolNode symbol) {
    if (symbol instanceof OpDefNode definition) {
      return number(definition, definitions, order);
    }
    return symbol instanceof FormalParamNode parameter
        ? number(parameter, parameters, bound)
        : number((OpDeclNode) symbol, declared, others);
  }

  private static <T extends SymbolNode> int number(T symbol, Map<SymbolNode, Integer> known, List<T> all) {
    Integer number = known.get(symbol);
    if (number == null) {
      number = all.size();
      known.put(symbol, number);
      all.add(symbol);
    }
    return number;
  }

  private void reference(SymbolNode symbol, Bytes to) {
    int kind = symbol instanceof OpDefNode ? Kept.DEFINITION : symbol instanceof FormalParamNode ? Kept.PARAMETER : Kept.DECLARED;
    to.number(number(symbol) << 2 | kind);
  }

  private void node(SemanticNode node, Bytes to) {
    if (node == null) {
      to.write(Kept.NOTHING);
      return;
    }
    place(node);
    int flags = node.mark == SemanticNode.UNMARKED ? 0 : Kept.MARKED;
    flags |= node instanceof ExprNode expr && expr.isAction() ? Kept.ACTION : 0;
    if (node instanceof OpApplNode apply) {
      application(apply, flags, to);
    } else if (node instanceof NumeralNode numeral) {
      begin(Kept.NUMERAL | flags, node, to);
      to.number(numeral.val());
    } else if (node instanceof StringNode string) {
      begin(Kept.STRING | flags, node, to);
      to.number(numbers.get(string.getRep().toString()));
    } else if (node instanceof AtNode at) {
      begin(Kept.AT | flags, node, to);
      to.number(components.get(at.getExceptComponentRef()));
    } else if (node instanceof OpArgNode argument) {
      begin(Kept.OPERATOR | flags, node, to);
      reference(argument.getOp(), to);
    } else if (node instanceof LetInNode let) {
      begin(Kept.LET | flags, node, to);
      to.number(let.getLets().length);
      for (OpDefNode each : let.getLets()) {
        to.number(number(each));
      }
      node(let.getBody(), to);
    } else {
      begin(Kept.OTHER | flags, node, to);
      to.number(numbers.get(((OtherNode) node).kind()));
    }
  }

  private static void begin(int kind, SemanticNode node, Bytes to) {
    to.write(kind);
    if ((kind & Kept.MARKED) != 0) {
      to.number(node.mark);
    }
  }

  private void application(OpApplNode apply, int flags, Bytes to) {
    Integer component = components.get(apply);
    int bounds = apply.getBdedQuantBounds() == null ? 0 : apply.getBdedQuantBounds().length;
    begin(
        Kept.APPLICATION | flags | (component == null ? 0 : Kept.COMPONENT) | (bounds == 0 ? 0 : Kept.BINDS), apply, to);
    if (component != null) {
      to.number(component);
    }
    reference(apply.getOperator(), to);
    if (bounds > 0) {
      to.number(bounds);
      for (int i = 0; i < bounds; i++) {
        to.write(apply.isBdedQuantATuple()[i] ? 1 : 0);
        to.number(apply.getBdedQuantSymbolLists()[i].length);
        for (FormalParamNode each : apply.getBdedQuantSymbolLists()[i]) {
          to.number(number(each));
        }
        node(apply.getBdedQuantBounds()[i], to);
      }
    }
    if (apply.getOperator().getName().equals("$Except")) {
      // An @ in it stands for the part, which comes first.
      for (int i = 1; i < apply.getArgs().length; i++) {
        components.put((OpApplNode) apply.getArgs()[i], components.size());
      }
    }
    to.number(apply.getArgs().length);
    for (SemanticNode each : apply.getArgs()) {
      node(each, to);
    }
  }
}
