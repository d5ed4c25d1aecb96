package tla.tree;

/** An expression. */
public abstract class ExprNode extends ExprOrOpArgNode {
  private final boolean action;

  ExprNode(Place place, boolean action) {
    super(place);
    this.action = action;
  }

  /** Whether it is an action, by its level: it refers to the next state, or is temporal. */
  public boolean isAction() {
    return action;
  }
}
