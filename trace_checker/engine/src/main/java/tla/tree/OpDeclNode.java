package tla.tree;

/** A variable or a constant. */
public final class OpDeclNode extends SymbolNode {
  public OpDeclNode(Place place, String name) {
    super(place, name);
  }
}
