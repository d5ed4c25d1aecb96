package tla.eval;

import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

import tla.tree.SymbolNode;
import tlc2.value.impl.StringValue;
import tlc2.value.impl.Value;

/**
 * The strings with which one operator was applied. An evaluation that is remembered counts as one that
 * is made: whoever keeps its value keeps what it asked, too.
 */
final class Asked {
  private SymbolNode operator;
  private final Map<String, Integer> numbers = new HashMap<>();
  private BitSet now = new BitSet();
  private boolean incomplete;

  /** Watches an operator whose last argument is a string; before anything is compiled. */
  void watch(SymbolNode watched) {
    operator = watched;
  }

  boolean isWatched(SymbolNode other) {
    return other == operator;
  }

  void note(Value string) {
    now.set(numbers.computeIfAbsent(((StringValue) string).val.toString(), each -> numbers.size()));
  }

  /** An evaluation was made of which nobody knows what it asked. */
  void miss() {
    incomplete = true;
  }

  /** Begins anew. */
  void clear() {
    now = new BitSet();
    incomplete = false;
  }

  /** Begins to collect apart, and returns the collection so far for {@link #end}. */
  BitSet begin() {
    BitSet outer = now;
    now = new BitSet();
    return outer;
  }

  /** Returns the collection that was begun, and goes on with the one before, which gets it too. */
  BitSet end(BitSet outer) {
    BitSet own = now;
    drop(outer);
    add(own);
    return own;
  }

  /** Forgets the collection that was begun, and goes on with the one before. */
  void drop(BitSet outer) {
    now = outer;
  }

  /** Adds what an evaluation asked whose value was kept. */
  void add(BitSet asked) {
    now.or(asked);
  }

  /** The collection under way; nothing is ever taken out of it. */
  BitSet collection() {
    return now;
  }

  /** The strings since {@link #clear}; null if there may be others. */
  Set<String> all() {
    if (operator == null || incomplete) {
      return null;
    }
    var all = new TreeSet<String>();
    numbers.forEach(
        (string, number) -> {
          if (now.get(number)) {
            all.add(string);
          }
        });
    return all;
  }
}
