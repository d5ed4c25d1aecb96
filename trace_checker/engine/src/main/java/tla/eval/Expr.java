package tla.eval;

import tlc2.value.impl.BoolValue;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.Value;

/**
 * A compiled expression. Its parameters and bound variables are in the frame, the variables of the
 * specification in the {@link Machine}.
 *
 * <p>An expression without a value ends in a RuntimeException of any kind.
 */
interface Expr {
  Value eval(Object[] frame);

  /** The value of an expression that is TRUE or FALSE. */
  default boolean test(Object[] frame) {
    return ((BoolValue) eval(frame)).val;
  }

  /** The value of an expression that is an integer. */
  default int number(Object[] frame) {
    return ((IntValue) eval(frame)).val;
  }

  /** An expression that is known to be TRUE or FALSE. */
  interface Test extends Expr {
    @Override
    boolean test(Object[] frame);

    @Override
    default Value eval(Object[] frame) {
      return test(frame) ? BoolValue.ValTrue : BoolValue.ValFalse;
    }
  }

  /** An expression that is known to be an integer. */
  interface Num extends Expr {
    @Override
    int number(Object[] frame);

    @Override
    default Value eval(Object[] frame) {
      return IntValue.gen(number(frame));
    }
  }

  /** An expression with the value of another expression, evaluated in a frame that it chooses. */
  interface Via extends Expr {
    /** Prepares a frame and returns it; {@link #target} is evaluated in it. */
    Object[] enter(Object[] frame);

    Expr target();

    @Override
    default Value eval(Object[] frame) {
      return target().eval(enter(frame));
    }

    @Override
    default boolean test(Object[] frame) {
      return target().test(enter(frame));
    }

    @Override
    default int number(Object[] frame) {
      return target().number(enter(frame));
    }
  }
}
