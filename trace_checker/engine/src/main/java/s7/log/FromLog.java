package s7.log;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * A log turned into a program of the kit: its calls become the bodies of OBs, the rest of its cause comes from outside.
 *
 * <p>What the CPU of the log answered is left out. Another CPU may do other things with the program, and its log is
 * judged for itself.
 */
final class FromLog implements LogReader.Taker {
  /** Milliseconds that a program lasts beyond the last line of its log, so that OBs that are due then are seen. */
  private static final long AFTERWARDS = 1_000;

  private static final Map<String, Integer> STARTUP = Map.of("warm", 100, "hot", 101, "cold", 102);
  private static final int CYCLE = 1;

  /** Causes of a STOP by the CPU itself. */
  private static final Set<Integer> MADE_BY_RULES = Set.of(0x4568, 0x456D, 0x454A);

  /** Fault ids that come from no cause outside, as the log format has them. */
  private static final Map<Integer, Set<Integer>> FAULTS_OF_RULES =
      Map.of(80, Set.of(0x02, 0x05, 0x06, 0x07), 85, Set.of(0xA1, 0xA2));

  /** A run of an OB: its steps so far, and since when it has not been interrupted. */
  private static final class Run {
    final int ob;
    final long key;
    final List<Fields> steps = new ArrayList<>();
    long since;
    long worked;

    Run(int ob, int number, long since) {
      this.ob = ob;
      this.since = since;
      key = (long) ob << 32 | number;
    }

    void interrupted(long now) {
      worked += now - since;
    }

    /** Works until now. */
    void work(long now) {
      interrupted(now);
      since = now;
      rest();
    }

    void rest() {
      if (worked > 0) {
        steps.add(new Fields().put("wait", worked));
        worked = 0;
      }
    }
  }

  private final Events events;
  private final List<byte[]> lines;
  private final Fields header = new Fields();
  private final List<Fields> outside = new ArrayList<>();
  private final Map<Long, List<Fields>> bodies = new TreeMap<>();
  private final Map<Integer, Integer> runs = new HashMap<>();
  private Deque<Run> stack = new ArrayDeque<>();

  /** What STOP has interrupted and a hot restart brings back. */
  private Deque<Run> stopped = new ArrayDeque<>();

  private boolean cycles;
  private long now;

  private FromLog(Events events, List<byte[]> lines) {
    this.events = events;
    this.lines = lines;
  }

  /**
   * The fields {@code header}, {@code duration}, {@code outside} and {@code bodies} of the program.
   *
   * @throws Unusable if the log cannot be read
   */
  static Fields program(Format format, Events events, byte[] text, ProfileFile file) {
    var log = new FromLog(events, split(text));
    var reader = new LogReader(format, log, file);
    reader.take(text, 0, text.length);
    reader.end();
    return log.program();
  }

  private static List<byte[]> split(byte[] text) {
    var lines = new ArrayList<byte[]>();
    for (String line : new String(text, StandardCharsets.UTF_8).split("\n", -1)) {
      lines.add(line.getBytes(StandardCharsets.UTF_8));
    }
    return lines;
  }

  private Fields program() {
    now += AFTERWARDS;
    cut();
    close(stopped);
    var all = new ArrayList<Fields>();
    bodies.forEach((key, steps) ->
        all.add(new Fields().put("ob", (int) (key >> 32)).put("run", key.intValue()).put("steps", steps)));
    Fields program = new Fields().put("header", header).put("duration", Math.max(1, now));
    return (outside.isEmpty() ? program : program.put("outside", outside)).put("bodies", all);
  }

  @Override
  public void header(Fields normalised) {
    Fields given = Fields.of(lines.stream().filter(line -> !new String(line, StandardCharsets.UTF_8).isBlank())
        .findFirst().orElseThrow());
    for (String name : Programs.OF_HEADER) {
      if (given.has(name)) {
        header.put(name, given.get(name));
      }
    }
    cycles = Boolean.TRUE.equals(given.get("cycle"));
    if (!"STOP".equals(given.has("mode") ? given.get("mode") : "STOP")) {
      begin("RUN".equals(given.get("mode")) ? CYCLE : STARTUP.get("warm"));
    }
  }

  @Override
  public void event(int line, Fields event) {
    Fields given = Fields.of(lines.get(line - 1));
    now = ((Moment) event.get("up")).inMilliseconds();
    String name = event.text("event");
    if (events.calls().contains(name)) {
      call(name, given);
      return;
    }
    switch (name) {
      case "state" -> outside(new Fields().put("event", name).put("ob", event.get("ob")));
      case "start" -> start(event.number("ob"));
      case "end" -> end(event.number("ob"));
      case "stop" -> stop(event);
      case "restart" -> restart(given);
      case "run" -> run();
      case "interrupt", "hold", "release", "clock", "zone", "load", "delete" -> fromOutside(event, given);
      default -> {
      }
    }
  }

  private void call(String name, Fields given) {
    if (stack.isEmpty()) {
      return;
    }
    var step = new Fields().put("call", name);
    for (String operand : events.required(name).keySet()) {
      if (!operand.equals(Events.RET)) {
        step.put(operand, given.get(operand));
      }
    }
    stack.peekLast().work(now);
    stack.peekLast().steps.add(step);
  }

  private void fromOutside(Fields event, Fields given) {
    if ("interrupt".equals(event.text("event"))
        && event.has(Events.FAULT)
        && FAULTS_OF_RULES.getOrDefault(event.number("ob"), Set.of()).contains(event.number(Events.FAULT))) {
      return;
    }
    var kept = new Fields().put("event", event.text("event"));
    for (String name : List.of("ob", Events.FAULT, "to", "zone", "reason")) {
      if (given.has(name)) {
        kept.put(name, given.get(name));
      }
    }
    outside(kept);
  }

  private void outside(Fields event) {
    outside.add(new Fields().put("after", now).with(event));
  }

  private void begin(int ob) {
    stack.addLast(new Run(ob, runs.merge(ob, 1, Integer::sum), now));
  }

  private void start(int ob) {
    Run top = stack.peekLast();
    if (top != null && top.ob == ob && (ob == CYCLE || STARTUP.containsValue(ob))) {
      if (!cycles || ob != CYCLE) {
        return; // the OB below all others, which runs already
      }
      finish(stack.removeLast());
    }
    if (!stack.isEmpty()) {
      stack.peekLast().interrupted(now);
    }
    begin(ob);
  }

  private void end(int ob) {
    if (stack.isEmpty() || stack.peekLast().ob != ob || ob == CYCLE && !cycles) {
      return;
    }
    Run run = stack.removeLast();
    run.work(now);
    finish(run);
    if (!stack.isEmpty()) {
      stack.peekLast().since = now;
    }
  }

  private void restart(Fields given) {
    String type = given.text("type");
    if (!"hot".equals(type)) {
      close(stopped);
    }
    outside(new Fields().put("event", "restart").put("type", type));
    begin(STARTUP.get(type));
  }

  private void run() {
    cut();
    stack = stopped;
    stopped = new ArrayDeque<>();
    if (stack.isEmpty()) {
      begin(CYCLE);
    } else {
      stack.peekLast().since = now;
    }
  }

  /** STOP ends a startup OB for good; others may go on. */
  private void stop(Fields event) {
    if (!event.has("cause") || !MADE_BY_RULES.contains(event.number("cause"))) {
      outside(new Fields().put("event", "stop"));
    }
    if (stack.isEmpty() || STARTUP.containsValue(stack.peekFirst().ob)) {
      cut();
    } else {
      stack.peekLast().work(now);
      stopped = stack;
      stack = new ArrayDeque<>();
    }
  }

  /** Nothing runs any more: each OB stays at work until here. */
  private void cut() {
    if (!stack.isEmpty()) {
      stack.peekLast().work(now);
    }
    close(stack);
  }

  private void close(Deque<Run> ended) {
    while (!ended.isEmpty()) {
      Run run = ended.removeLast();
      run.rest();
      if (run.ob == CYCLE) {
        // Its cycle must not end before the STOP: the next runs would have other numbers.
        run.steps.add(new Fields().put("wait", 1));
      }
      finish(run);
    }
  }

  private void finish(Run run) {
    if (!run.steps.isEmpty()) {
      bodies.put(run.key, run.steps);
    }
  }
}
