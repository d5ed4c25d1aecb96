package tla.tree;

/** A LET. */
public final class LetInNode extends ExprNode {
  private OpDefNode[] definitions;
  private ExprNode body;

  public LetInNode(Place place, boolean action) {
    super(place, action);
  }

  /** Gives it its parts. */
  public void has(OpDefNode[] lets, ExprNode in) {
    definitions = lets;
    body = in;
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
