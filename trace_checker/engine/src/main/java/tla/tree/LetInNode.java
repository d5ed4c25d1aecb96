package tla.tree;

/** A LET. */
public final class LetInNode extends ExprNode {
  OpDefNode[] definitions;
  ExprNode body;

  LetInNode(Place place, boolean action) {
    super(place, action);
  }

  /** The definitions. */
  public OpDefNode[] getLets() {
    return definitions;
  }

  /** The expression after IN. */
  public ExprNode getBody() {
    return body;
  }
}
