package tla.eval;

import java.util.Arrays;

import tla.tree.OpApplNode;
import tla.tree.SemanticNode;
import tla.tree.SymbolNode;
import tlc2.value.impl.BoolValue;
import tlc2.value.impl.Value;

/**
 * Tells to which marked expressions the search for successors comes, and with which outcome.
 *
 * <p>Mark k has two outcomes: bit 2k, the expression is TRUE, or has a value that is no truth value, or
 * is an action and taken; bit 2k + 1, it is FALSE. Sets of outcomes are arrays of 64 bits each.
 */
final class Marks {
  private static final long[] NONE = {};

  private long[] now = NONE;
  private long[] path = NONE;

  /**
   * Has outcomes collected, before anything is compiled.
   *
   * @param marks the number of marks on expressions and definitions
   */
  void set(int marks) {
    now = new long[(2 * marks + 63) / 64];
    path = now.clone();
  }

  /** Begins to collect anew, and returns the collection so far for {@link #end}. */
  long[] begin() {
    long[] outer = now;
    now = new long[outer.length];
    return outer;
  }

  /** Returns the collection that was begun, and goes on with the one before, which gets it too. */
  long[] end(long[] outer) {
    long[] own = now;
    now = outer;
    add(own);
    return own;
  }

  private void add(long[] outcomes) {
    for (int i = 0; i < outcomes.length; i++) {
      now[i] |= outcomes[i];
    }
  }

  /** The outcomes of an evaluation whose value is kept: a few of all that there are. */
  static final class Some {
    private final int[] places;
    private final long[] words;

    Some(long[] outcomes) {
      int count = 0;
      for (long each : outcomes) {
        count += each == 0 ? 0 : 1;
      }
      places = new int[count];
      words = new long[count];
      for (int i = outcomes.length - 1; count > 0; i--) {
        if (outcomes[i] != 0) {
          places[--count] = i;
          words[count] = outcomes[i];
        }
      }
    }
  }

  /** Adds the outcomes of an evaluation whose value was kept. */
  void add(Some outcomes) {
    for (int i = 0; i < outcomes.places.length; i++) {
      now[outcomes.places[i]] |= outcomes.words[i];
    }
  }

  /** The actions that are under way, as a successor is found, with the outcomes before them; null for none. */
  long[] pathAfter(long[] before) {
    return before == null ? path.clone() : union(before, path);
  }

  /** No action is under way. */
  void restart() {
    Arrays.fill(path, 0);
  }

  private void note(int bit) {
    now[bit >> 6] |= 1L << bit;
  }

  /** The compiled expression, which tells its outcomes if it is marked, or if its operator is. */
  Expr telling(SemanticNode node, Expr expr) {
    Expr of = node instanceof OpApplNode apply ? marked(apply.getOperator(), expr) : expr;
    return marked(node, of);
  }

  private Expr marked(SemanticNode node, Expr expr) {
    int mark = now.length == 0 ? SemanticNode.UNMARKED : node.mark;
    if (mark == SemanticNode.UNMARKED) {
      return expr;
    }
    if (expr instanceof Expr.Test) {
      return (Expr.Test) f -> told(mark, expr.test(f));
    }
    if (expr instanceof Expr.Num) {
      return (Expr.Num)
          f -> {
            note(2 * mark);
            return expr.number(f);
          };
    }
    return new Telling(mark, expr);
  }

  private boolean told(int mark, boolean truth) {
    note(truth ? 2 * mark : 2 * mark + 1);
    return truth;
  }

  /** An expression of which only its evaluation shows whether it is a truth value. */
  private final class Telling implements Expr {
    private final int mark;
    private final Expr expr;

    Telling(int mark, Expr expr) {
      this.mark = mark;
      this.expr = expr;
    }

    @Override
    public Value eval(Object[] frame) {
      Value value = expr.eval(frame);
      told(mark, !(value instanceof BoolValue truth) || truth.val);
      return value;
    }

    @Override
    public boolean test(Object[] frame) {
      return told(mark, expr.test(frame));
    }

    @Override
    public int number(Object[] frame) {
      note(2 * mark);
      return expr.number(frame);
    }
  }

  /** The compiled action; if its operator is marked, it is under way while its successors are found. */
  Actions.Act underWay(SymbolNode operator, Actions.Act act) {
    int mark = now.length == 0 ? SemanticNode.UNMARKED : operator.mark;
    if (mark == SemanticNode.UNMARKED) {
      return act;
    }
    int word = 2 * mark >> 6;
    long bit = 1L << 2 * mark;
    return f -> {
      long before = path[word];
      path[word] = before | bit;
      act.run(f);
      path[word] = before;
    };
  }

  /** All outcomes of both; {@code a} itself if {@code b} adds none. Null stands for none. */
  static long[] union(long[] a, long[] b) {
    if (a == null || b == null) {
      return a == null ? b : a;
    }
    long[] all = a;
    for (int i = 0; i < b.length; i++) {
      if ((b[i] & ~all[i]) != 0) {
        all = all == a ? a.clone() : all;
        all[i] |= b[i];
      }
    }
    return all;
  }

  /** The outcomes that both have. Null stands for none. */
  static long[] common(long[] a, long[] b) {
    if (a == null || b == null) {
      return null;
    }
    long[] both = a;
    for (int i = 0; i < a.length; i++) {
      if ((a[i] & ~b[i]) != 0) {
        both = both == a ? a.clone() : both;
        both[i] &= b[i];
      }
    }
    return both;
  }
}
