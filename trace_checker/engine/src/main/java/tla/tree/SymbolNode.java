package tla.tree;

/** A name. */
public abstract class SymbolNode extends SemanticNode {
  private final String name;

  SymbolNode(Place place, String name) {
    super(place);
    this.name = name;
  }

  /** The name. */
  public String getName() {
    return name;
  }
}
