package s7.trace;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

import s7.log.Clocks;
import s7.log.Fields;
import s7.log.Format;
import tla.eval.State;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.Value;

/**
 * A log that is asked about while it grows: which lines may come next, when, and by which
 * requirements. It keeps the explanation after each line, so that lines can be taken back.
 *
 * <p>A line is possible if {@link Explanation} explains it. Which lines to try, and at which times,
 * the specification says.
 */
final class Session {
  private final Contract spec;
  private final ArrayList<Explanation> after = new ArrayList<>();
  private final ArrayList<Clocks> clocks = new ArrayList<>();

  /** How often the last question has looked whether a line is possible in a state. */
  private int tries;

  /** Whether the last question has looked at all states. */
  private boolean whole;

  /**
   * Begins a log.
   *
   * @param header the normalised header
   * @throws NotCovered if the header has choices that the specification does not cover
   */
  Session(Contract spec, Fields header) {
    this.spec = spec;
    after.add(new Explanation(spec, header));
    clocks.add(Format.clocksOf(header));
  }

  /** A session with the same lines that goes on by itself. */
  Session branch() {
    return new Session(this, lines());
  }

  /** A session as this one was after so many lines, that goes on by itself. */
  Session until(int lines) {
    if (lines == lines()) {
      return this;
    }
    return new Session(this, lines);
  }

  private Session(Session other, int lines) {
    spec = other.spec;
    after.addAll(other.after.subList(0, lines + 1));
    clocks.addAll(other.clocks.subList(0, lines + 1));
  }

  private Explanation last() {
    return after.get(after.size() - 1);
  }

  /** The number of lines so far. */
  int lines() {
    return after.size() - 1;
  }

  /** The CPU clock after the last line, as a log spells it. */
  String clock() {
    return clocks.get(lines()).reading();
  }

  /** The same in milliseconds since 1990-01-01T00:00. */
  long milliseconds() {
    return clocks.get(lines()).milliseconds();
  }

  /** Clocks that go on by themselves from the last line. */
  private Clocks next() {
    return new Clocks(clocks.get(lines()));
  }

  /**
   * Adds a line.
   *
   * @param line its text
   * @return null if it is explained, else why not; the log then stays as it was
   */
  Explanation.Refusal feed(byte[] line) {
    Clocks then = next();
    Explanation next = last().branch();
    Explanation.Refusal refusal = next.observe(spec.event(spec.format().event(line, then)));
    if (refusal == null) {
      after.add(next);
      clocks.add(then);
    }
    return refusal;
  }

  /** What {@link #feed} would return; the log stays as it is. */
  Explanation.Refusal judge(byte[] line) {
    RecordValue event = spec.event(spec.format().event(line, next()));
    return last().branch().observe(event);
  }

  /** The events of lines without their times. */
  List<Value> timeless(List<byte[]> lines) {
    var events = new ArrayList<Value>();
    for (byte[] line : lines) {
      events.add(spec.event(spec.format().event(line, next()).without(Contract.OF_TIME)));
    }
    return events;
  }

  /**
   * The shortest log of more lines that this session allows and {@code other} does not ({@link Parting}).
   */
  Fields parting(Session other, Parting.Bounds bounds) {
    try {
      return new Parting(spec, last(), other.last(), bounds).search();
    } catch (NotCovered e) {
      throw e;
    } catch (RuntimeException e) {
      throw NotCovered.because("after the last line", e);
    }
  }

  /** Takes lines back until {@code lines} are left. */
  void back(int lines) {
    after.subList(lines + 1, after.size()).clear();
    clocks.subList(lines + 1, clocks.size()).clear();
  }

  /** The situations in which the CPU may be, at most {@code most}. */
  Collection<Fields> situations(int most) {
    var all = new LinkedHashMap<String, Fields>();
    for (State state : last().states()) {
      if (all.size() < most) {
        add(all, spec.situation(state));
      }
    }
    return all.values();
  }

  /** A situation after each number of lines from one to another. */
  List<Fields> states(int from, int to) {
    return after.subList(from, Math.min(to, lines()) + 1).stream().map(Explanation::situation).toList();
  }

  private static void add(Map<String, Fields> all, Fields situation) {
    all.put(situation.toString(), situation);
  }

  /** The situations just before the line, of the states that allow it, at most {@code most}. */
  Collection<Fields> before(byte[] line, int most) {
    try {
      RecordValue event = spec.event(spec.format().event(line, next()));
      var all = new LinkedHashMap<String, Fields>();
      for (State state : last().closure(last().arrivals(event), event)) {
        if (all.size() < most && !spec.observe(state, event).isEmpty()) {
          add(all, spec.situation(state));
        }
      }
      return all.values();
    } catch (Explanation.TooMany e) {
      throw new NotCovered(e.getMessage());
    }
  }

  /** A line that is possible, from one time to another, with its requirements. */
  private final class Offer {
    final int from;
    int until;

    /** By which it is possible at the first of its times. */
    final TreeSet<String> requirements = spec.requirements();

    Offer(int from) {
      this.from = from;
    }
  }

  /**
   * A question about the lines that may come next.
   *
   * @param lines the lines to try, without their times; null for all that the specification offers
   * @param when a line at the only time to look at; null for all at which something happens
   * @param share so many states, and answers of the CPU, are looked at for each line and time
   * @param only the only events of the lines that the specification offers; all if there is none
   * @param few the events of which one line that is possible is enough
   */
  record Question(List<Value> lines, byte[] when, int share, Set<String> only, Set<String> few) {}

  /** The lines that may come next, each with the first and the last time at which it may. */
  Fields possible(Question question) {
    try {
      while (true) {
        try {
          return answer(question);
        } catch (Explanation.TooMany e) {
          last().loosen(e);
        }
      }
    } catch (NotCovered e) {
      throw e;
    } catch (RuntimeException e) {
      throw NotCovered.because("after the last line", e);
    }
  }

  private Fields answer(Question question) {
    Explanation now = last().sample(question.share);
    whole = now.size() == last().size();
    tries = 0;
    List<Times.Time> ordered;
    boolean endless = true;
    if (question.when == null) {
      var times = new Times(spec, now.states(), last().past());
      endless = times.endless();
      ordered = times.all();
    } else {
      RecordValue when = spec.event(spec.format().event(question.when, next()));
      ordered = List.of(new Times.Time(spec.timeOf(when), spec));
    }
    var names = new TreeSet<String>();
    Set<Value> offers = offers(question, now, names);
    var found = new LinkedHashMap<Value, ArrayDeque<Offer>>();
    for (int i = 0; i < ordered.size(); i++) {
      Value clocks = ordered.get(i).clocks();
      List<State> arrived = now.arrivals(spec.instant(clocks));
      var ready = new HashMap<Value, List<State>>();
      var enough = new HashSet<String>();
      for (Value offer : arrived.isEmpty() ? Set.<Value>of() : offers) {
        String name = name(offer);
        if (enough.contains(name)) {
          continue;
        }
        Value kind = spec.likewise(arrived, offer);
        List<State> states =
            ready.computeIfAbsent(
                kind,
                line -> part(now.closure(arrived, spec.dated(line, clocks), question.share), question.share));
        if (tryIn(states, clocks, offer, i, question.share, found) && question.few.contains(name)) {
          enough.add(name);
        }
      }
    }
    return written(ordered, endless, found).put("events", names);
  }

  /** The lines to try; the names of all that the specification offers are added to those. */
  private Set<Value> offers(Question question, Explanation now, Set<String> names) {
    var offers = new LinkedHashSet<Value>();
    if (question.lines != null) {
      offers.addAll(question.lines);
      return offers;
    }
    for (State state : now.states()) {
      for (Value offer : spec.nextLines(state)) {
        String name = name(offer);
        names.add(name);
        if (question.only.isEmpty() || question.only.contains(name)) {
          offers.add(offer);
        }
      }
    }
    return offers;
  }

  private String name(Value line) {
    return (String) spec.name((RecordValue) line.toRcd());
  }

  /** The first of these, as many as a line's share; the answer then is no longer whole. */
  private <T> List<T> part(List<T> all, int share) {
    whole &= all.size() <= share;
    return all.size() <= share ? all : all.subList(0, share);
  }

  /** Whether the line is possible with one of its answers. */
  private boolean tryIn(
      List<State> ready, Value clocks, Value asked, int index, int share, Map<Value, ArrayDeque<Offer>> found) {
    Value past = last().past();
    boolean possible = false;
    for (State state : ready) {
      for (Value line : part(spec.withAnswers(state, asked), share)) {
        RecordValue dated = spec.dated(line, clocks);
        Offer known = found.containsKey(line) ? found.get(line).getLast() : null;
        boolean news = known == null || known.until < index;
        possible |= !news;
        tries++;
        if ((news || known.from == index) && !spec.observe(state, dated).isEmpty()) {
          Offer offer = known == null || known.until < index - 1 ? new Offer(index) : known;
          if (offer != known) {
            found.computeIfAbsent(line, each -> new ArrayDeque<>()).add(offer);
          }
          offer.until = index;
          possible = true;
          if (offer.from == index) {
            spec.whyPossible(state, dated, past).forEach(id -> offer.requirements.add((String) id));
          }
        }
      }
    }
    return possible;
  }

  private Fields written(List<Times.Time> times, boolean endless, Map<Value, ArrayDeque<Offer>> found) {
    var allTimes = new ArrayList<Fields>();
    for (Times.Time time : times) {
      allTimes.add(
          Values.object(time.clocks()).put("due", time.due().values()).put("requirements", time.requirements()));
    }
    var lines = new ArrayList<Fields>();
    found.forEach(
        (line, offers) -> {
          for (Offer offer : offers) {
            boolean ends = offer.until < times.size() - 1 || !endless;
            lines.add(
                new Fields()
                    .put("event", Spelled.line(spec.given(line)))
                    .put("first", offer.from)
                    .put("last", ends ? offer.until : null)
                    .put("requirements", offer.requirements));
          }
        });
    return new Fields()
        .put("times", allTimes)
        .put("endless", endless)
        .put("lines", lines)
        .put("key", key())
        .put("states", last().size())
        .put("whole", whole)
        .put("tries", tries);
  }

  /** The same for logs that can go on in the same ways. */
  private String key() {
    var keys = new TreeSet<Long>();
    last().states().forEach(state -> keys.add(spec.key(state)));
    return keys.toString();
  }
}
