package s7.trace;

/** Where one who reads hands over what is to be judged, in its order. */
public interface Handover {
  /** Everything is done at once. */
  Handover AT_ONCE =
      new Handover() {
        @Override
        public void add(Runnable item) {
          item.run();
        }

        @Override
        public void flush() {
          // Nothing waits.
        }

        @Override
        public void settle() {
          // Nothing waits.
        }
      };

  /** Hands over an item, perhaps not before {@link #flush}. */
  void add(Runnable item);

  /** Hands over all that was added. */
  void flush();

  /** Waits until all that was added is done. */
  void settle();
}
