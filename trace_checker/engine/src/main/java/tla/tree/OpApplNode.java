package tla.tree;

/** An application of an operator, also of one of TLA+ such as {@code $ConjList}. */
public final class OpApplNode extends ExprNode {
  SymbolNode operator;
  ExprOrOpArgNode[] arguments;
  FormalParamNode[][] symbols;
  ExprNode[] bounds;
  boolean[] tuples;

  OpApplNode(Place place, boolean action) {
    super(place, action);
  }

  /** The operator. */
  public SymbolNode getOperator() {
    return operator;
  }

  /** The arguments; null in the place of a condition OTHER. */
  public ExprOrOpArgNode[] getArgs() {
    return arguments;
  }

  /** The bound variables of each set of {@link #getBdedQuantBounds}; null if nothing is bound. */
  public FormalParamNode[][] getBdedQuantSymbolLists() {
    return symbols;
  }

  /** The sets of bound variables; null if nothing is bound. */
  public ExprNode[] getBdedQuantBounds() {
    return bounds;
  }

  /** For each set whether its variables are a tuple. */
  public boolean[] isBdedQuantATuple() {
    return tuples;
  }
}
