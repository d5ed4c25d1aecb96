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

  /** What to say of it, or of an evaluation for which the stack was too small. */
  static String said(Throwable error) {
    return error instanceof StackOverflowError
        ? "the specification goes too deep here for the engine's stack: "
            + "s7check --engine jvm with JDK_JAVA_OPTIONS=-Xss16m has a larger one"
        : error.getMessage();
  }

  /** The specification could not be evaluated {@code where}, such as "at the header". */
  static NotCovered because(String where, RuntimeException cause) {
    String said = cause.getMessage() == null ? cause.getClass().getSimpleName() : cause.getMessage();
    return new NotCovered(
        "the specification cannot be evaluated " + where + ": " + said.strip().replaceAll("\\s+", " "),
        cause);
  }
}
