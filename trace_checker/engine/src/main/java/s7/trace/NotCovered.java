package s7.trace;

/** The specification cannot judge the log; there is no verdict. */
final class NotCovered extends RuntimeException {
  private static final long serialVersionUID = 1L;

  NotCovered(String message) {
    super(message);
  }
}
