package tla.eval;

import java.util.BitSet;

import tlc2.value.impl.Value;

/** Keeps the last values of an expression, which holds until a variable that it depends on has another value. */
final class Memo implements Expr {
  /** So many values are kept: those of the states that are looked at in turn, and of those that follow them. */
  private static final int MOST = 4;

  private final Marks marks;
  private final Asked asked;
  private final Value[] state;
  private final int[] variables;
  private final Expr expr;
  private final Values values;

  /** A value, and what it depends on. */
  private static final class Known {
    final Value[] of;
    Value value;
    Marks.Some outcomes;
    BitSet asks;

    Known(Value... of) {
      this.of = of;
    }
  }

  /** The last values of an expression, in the current state and in the next one alike. */
  static final class Values {
    private final Known[] known = new Known[MOST];
    private int latest;
  }

  /**
   * @param marks the outcomes of its evaluation count each time that its value is asked for; null if it has none
   * @param asked what its evaluation asks counts each time as well; null if that is nothing
   * @param state the values of all variables
   * @param variables the numbers of all variables that the expression may depend on
   */
  Memo(Marks marks, Asked asked, Value[] state, int[] variables, Expr expr, Values values) {
    this.marks = marks;
    this.asked = asked;
    this.state = state;
    this.variables = variables;
    this.expr = expr;
    this.values = values;
  }

  @Override
  public Value eval(Object[] frame) {
    for (int i = 0; i < MOST; i++) {
      int place = values.latest + i & MOST - 1;
      Known known = values.known[place];
      if (known != null && isSame(known)) {
        values.latest = place;
        if (marks != null) {
          marks.add(known.outcomes);
        }
        if (asked != null) {
          asked.add(known.asks);
        }
        return known.value;
      }
    }
    Known news = evaluated(frame);
    values.latest = values.latest + MOST - 1 & MOST - 1;
    values.known[values.latest] = news;
    return news.value;
  }

  private Known evaluated(Object[] frame) {
    var of = new Value[variables.length];
    for (int i = 0; i < of.length; i++) {
      of[i] = state[variables[i]];
    }
    var news = new Known(of);
    // Where an error ends the evaluation, the next one begins anew.
    BitSet before = asked == null ? null : asked.begin();
    if (marks != null) {
      marks.begin();
    }
    news.value = expr.eval(frame);
    if (marks != null) {
      news.outcomes = marks.end();
    }
    if (asked != null) {
      news.asks = asked.end(before);
    }
    return news;
  }

  private boolean isSame(Known known) {
    for (int i = 0; i < variables.length; i++) {
      if (known.of[i] != state[variables[i]]) {
        return false;
      }
    }
    return true;
  }
}
