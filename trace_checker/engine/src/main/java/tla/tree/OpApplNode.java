package tla.tree;

/** An application of an operator, also of one of TLA+ such as {@code $ConjList}. */
public final class OpApplNode extends ExprNode {
  private SymbolNode operator;
  private ExprOrOpArgNode[] arguments;
  private FormalParamNode[][] symbols;
  private ExprNode[] bounds;
  private boolean[] tuples;

  public OpApplNode(Place place, boolean action) {
    super(place, action);
  }

  /** Gives it its operator and arguments. */
  public void applies(SymbolNode to, ExprOrOpArgNode... args) {
    operator = to;
    arguments = args;
  }

  /** Gives it the sets of bound variables. */
  public void binds(FormalParamNode[][] names, ExprNode[] sets, boolean[] areTuples) {
    symbols = names;
    bounds = sets;
    tuples = areTuples;
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
