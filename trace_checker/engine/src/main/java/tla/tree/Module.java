package tla.tree;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;

/** A module with all that it extends. */
public final class Module {
  private final Map<String, Supplier<String>> texts;
  private final OpDeclNode[] variables;
  private final Map<String, OpDefNode> definitions = new HashMap<>();

  private Set<String> markedFor = Set.of();
  private List<Marked> marked = List.of();

  /**
   * A node that is marked; its mark is its place in the list of all of them.
   *
   * @param kind a number for the kind of mark
   * @param definition the definition that is marked, or in which the node stands
   */
  public record Marked(int kind, OpDefNode definition, SemanticNode node) {}

  /**
   * @param texts the texts of those modules that are not TLA+'s own
   */
  public Module(Map<String, Supplier<String>> texts, OpDeclNode[] variables, OpDefNode... definitions) {
    this.texts = texts;
    this.variables = variables;
    for (OpDefNode each : definitions) {
      this.definitions.put(each.getName(), each);
    }
  }

  /** A definition; null if there is none of this name. */
  public OpDefNode getOpDef(String name) {
    return definitions.get(name);
  }

  /** The texts of those modules that are not TLA+'s own, by their names. */
  public Map<String, Supplier<String>> texts() {
    return texts;
  }

  /** The variables, in the order of their declarations. */
  public OpDeclNode[] getVariableDecls() {
    return variables.clone();
  }

  /** Marks nodes for operators with these names. */
  public void mark(Set<String> names, List<Marked> nodes) {
    for (int i = 0; i < nodes.size(); i++) {
      nodes.get(i).node().mark = i;
    }
    has(names, nodes);
  }

  /** It has these marks already. */
  void has(Set<String> names, List<Marked> nodes) {
    markedFor = Set.copyOf(names);
    marked = List.copyOf(nodes);
  }

  /** The names of the operators for which nodes are marked. */
  public Set<String> markedFor() {
    return markedFor;
  }

  /** The nodes that are marked. */
  public List<Marked> marked() {
    return marked;
  }

  /** All definitions. */
  Iterable<OpDefNode> definitions() {
    return definitions.values();
  }
}
