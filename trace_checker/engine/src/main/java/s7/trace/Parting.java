package s7.trace;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

import s7.log.Fields;
import tla.eval.State;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.Value;

/**
 * The search for the shortest log that one header explains and another does not, breadth first.
 *
 * <p>A log is followed as a pair: the states that explain it under the one header, and those under the other. A line
 * that leaves some of the first and none of the others ends the search. Pairs with the same states go on alike, so
 * one log is followed for each.
 *
 * <p>Its lines are those that the specification offers and some given ones, at the times at which something may change
 * under either header and just behind them.
 */
final class Parting {
  /**
   * What is searched.
   *
   * @param given lines beside those that the specification offers, without a time
   * @param only the only events of the lines that the specification offers; all if there is none
   * @param obs the only OBs of its interrupts, loads and deletions
   * @param deepest the most lines of a log
   * @param most the most pairs that are kept
   */
  record Bounds(List<Value> given, Set<String> only, Set<Integer> obs, int deepest, int most) {}

  /** A log: the pair before its last line, and that line; none for the log without lines. */
  private record Pair(Explanation mine, Explanation theirs, Pair before, RecordValue line, int lines) {}

  private static final Set<String> BY_OB = Set.of("interrupt", "load", "delete");

  private final Contract spec;
  private final Bounds bounds;
  private final Set<List<TreeSet<Long>>> seen = new HashSet<>();
  private final ArrayDeque<Pair> open = new ArrayDeque<>();
  private Pair found;
  private int tried;
  private boolean whole = true;

  /** Begins with the logs that {@code mine} and {@code theirs} explain. */
  Parting(Contract spec, Explanation mine, Explanation theirs, Bounds bounds) {
    this.spec = spec;
    this.bounds = bounds;
    add(new Pair(mine, theirs, null, null, 0));
  }

  /**
   * The log, as {@code lines}, if there is one; {@code complete}: no shorter one has up to so many lines; how many {@code
   * pairs} were kept and lines {@code tried}; {@code whole} is false if a pair had too many states to be followed.
   */
  Fields search() {
    int complete = 0;
    while (found == null && !open.isEmpty() && open.peek().lines < bounds.deepest) {
      complete = open.peek().lines;
      if (seen.size() > bounds.most) {
        return answer(complete);
      }
      follow(open.poll());
    }
    return answer(found != null ? found.lines - 1 : open.isEmpty() ? bounds.deepest : open.peek().lines);
  }

  private Fields answer(int complete) {
    var answer = new Fields();
    if (found != null) {
      answer.put("lines", lines());
    }
    answer.put("complete", complete);
    answer.put("pairs", seen.size());
    answer.put("tried", tried);
    answer.put("whole", whole);
    return answer;
  }

  private Collection<Fields> lines() {
    var lines = new ArrayDeque<Fields>();
    for (Pair pair = found; pair.line != null; pair = pair.before) {
      String at = Spelled.moment(Values.object(spec.timeOf(pair.line)).get("at"));
      lines.push(new Fields().put("at", at).with(Spelled.line(spec.given(pair.line).without("at", "up"))));
    }
    return lines;
  }

  private void follow(Pair pair) {
    try {
      var times = new TreeMap<String, Value>();
      for (Explanation one : List.of(pair.mine, pair.theirs)) {
        times.putAll(new Times(spec, one.states(), one.past()).clocks());
      }
      Set<Value> offers = offers(pair);
      for (Value clocks : times.values()) {
        if (found == null) {
          followAt(pair, clocks, offers);
        }
      }
    } catch (Explanation.TooMany e) {
      whole = false;
    }
  }

  private Set<Value> offers(Pair pair) {
    var offers = new LinkedHashSet<Value>(bounds.given);
    for (State state : pair.mine.states()) {
      for (Value offer : spec.nextLines(state)) {
        if (isInside((RecordValue) offer.toRcd())) {
          offers.add(offer);
        }
      }
    }
    return offers;
  }

  private boolean isInside(RecordValue line) {
    Object name = spec.name(line);
    return (bounds.only.isEmpty() || bounds.only.contains(name))
        && (!BY_OB.contains(name) || bounds.obs.contains(Values.field(line, Contract.OB)));
  }

  private void followAt(Pair pair, Value clocks, Set<Value> offers) {
    RecordValue instant = spec.instant(clocks);
    var mine = new Side(pair.mine, instant);
    var theirs = new Side(pair.theirs, instant);
    if (mine.arrived.isEmpty()) {
      return;
    }
    for (Value offer : offers) {
      for (Value line : mine.withAnswers(offer, clocks)) {
        RecordValue dated = spec.dated(line, clocks);
        tried++;
        List<State> after = mine.after(dated, offer);
        if (!after.isEmpty()) {
          add(new Pair(pair.mine.at(after), pair.theirs.at(theirs.after(dated, offer)), pair, dated, pair.lines + 1));
        }
        if (found != null) {
          return;
        }
      }
    }
  }

  private void add(Pair pair) {
    if (pair.theirs.size() == 0) {
      found = pair;
    } else if (seen.add(List.of(keys(pair.mine), keys(pair.theirs)))) {
      open.add(pair);
    }
  }

  private TreeSet<Long> keys(Explanation one) {
    var keys = new TreeSet<Long>();
    one.states().forEach(state -> keys.add(spec.key(state)));
    return keys;
  }

  /** The states of one header at a time, and after the lines of that time. */
  private final class Side {
    private final Explanation from;
    private final List<State> arrived;
    private final Map<Value, List<State>> ready = new HashMap<>();

    Side(Explanation from, RecordValue instant) {
      this.from = from;
      arrived = from.arrivals(instant);
    }

    private List<State> ready(Value offer, RecordValue dated) {
      return ready.computeIfAbsent(spec.likewise(arrived, offer), kind -> from.closure(arrived, dated));
    }

    Set<Value> withAnswers(Value offer, Value clocks) {
      var lines = new LinkedHashSet<Value>();
      for (State state : ready(offer, spec.dated(offer, clocks))) {
        lines.addAll(spec.withAnswers(state, offer));
      }
      return lines;
    }

    List<State> after(RecordValue dated, Value offer) {
      if (arrived.isEmpty()) {
        return List.of();
      }
      List<State> after = new ArrayList<>();
      for (State state : ready(offer, dated)) {
        after.addAll(spec.observe(state, dated));
      }
      return after;
    }
  }
}
