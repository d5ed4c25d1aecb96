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
  private Collection first = new Collection(0, null);
  private Collection now = first;
  private long[] path = {};

  /** Outcomes that are collected. Collections are used again: most evaluations have few outcomes of all. */
  private static final class Collection {
    final long[] words;

    /** A bit for each word that is not 0. */
    final long[] used;

    final Collection outer;
    Collection inner;

    Collection(int size, Collection outer) {
      words = new long[size];
      used = new long[(size + 63) / 64];
      this.outer = outer;
    }

    void add(int place, long bits) {
      words[place] |= bits;
      used[place >> 6] |= 1L << place;
    }

    /** Its outcomes, of which it then has none. */
    Some taken() {
      int count = 0;
      for (long each : used) {
        count += Long.bitCount(each);
      }
      var places = new int[count];
      var taken = new long[count];
      int to = 0;
      for (int i = 0; i < used.length; i++) {
        for (long rest = used[i]; rest != 0; rest &= rest - 1) {
          int place = 64 * i + Long.numberOfTrailingZeros(rest);
          places[to] = place;
          taken[to++] = words[place];
          words[place] = 0;
        }
        used[i] = 0;
      }
      return new Some(places, taken);
    }
  }

  /**
   * Has outcomes collected, before anything is compiled.
   *
   * @param marks the number of marks on expressions and definitions
   */
  void set(int marks) {
    first = new Collection((2 * marks + 63) / 64, null);
    now = first;
    path = first.words.clone();
  }

  /** Whether outcomes are collected; another evaluator may have marked the same nodes. */
  boolean isSet() {
    return path.length > 0;
  }

  /** Begins to collect anew, until {@link #end}. */
  void begin() {
    if (now.inner == null) {
      now.inner = new Collection(now.words.length, now);
    }
    now = now.inner;
  }

  /** Returns the collection that was begun, and goes on with the one before, which gets it too. */
  Some end() {
    Some own = now.taken();
    now = now.outer;
    add(own);
    return own;
  }

  /** The outcomes of an evaluation: a few of all that there are. */
  static final class Some {
    private final int[] places;
    private final long[] words;

    private Some(int[] places, long[] words) {
      this.places = places;
      this.words = words;
    }

    /** These outcomes and others; {@code others} itself if it has them all. */
    long[] with(long[] others) {
      long[] all = others;
      for (int i = 0; i < places.length; i++) {
        if ((words[i] & ~all[places[i]]) != 0) {
          all = all == others ? others.clone() : all;
          all[places[i]] |= words[i];
        }
      }
      return all;
    }
  }

  /** Adds the outcomes of an evaluation whose value was kept. */
  void add(Some outcomes) {
    for (int i = 0; i < outcomes.places.length; i++) {
      now.add(outcomes.places[i], outcomes.words[i]);
    }
  }

  /** The actions that are under way, as a successor is found, with the outcomes before them; null for none. */
  long[] pathAfter(long[] before) {
    return before == null ? path.clone() : union(before, path);
  }

  /** No action is under way, and no evaluation, of which an error may have ended some. */
  void restart() {
    Arrays.fill(path, 0);
    while (now != first) {
      now.taken();
      now = now.outer;
    }
  }

  private void note(int place, long bit) {
    Collection to = now;
    if ((to.words[place] & bit) == 0) {
      to.add(place, bit);
    }
  }

  /** The compiled expression, which tells its outcomes if it is marked, or if its operator is. */
  Expr telling(SemanticNode node, Expr expr) {
    Expr of = node instanceof OpApplNode apply ? marked(apply.getOperator(), expr) : expr;
    return marked(node, of);
  }

  private Expr marked(SemanticNode node, Expr expr) {
    int mark = isSet() ? node.mark : SemanticNode.UNMARKED;
    if (mark == SemanticNode.UNMARKED) {
      return expr;
    }
    int place = 2 * mark >> 6;
    long yes = 1L << 2 * mark;
    if (expr instanceof Expr.Test) {
      return (Expr.Test) f -> told(place, yes, expr.test(f));
    }
    if (expr instanceof Expr.Num) {
      return (Expr.Num)
          f -> {
            note(place, yes);
            return expr.number(f);
          };
    }
    return new Telling(place, yes, expr);
  }

  private boolean told(int place, long yes, boolean truth) {
    note(place, truth ? yes : yes << 1);
    return truth;
  }

  /** An expression of which only its evaluation shows whether it is a truth value. */
  private final class Telling implements Expr {
    private final int place;
    private final long yes;
    private final Expr expr;

    Telling(int place, long yes, Expr expr) {
      this.place = place;
      this.yes = yes;
      this.expr = expr;
    }

    @Override
    public Value eval(Object[] frame) {
      Value value = expr.eval(frame);
      told(place, yes, !(value instanceof BoolValue truth) || truth.val);
      return value;
    }

    @Override
    public boolean test(Object[] frame) {
      return told(place, yes, expr.test(frame));
    }

    @Override
    public int number(Object[] frame) {
      note(place, yes);
      return expr.number(frame);
    }
  }

  /** The compiled action; if its operator is marked, it is under way while its successors are found. */
  Actions.Act underWay(SymbolNode operator, Actions.Act act) {
    int mark = isSet() ? operator.mark : SemanticNode.UNMARKED;
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
