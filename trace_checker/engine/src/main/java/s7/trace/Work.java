package s7.trace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import s7.log.Fields;

/** The program's side of a simulation: bodies that are at work, and the events from outside that are still to come. */
final class Work {
  static final int CYCLE_OB = 1;

  /** Of a cycle of OB 1 whose body does not wait: a cycle of no length would go on forever. */
  private static final Fields PAUSE = new Fields().put("wait", 1L);

  /** In place of the next call: the OB ends. */
  static final Fields END = new Fields().put("end", true);

  private static final String EVERY = "every";

  /** The steps of a body; equal to itself alone. */
  private record Body(List<Fields> steps) {
    static final Body NONE = new Body(List.of());
    static final Body NONE_OF_CYCLE = NONE.thatWaits();

    @Override
    public boolean equals(Object other) {
      return this == other;
    }

    @Override
    public int hashCode() {
      return steps.size();
    }

    /** Steps that wait, with a pause behind them if the body's own do not. */
    Body thatWaits() {
      if (steps.stream().anyMatch(step -> step.has("wait"))) {
        return this;
      }
      var all = new ArrayList<Fields>(steps.stream().filter(step -> !step.has("end")).toList());
      all.add(PAUSE);
      return new Body(all);
    }
  }

  /** An OB that was started, with the steps that are left. */
  static final class Frame {
    final int ob;

    /** Nothing is to be done in this run nor in any later one: it goes on for as long as it may. */
    final boolean idle;

    private final Body body;
    private int place;

    /** The rest of a wait, in ms. */
    long busy;

    private Frame(int ob, Body body, boolean idle) {
      this.ob = ob;
      this.body = body;
      this.idle = idle;
      enter();
    }

    private Frame(Frame other) {
      this(other.ob, other.body, other.idle);
      place = other.place;
      busy = other.busy;
    }

    private void enter() {
      Fields step = step();
      busy = step != null && step.has("wait") ? (Long) step.get("wait") : 0;
    }

    /** The step that is to be done or waited for; null at the end. */
    Fields step() {
      Fields step = place < body.steps.size() ? body.steps.get(place) : null;
      return step == null || step.has("end") ? null : step;
    }

    /** The call that is to be made now, behind steps that take no time; or END; null if there is none. */
    Fields call() {
      for (int i = place; busy == 0 && i < body.steps.size(); i++) {
        Fields step = body.steps.get(i);
        if (step.has("call")) {
          return step;
        }
        boolean waited = step.has("wait") && (i == place || Long.valueOf(0).equals(step.get("wait")));
        if (!waited && !"state".equals(step.get("event"))) {
          return step.has("end") ? END : null;
        }
      }
      return busy == 0 ? END : null;
    }

    /** The step is done. */
    void goOn() {
      place++;
      enter();
    }
  }

  private final long duration;

  /** By OB and run; run 0 is every one that has no body of its own. */
  private final Map<List<Integer>, Body> bodies = new HashMap<>();

  private final Map<Integer, Integer> lastRun = new HashMap<>();
  private final List<Fields> outside;

  private final HashMap<Integer, Integer> runs = new HashMap<>();
  private ArrayList<Frame> frames = new ArrayList<>();

  /** What STOP has interrupted and a hot restart brings back. */
  private ArrayList<Frame> stopped = new ArrayList<>();

  /** When each event from outside comes next. */
  private final long[] after;

  /**
   * @param program an object that {@link s7.log.Format#program} takes
   */
  Work(Fields program) {
    duration = (Long) program.get("duration");
    for (Fields body : objects(program.list("bodies"))) {
      int ob = body.number("ob");
      int run = body.has("run") ? body.number("run") : 0;
      var steps = new Body(objects(body.list("steps")));
      bodies.put(List.of(ob, run), ob == CYCLE_OB ? steps.thatWaits() : steps);
      lastRun.merge(ob, run, Math::max);
    }
    outside = new ArrayList<>(objects(program.list("outside")));
    outside.sort(Comparator.comparing(Work::first));
    after = outside.stream().mapToLong(Work::first).toArray();
  }

  private static Long first(Fields event) {
    return (Long) event.get("after");
  }

  /** Work that goes on by itself. */
  Work(Work other) {
    duration = other.duration;
    bodies.putAll(other.bodies);
    lastRun.putAll(other.lastRun);
    outside = other.outside;
    runs.putAll(other.runs);
    other.frames.forEach(frame -> frames.add(new Frame(frame)));
    other.stopped.forEach(frame -> stopped.add(new Frame(frame)));
    after = other.after.clone();
  }

  static List<Fields> objects(Collection<?> list) {
    return list.stream().map(Fields.class::cast).toList();
  }

  /** Equal for work that goes on alike. */
  Object key() {
    return List.of(key(stopped), key(frames), Map.copyOf(runs), Arrays.stream(after).boxed().toList());
  }

  private static List<Object> key(List<Frame> frames) {
    return frames.stream().<Object>map(one -> List.of(one.ob, one.body, one.idle, one.place, one.busy)).toList();
  }

  // Bodies

  /** An OB starts. */
  void start(int ob) {
    int run = runs.merge(ob, 1, Integer::sum);
    Body every = bodies.get(List.of(ob, 0));
    Body none = ob == CYCLE_OB ? Body.NONE_OF_CYCLE : Body.NONE;
    Body body = bodies.getOrDefault(List.of(ob, run), every == null ? none : every);
    boolean more = every != null || run <= lastRun.getOrDefault(ob, 0);
    frames.add(new Frame(ob, body, ob == CYCLE_OB && !more));
  }

  /** The OB on top has ended. */
  void end() {
    frames.remove(frames.size() - 1);
  }

  /** STOP; that of STARTUP ends the startup OB for good. */
  void stop(boolean inStartup) {
    if (!inStartup) {
      stopped = frames;
    }
    frames = new ArrayList<>();
  }

  /** Only a hot restart brings back what STOP has interrupted. */
  void restart(boolean hot) {
    if (!hot) {
      stopped = new ArrayList<>();
    }
  }

  /** RUN. */
  void run() {
    frames = stopped;
    stopped = new ArrayList<>();
  }

  /** The OBs at work, the one that runs last. */
  List<Integer> running() {
    return frames.stream().map(frame -> frame.ob).toList();
  }

  /** The OB that is at work; null if there is none. */
  Frame top() {
    return frames.isEmpty() ? null : frames.get(frames.size() - 1);
  }

  // Events from outside

  /** When the next one comes; the end of the program if none does before. */
  long next() {
    int place = nextPlace();
    return place < 0 ? duration : Math.min(after[place], duration);
  }

  /** Those of one moment come in the order of the program. */
  private int nextPlace() {
    int next = -1;
    for (int i = 0; i < after.length; i++) {
      if (next < 0 || after[i] < after[next]) {
        next = i;
      }
    }
    return next;
  }

  /** Takes the next one, which there is, without its time. */
  Fields takeNext() {
    int place = nextPlace();
    Fields event = outside.get(place);
    after[place] = event.has(EVERY) ? after[place] + (Long) event.get(EVERY) : Long.MAX_VALUE;
    return event.without("after", EVERY);
  }
}
