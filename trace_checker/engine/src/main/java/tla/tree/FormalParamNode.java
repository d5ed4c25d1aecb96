package tla.tree;

/** A parameter of a definition, or a bound variable. */
public final class FormalParamNode extends SymbolNode {
  public FormalParamNode(Place place, String name) {
    super(place, name);
  }
}
