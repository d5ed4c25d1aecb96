package tla.tree;

/** A number. */
public final class NumeralNode extends ExprNode {
  private final int number;

  public NumeralNode(Place place, int number) {
    super(place, false);
    this.number = number;
  }

  /** The number. */
  public int val() {
    return number;
  }
}
