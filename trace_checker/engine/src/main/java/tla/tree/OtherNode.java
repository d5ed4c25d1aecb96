package tla.tree;

/** An expression that is not evaluated. */
public final class OtherNode extends ExprNode {
  private final String kind;

  public OtherNode(Place place, String kind) {
    super(place, false);
    this.kind = kind;
  }

  /** SANY's name for its kind. */
  public String kind() {
    return kind;
  }
}
