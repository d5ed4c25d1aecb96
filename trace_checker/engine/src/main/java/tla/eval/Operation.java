package tla.eval;

/** An operation on integers; a comparison gives 1 or 0. */
enum Operation {
  /** A time of an input; not an operation on integers. */
  TAKE,
  CONSTANT,
  ADD,
  SUBTRACT,
  MULTIPLY,
  DIVIDE,
  MODULO,
  LESS,
  LESS_OR_EQUAL,
  EQUAL;

  int on(int a, int b) {
    return switch (this) {
      case ADD -> Math.addExact(a, b);
      case SUBTRACT -> Math.subtractExact(a, b);
      case MULTIPLY -> Math.multiplyExact(a, b);
      case DIVIDE -> Math.floorDiv(a, b);
      case MODULO -> Builtins.modulo(a, b);
      case LESS -> a < b ? 1 : 0;
      case LESS_OR_EQUAL -> a <= b ? 1 : 0;
      case EQUAL -> a == b ? 1 : 0;
      case CONSTANT -> a;
      case TAKE -> throw new IllegalStateException();
    };
  }

  boolean isComparison() {
    return this == LESS || this == LESS_OR_EQUAL || this == EQUAL;
  }
}
