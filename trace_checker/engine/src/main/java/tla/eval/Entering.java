package tla.eval;

import java.util.List;

/** The begin of a LET, or of an operator that is written out: its lazy definitions have no values yet. */
final class Entering implements Expr.Via {
  private final int[] lazy;
  private final Expr body;

  private Entering(int[] lazy, Expr body) {
    this.lazy = lazy;
    this.body = body;
  }

  static Expr of(List<Integer> lazy, Expr body) {
    return lazy.isEmpty() ? body : new Entering(slots(lazy), body);
  }

  static int[] slots(List<Integer> lazy) {
    return lazy.stream().mapToInt(Integer::intValue).toArray();
  }

  static void empty(int[] slots, Object[] frame) {
    for (int slot : slots) {
      frame[slot] = null;
    }
  }

  @Override
  public Object[] enter(Object[] frame) {
    empty(lazy, frame);
    return frame;
  }

  @Override
  public Expr target() {
    return body;
  }
}
