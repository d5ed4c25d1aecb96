package tla.tree;

/** An argument of an operator. */
public abstract class ExprOrOpArgNode extends SemanticNode {
  ExprOrOpArgNode(Place place) {
    super(place);
  }
}
