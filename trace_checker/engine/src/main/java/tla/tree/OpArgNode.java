package tla.tree;

/** An operator as an argument. */
public final class OpArgNode extends ExprOrOpArgNode {
  private final SymbolNode operator;

  public OpArgNode(Place place, SymbolNode operator) {
    super(place);
    this.operator = operator;
  }

  /** The operator. */
  public SymbolNode getOp() {
    return operator;
  }
}
