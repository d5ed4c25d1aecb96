package tla.tree;

/** A node of the graph. */
public abstract class SemanticNode {
  /** No mark. */
  public static final int UNMARKED = -1;

  private final Place place;

  /** The number of the mark by which outcomes of this node are told ({@code tla.eval.Marks}). */
  public int mark = UNMARKED;

  /** What an evaluator has found out about this node ({@code tla.eval.Facts}): a map of nodes is slower. */
  public Object facts;

  /** Where a node stands, which few ask. */
  public interface Place {
    Location location();
  }

  SemanticNode(Place place) {
    this.place = place;
  }

  /** Where the node stands. */
  public Location getLocation() {
    return place.location();
  }
}
