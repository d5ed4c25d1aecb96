package tla.tree;

import util.UniqueString;

/** A string. */
public final class StringNode extends ExprNode {
  private final UniqueString text;

  public StringNode(Place place, UniqueString text) {
    super(place, false);
    this.text = text;
  }

  /** The text. */
  public UniqueString getRep() {
    return text;
  }
}
