package tla.tree;

/** A node of the graph. */
public abstract class SemanticNode {
  /** No mark. */
  public static final int UNMARKED = -1;

  private final Place place;

  /** The number of the mark by which outcomes of this node are told ({@code tla.eval.Marks}). */
  public int mark = UNMARKED;

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
