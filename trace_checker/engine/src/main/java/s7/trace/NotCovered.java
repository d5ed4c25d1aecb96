package s7.trace;

/** The specification cannot judge the log; there is no verdict. */
final class NotCovered extends RuntimeException {
  private static final long serialVersionUID = 1L;

  NotCovered(String message) {
    super(message);
  }

  private NotCovered(String message, Throwable cause) {
    super(message, cause);
  }

  /** TLC or the engine could not evaluate the specification {@code where}. */
  static NotCovered because(String where, RuntimeException cause) {
    String said = cause.getMessage() == null ? cause.getClass().getSimpleName() : cause.getMessage();
    return new NotCovered(
        "the specification cannot be evaluated " + where + ": " + said.strip().replaceAll("\\s+", " "),
        cause);
  }
}
