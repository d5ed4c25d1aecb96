package tla.eval;

import tlc2.value.impl.UserObj;
import tlc2.value.impl.UserValue;
import tlc2.value.impl.Value;

/**
 * An integer whose computation a {@link Recording} keeps. For TLC it is no integer: every use of it
 * that the recording does not notice ends in an exception.
 */
final class Sym extends UserValue {
  private static final long serialVersionUID = 1L;

  private static long last;

  final int number;

  /** Its place in an input; null if it was computed. */
  final int[] place;

  /** Another number for each: two that are computed alike count as different values. */
  final long identity = ++last;

  /** Its number among the integers of the recording; -1 before it is used. */
  int register;

  private Sym(int number, int[] place, int register) {
    super(Opaque.ONLY);
    this.number = number;
    this.place = place;
    this.register = register;
  }

  static Sym taken(int number, int[] place) {
    return new Sym(number, place, -1);
  }

  static Sym computed(int number, int register) {
    return new Sym(number, null, register);
  }

  private static final class Opaque extends UserObj {
    static final Opaque ONLY = new Opaque();

    @Override
    public int compareTo(Value other) {
      throw new UnsupportedOperationException("an integer that is being recorded");
    }

    @Override
    public boolean member(Value element) {
      throw new UnsupportedOperationException("an integer that is being recorded");
    }

    @Override
    public boolean isFinite() {
      throw new UnsupportedOperationException("an integer that is being recorded");
    }

    @Override
    public StringBuffer toString(StringBuffer text, int offset, boolean swallow) {
      return text.append("recorded");
    }
  }
}
