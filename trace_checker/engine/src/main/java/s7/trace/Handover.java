package s7.trace;

/** Where one who reads hands over what is to be judged, in its order. By default nothing waits: it is done at once. */
public interface Handover {
  /** Hands over an item, perhaps not before {@link #flush}. */
  void add(Runnable item);

  /** Hands over all that was added. */
  default void flush() {}

  /** Waits until all that was added is done. */
  default void settle() {}
}
