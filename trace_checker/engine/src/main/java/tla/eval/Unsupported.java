package tla.eval;

/** A construct of TLA+ that the compiler leaves to TLC's interpreter. */
final class Unsupported extends RuntimeException {
  private static final long serialVersionUID = 1;

  Unsupported(String what) {
    super(what);
  }
}
