package tla.tree;

import java.util.function.Supplier;

/** A definition, or an operator of TLA+ itself. */
public final class OpDefNode extends SymbolNode {
  private final boolean defined;
  private final boolean constant;
  private final FormalParamNode[] parameters;
  private Supplier<ExprNode> reading;
  private ExprNode body;

  /**
   * @param defined whether the specification defines it, not TLA+ itself or a standard module
   * @param constant whether its level is that of a constant
   */
  public OpDefNode(Place place, String name, boolean defined, boolean constant, FormalParamNode... parameters) {
    super(place, name);
    this.defined = defined;
    this.constant = constant;
    this.parameters = parameters;
  }

  /** Gives it a body, which is read when it is first needed. */
  public void hasBody(Supplier<ExprNode> read) {
    reading = read;
  }

  /** The expression that it stands for; null for an operator of TLA+ or of a standard module. */
  public ExprNode getBody() {
    if (reading != null) {
      body = reading.get();
      reading = null;
    }
    return body;
  }

  /** Whether the specification defines it, not TLA+ itself or a standard module. */
  public boolean isDefined() {
    return defined;
  }

  /** Whether its level is that of a constant. */
  public boolean isConstant() {
    return constant;
  }

  /** The parameters. */
  public FormalParamNode[] getParams() {
    return parameters;
  }

  /** The number of parameters. */
  public int getArity() {
    return parameters.length;
  }
}
