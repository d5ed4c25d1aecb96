package tla.tree;

/** An {@code @}. */
public final class AtNode extends ExprNode {
  private final OpApplNode component;

  public AtNode(Place place, OpApplNode component) {
    super(place, false);
    this.component = component;
  }

  /** The part of the EXCEPT in which it stands. */
  public OpApplNode getExceptComponentRef() {
    return component;
  }
}
