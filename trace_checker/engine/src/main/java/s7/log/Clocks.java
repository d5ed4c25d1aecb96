package s7.log;

import java.util.Set;

/**
 * The two clocks of a log: the CPU's, which can be set, and elapsed time, which cannot.
 *
 * <p>Elapsed time counts from the log's begin: where a line has no {@code up} it follows the CPU clock, settings left
 * out. All times are milliseconds.
 */
public final class Clocks {
  /** What of the CPU decides what a line may have. */
  record Cpu(String family, Set<?> numberedObs) {}

  final Cpu cpu;

  private final boolean jumpsLogged;
  private long clock;
  private long up;
  private long elapsed;
  private boolean ended;

  /**
   * The clocks when a log begins.
   *
   * @param jumpsLogged whether every setting of the clock is in the log
   */
  Clocks(Moment clock, boolean jumpsLogged, Cpu cpu) {
    this.cpu = cpu;
    this.clock = clock.inMilliseconds();
    this.jumpsLogged = jumpsLogged;
  }

  /** The same clocks, which go on by themselves. */
  public Clocks(Clocks other) {
    cpu = other.cpu;
    jumpsLogged = other.jumpsLogged;
    clock = other.clock;
    up = other.up;
    elapsed = other.elapsed;
    ended = other.ended;
  }

  /** The CPU clock after the last line, as a log spells it. */
  public String reading() {
    return Days.iso(clock);
  }

  /** The CPU clock after the last line. */
  public long milliseconds() {
    return clock;
  }

  /** A line can only follow where the log has not ended. */
  void requireOpen() {
    if (ended) {
      throw new Unusable("nothing behind \"done\", the end of the log", "a line");
    }
  }

  /**
   * Goes on to a line: its {@code at} becomes a moment, and so does {@code up}, which is filled in where it is missing;
   * as it was given it becomes {@code counter}.
   */
  void stamp(Fields event) {
    int placeOfAt = -1;
    int placeOfUp = -1;
    Object to = null;
    for (int i = 0; i < event.size(); i++) {
      String name = event.name(i);
      if (name.length() == Events.AT.length()) {
        placeOfAt = name.equals(Events.AT) ? i : placeOfAt;
        placeOfUp = name.equals(Events.UP) ? i : placeOfUp;
        to = name.equals("to") ? event.value(i) : to;
      }
    }
    long at = (Long) event.value(placeOfAt);
    long passed = at - clock;
    int step = event.get(Events.STEP) instanceof Integer unit ? unit : 1;
    if (passed <= -step && jumpsLogged) {
      throw new Unusable("no time before " + Days.iso(clock) + ", the clock's last reading", Days.iso(at), Events.AT);
    }
    if (placeOfUp < 0) {
      // Where its settings are not logged, a clock that runs backward was set.
      elapsed += Math.max(passed, 0);
      event.add(Events.UP, Moment.of(elapsed));
    } else {
      long counter = (Long) event.value(placeOfUp);
      if (counter < up) {
        throw new Unusable("no number below " + up + ", the last one", String.valueOf(counter), Events.UP);
      }
      up = counter;
      event.add("counter", Moment.of(up));
      // Lines without `up` may have counted further than the next line with it.
      elapsed = Math.max(elapsed, up);
      event.set(placeOfUp, Moment.of(elapsed));
    }
    clock = to instanceof Moment set ? set.inMilliseconds() : passed > -step ? Math.max(clock, at) : at;
    event.set(placeOfAt, Moment.of(at));
    ended = event.get(Events.EVENT).equals(Events.DONE);
  }
}
