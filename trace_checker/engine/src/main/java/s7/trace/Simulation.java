package s7.trace;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;

import s7.log.Days;
import s7.log.Fields;
import s7.log.Unusable;
import tla.eval.Hash;
import tlc2.value.impl.Value;

/**
 * A run of a program of the kit: {@link #choices} has the possible next events, {@link #take} takes one, until there is
 * no choice. What the CPU may do, and when, is asked of the specification at every step.
 *
 * <p>Everything happens as early as it may: OBs before events from outside, those before the steps of the program. At
 * random, OBs start up to the latency late.
 */
final class Simulation {
  /** The choice that the CPU lets something be that need not come now. The others are lines without their time. */
  static final Fields NOTHING = new Fields();

  private static final String FORMAT = "s7-interrupt-log/1";
  private static final int LATENCY = 10;

  /** Lines of a log; a program with more does not end. */
  private static final int LONGEST = 100_000;

  /** Explanations of a log that are looked at. */
  private static final int MOST_SITUATIONS = 8;

  private static final String EVENT = "event";
  private static final String OB = "ob";
  private static final String CLOCK = "clock";
  private static final String ZONE = "zone";
  private static final String STOP = "stop";
  private static final String RESTART = "restart";
  private static final String START = "start";
  private static final String STARTUP = "STARTUP";

  /** Lines after which the CPU is in another mode. */
  private static final Set<String> OF_MODE = Set.of(STOP, RESTART, "run", "hold", "release");

  private final Fields header;
  private final long duration;
  private final Dice dice;
  private final Session session;
  private final Work work;

  /** Starts of all OBs, and RUN. */
  private final List<Value> awaited;

  private final ArrayList<Fields> lines = new ArrayList<>();

  /** When, and in which state of the CPU, an OB has started. */
  private final HashSet<String> begun = new HashSet<>();

  /** Places of ends of OB 1 without which the next lines are hard to understand. */
  private final HashSet<Integer> endsThatCount = new HashSet<>();

  private String mode;
  private long up;
  private long clock;
  private long letUntil;
  private long letAt = -1;
  private Ahead ahead;

  /** The step with a call that was asked about last, at this time, and the answers. */
  private Fields asked;

  private List<Fields> answers;

  /**
   * Begins a program.
   *
   * @param program its text, one spelling or another
   * @param how with {@code header} in the place of the program's own, {@code readings} beside those of it, {@code
   *     latency}, that of the log, and {@code seed}, by which is chosen at random
   * @throws Unusable if program or header are not of the format
   * @throws NotCovered if the header has choices that the specification does not cover
   */
  Simulation(Contract spec, byte[] program, Fields how) {
    spec.format().program(program);
    Fields raw = Fields.of(program);
    int latency = how.has("latency") ? how.number("latency") : LATENCY;
    Fields own = raw.object("header");
    header =
        new Fields().put("format", FORMAT).with(how.has("header") ? how.object("header") : own).put("latency_ms", latency);
    if (how.has("readings")) {
      Fields given = header.has("readings") ? header.object("readings") : new Fields();
      header.put("readings", new Fields().with(given).with(how.object("readings")));
    }
    duration = (Long) raw.get("duration");
    dice = how.has("seed") ? new Dice((Long) how.get("seed")) : null;
    // Where OB 1 is in its body is known here, so every cycle is told.
    Fields strict = header.without().put("cycle", true).put("latency_ms", dice == null ? 0 : latency);
    session = new Session(spec, spec.format().header(bytes(strict), Engine.file(how)));
    clock = session.milliseconds();
    work = new Work(raw);
    awaited = session.timeless(awaited(raw));
    mode = modeNow();
    if ("RUN".equals(mode)) {
      work.start(Work.CYCLE_OB);
    }
  }

  private Simulation(Simulation other) {
    header = other.header;
    duration = other.duration;
    dice = other.dice;
    session = other.session.branch();
    work = new Work(other.work);
    awaited = other.awaited;
    lines.addAll(other.lines);
    begun.addAll(other.begun);
    endsThatCount.addAll(other.endsThatCount);
    mode = other.mode;
    up = other.up;
    clock = other.clock;
    letUntil = other.letUntil;
    letAt = other.letAt;
    ahead = other.ahead;
  }

  /** A simulation that goes on from here by itself. */
  Simulation branch() {
    return new Simulation(this);
  }

  private List<byte[]> awaited(Fields program) {
    var obs = new TreeSet<Integer>(Set.of(Work.CYCLE_OB));
    program.object("header").list("obs").forEach(ob -> obs.add(Spelled.number(ob)));
    for (Fields event : Work.objects(program.list("outside"))) {
      if ("load".equals(event.text(EVENT))) {
        obs.add(event.number(OB));
      }
    }
    var all = new ArrayList<byte[]>();
    obs.forEach(ob -> all.add(bytes(dated(new Fields().put(EVENT, START).put(OB, ob)))));
    all.add(bytes(dated(new Fields().put(EVENT, "run"))));
    return all;
  }

  /** Runs the program to its end. */
  Fields run() {
    for (List<Fields> choices = choices(); !choices.isEmpty(); choices = choices()) {
      take(choices.get(dice == null ? 0 : dice.below(choices.size())));
    }
    var log = new ArrayList<Fields>(List.of(header));
    log.addAll(shown(0));
    return new Fields().put("log", log);
  }

  /** The header of the log. */
  Fields header() {
    return header;
  }

  /** The number of lines so far, shown or not. */
  int size() {
    return lines.size();
  }

  /** The lines of the log from one on. Those of OB 1 are optional. */
  List<Fields> shown(int from) {
    var shown = new ArrayList<Fields>();
    for (int i = from; i < lines.size(); i++) {
      Fields line = lines.get(i);
      boolean ofCycle = Set.of(START, "end").contains(line.text(EVENT)) && line.number(OB) == Work.CYCLE_OB;
      if (!ofCycle || Boolean.TRUE.equals(header.get("cycle")) || endsThatCount.contains(i)) {
        shown.add(line);
      }
    }
    return shown;
  }

  /** Equal for simulations that go on alike. */
  Object key() {
    return List.of(ahead().key, work.key(), up, clock, mode, letUntil, letAt);
  }

  /** What may happen now, once time has gone on to where something may; none at the end of the program. */
  List<Fields> choices() {
    while (up < duration) {
      if (lines.size() >= LONGEST) {
        throw new NotCovered("the program has more than " + LONGEST + " lines of log");
      }
      List<Fields> now = ofCpu();
      now = now.isEmpty() ? ofOutside() : now;
      now = now.isEmpty() ? ofProgram() : now;
      now = now.isEmpty() ? ofIdleCpu() : now;
      if (!now.isEmpty()) {
        return now;
      }
      pass();
    }
    return List.of();
  }

  /** One of the choices happens. */
  void take(Fields choice) {
    if (choice == NOTHING) {
      letAt = up;
      letUntil = up + (dice == null ? 0 : dice.below((int) slack() + 1));
      return;
    }
    if (RESTART.equals(choice.text(EVENT)) && !"STOP".equals(mode)) {
      feed(new Fields().put(EVENT, STOP));
    }
    if (START.equals(choice.text(EVENT))) {
      begun.add(moment());
    }
    feed(choice);
  }

  // What may happen

  /** What the CPU may do next, and what has to have come, by the time since the program began. */
  private record Ahead(List<Line> lines, List<Line> due, long last, String key) {
    /** A line that may come from one time to another. */
    private record Line(Fields event, long from, long until) {
      /** It is of the same OB as what is due, and may come by then. */
      private boolean isIn(Line due) {
        return event.text(EVENT).equals(due.event.text(EVENT))
            && Objects.equals(event.get(OB), due.event.get(OB))
            && from <= due.until;
      }
    }

    static Ahead of(Fields possible) {
      List<Fields> times = Work.objects(possible.list("times"));
      var lines = new ArrayList<Line>();
      for (Fields line : Work.objects(possible.list("lines"))) {
        boolean ends = line.get("last") != null;
        long until = ends ? up(times.get(line.number("last"))) : Long.MAX_VALUE;
        lines.add(new Line(line.object(EVENT), up(times.get(line.number("first"))), until));
      }
      var due = new ArrayList<Line>();
      for (Fields time : times) {
        for (Object one : (Iterable<?>) time.get("due")) {
          due.add(new Line(Spelled.instead((Fields) one), up(time), up(time)));
        }
      }
      boolean endless = Boolean.TRUE.equals(possible.get("endless"));
      return new Ahead(lines, due, endless ? up(times.get(times.size() - 1)) : 0, possible.text("key"));
    }

    private static long up(Fields time) {
      return Spelled.milliseconds(time.get("up"));
    }
  }

  private Ahead ahead() {
    if (ahead == null) {
      ahead = Ahead.of(session.possible(question(awaited, null)));
    }
    return ahead;
  }

  private static Session.Question question(List<Value> lines, byte[] when) {
    return new Session.Question(lines, when, Integer.MAX_VALUE, Set.of(), Set.of());
  }

  /** The lines that may come now. */
  private List<Fields> now() {
    return ahead().lines.stream().filter(line -> line.from <= up && up <= line.until).map(Ahead.Line::event).toList();
  }

  /**
   * Whether the line is possible now, while those OBs run that are at work. Between two times at which it is possible, a
   * start event may have come to nothing. A startup OB may end unseen.
   */
  private boolean fits(Fields line) {
    for (Fields state : session.before(bytes(dated(line)), MOST_SITUATIONS)) {
      var running = Work.objects(state.list("running")).stream().map(frame -> frame.number(OB)).toList();
      if (!STARTUP.equals(mode) || running.equals(work.running())) {
        return true;
      }
    }
    return false;
  }

  /** Milliseconds until something has to have come. */
  private long slack() {
    return Math.max(0, ahead().due.stream().mapToLong(Ahead.Line::until).min().orElse(up) - up);
  }

  /** OBs that interrupt what runs, and a STOP by rule. */
  private List<Fields> ofCpu() {
    List<Ahead.Line> ended = ahead().due.stream().filter(one -> one.until <= up).toList();
    boolean lastChance = ended.isEmpty() && strands();
    if (up < letUntil && ended.isEmpty() && !lastChance && !blocked()) {
      return List.of();
    }
    var found = new ArrayList<Fields>();
    for (Fields line : now()) {
      if (START.equals(line.text(EVENT)) && line.number(OB) != Work.CYCLE_OB && fits(line)) {
        found.add(line);
      }
    }
    if (dice == null || !ended.isEmpty() || found.isEmpty()) {
      ended.stream().map(Ahead.Line::event).filter(one -> STOP.equals(one.text(EVENT))).forEach(found::add);
    }
    if (!found.isEmpty() && ended.isEmpty() && !blocked()) {
      if (begun.contains(moment()) || letAt == up && !lastChance) {
        return List.of();
      }
      if (!lastChance) {
        found.add(NOTHING);
      }
    }
    return found;
  }

  /** Whether the CPU does not take the call or the end that is next: an OB has to start before. */
  private boolean blocked() {
    if (!atWork()) {
      return false;
    }
    Fields call = work.top().call();
    return call == Work.END ? session.judge(bytes(dated(end()))) != null : call != null && answers(call).isEmpty();
  }

  /** Whether behind the call that is next an OB that is due could not start in time, as behind a DIS_AIRT. */
  private boolean strands() {
    Fields call = atWork() && dice != null ? work.top().call() : null;
    if (call == null || call == Work.END || answers(call).isEmpty()) {
      return false;
    }
    Session behind = session.branch();
    behind.feed(bytes(dated(answers(call).get(0))));
    Ahead then = Ahead.of(behind.possible(question(awaited, null)));
    return then.due.stream().anyMatch(due -> then.lines.stream().noneMatch(line -> line.isIn(due)));
  }

  private Fields end() {
    return new Fields().put(EVENT, "end").put(OB, work.top().ob);
  }

  /** Equal after an OB of no length that may start any number of times, such as for many open start events. */
  private String moment() {
    return up + " " + ahead().key;
  }

  /** The next cycle, or the end of STARTUP. */
  private List<Fields> ofIdleCpu() {
    if (work.top() != null) {
      return List.of();
    }
    return now().stream()
        .filter(line -> "run".equals(line.text(EVENT)) || line.number(OB) == Work.CYCLE_OB)
        .limit(1)
        .toList();
  }

  /** The next event from outside, if its time has come. */
  private List<Fields> ofOutside() {
    while (work.next() <= up) {
      Fields line = clocked(work.takeNext());
      String name = line.text(EVENT);
      boolean silent = "state".equals(name) || "STOP".equals(mode) && Set.of("interrupt", STOP).contains(name);
      if (!silent && (RESTART.equals(name) || session.judge(bytes(dated(line))) == null)) {
        return List.of(line);
      }
    }
    return List.of();
  }

  /** An event that moves the clock, as an event that sets it. */
  private Fields clocked(Fields event) {
    if (!event.has("by")) {
      return event;
    }
    long to = clock + (Long) event.get("by");
    if (to < 0) {
      throw new Unusable("a clock that stays in 1990 or later", event.get("by") + " at " + Days.iso(clock), "by");
    }
    return new Fields().put(EVENT, CLOCK).put("to", Days.iso(to));
  }

  private boolean atWork() {
    return work.top() != null && Set.of("RUN", STARTUP).contains(mode);
  }

  /** The next step of the OB at work. */
  private List<Fields> ofProgram() {
    while (atWork() && work.top().busy == 0) {
      Fields step = work.top().step();
      if (step == null) {
        return List.of(end());
      }
      if (step.has("call")) {
        if (answers(step).isEmpty()) {
          throw new NotCovered("no answer to " + Spelled.text(called(step)));
        }
        return answers(step);
      }
      if (CLOCK.equals(step.get(EVENT))) {
        Fields line = clocked(step);
        if (!Days.iso(clock).equals(line.get("to"))) {
          return List.of(line);
        }
      } else if (ZONE.equals(step.get(EVENT))) {
        return List.of(step);
      }
      work.top().goOn();
    }
    return List.of();
  }

  private static Fields called(Fields step) {
    return step.without("call").put(EVENT, step.get("call"));
  }

  /** A call that is made now, with each answer of the CPU. */
  private List<Fields> answers(Fields step) {
    if (step != asked) {
      byte[] line = bytes(dated(called(step)).put("ret", null));
      byte[] when = bytes(dated(new Fields().put(EVENT, "hold")));
      List<?> found = session.possible(question(session.timeless(List.of(line)), when)).list("lines");
      answers = Work.objects(found).stream().map(answer -> answer.object(EVENT)).toList();
      asked = step;
    }
    return answers;
  }

  // What happens

  private void feed(Fields line) {
    Fields whole = dated(line);
    String name = line.text(EVENT);
    if ("end".equals(name) && line.number(OB) == Work.CYCLE_OB && endsDelay()) {
      endsThatCount.add(lines.size());
    }
    Explanation.Refusal refusal = session.feed(bytes(whole));
    if (refusal != null) {
      String by = String.join(", ", refusal.requirements());
      throw new NotCovered(Spelled.text(whole) + " at " + whole.text("at") + ": refused, " + by);
    }
    lines.add(whole);
    clock = session.milliseconds();
    ahead = null;
    asked = null;
    happened(name, line);
    if (OF_MODE.contains(name)) {
      mode = modeNow();
    }
  }

  private String modeNow() {
    return session.situations(1).iterator().next().text("mode");
  }

  private void happened(String name, Fields line) {
    Work.Frame top = work.top();
    Fields step = top != null && top.busy == 0 ? top.step() : null;
    if (step != null && (name.equals(step.get("call")) || name.equals(step.get(EVENT)))) {
      top.goOn();
    }
    switch (name) {
      case START -> work.start(line.number(OB));
      case "end" -> work.end();
      case STOP -> work.stop(STARTUP.equals(mode));
      case RESTART -> work.restart("hot".equals(line.get("type")));
      case "run" -> work.run();
      default -> {
      }
    }
  }

  /** Whether a delay by SFC 41 ends if the OB at work ends now. */
  private boolean endsDelay() {
    for (int i = lines.size() - 1; i >= 0; i--) {
      String name = lines.get(i).text(EVENT);
      if ("end".equals(name) && lines.get(i).number(OB) == Work.CYCLE_OB) {
        return false;
      }
      if ("DIS_AIRT".equals(name)) {
        return session.situations(1).stream().anyMatch(state -> state.number("delay") > 0);
      }
    }
    return false;
  }

  /** Time goes on to where something may happen. */
  private void pass() {
    var ends = new TreeSet<Long>(List.of(duration, ahead().last, letUntil, work.next()));
    ahead.lines.forEach(line -> ends.add(line.from));
    ahead.due.forEach(one -> ends.add(one.until));
    boolean busy = atWork() && !work.top().idle;
    if (busy) {
      ends.add(up + work.top().busy);
    }
    long passed = Math.min(ends.higher(up), duration) - up;
    if (busy) {
      work.top().busy = Math.max(0, work.top().busy - passed);
    }
    up += passed;
    clock += passed;
    asked = null;
  }

  private Fields dated(Fields line) {
    return new Fields().put("at", Days.iso(clock)).with(line);
  }

  private static byte[] bytes(Fields line) {
    return line.toString().getBytes(StandardCharsets.UTF_8);
  }

  /** Numbers at random by SplitMix64: neighbouring seeds begin with different ones. */
  private static final class Dice {
    private long state;

    Dice(long seed) {
      state = seed;
    }

    int below(int bound) {
      long number = Hash.mix(state);
      state += Hash.STEP;
      return (int) Math.floorMod(number, (long) bound);
    }
  }
}
