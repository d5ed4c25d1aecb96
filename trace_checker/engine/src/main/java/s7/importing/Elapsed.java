package s7.importing;

import s7.log.Fields;

/**
 * Milliseconds since the first entry, on a clock that nobody sets, from the CPU clock and the system time of SFC 64
 * TIME_TCK. Where these agree as far as their resolution goes, the finer clock counts; where they do not, the clock was
 * set and the system time counts.
 */
final class Elapsed {
  /** TIME_TCK counts milliseconds up to this and begins again at 0. */
  private static final int LAST_TICK = Integer.MAX_VALUE;

  /** Milliseconds by which the two may differ: TIME_TCK counts in steps of 10 on many S7-300, the clock in ones. */
  private static final int RESOLUTION = 11;

  /** They run apart by no more than a thousandth. */
  private static final int DRIFT = 1000;

  private boolean begun;
  private long up;
  private long clock;
  private int tick;
  private boolean jumped;

  /** As {@link #asFields} gave it; anew for an empty object. */
  static Elapsed of(Fields json) {
    var elapsed = new Elapsed();
    if (json.has("up")) {
      elapsed.begun = true;
      elapsed.up = (Long) json.get("up");
      elapsed.clock = (Long) json.get("clock");
      elapsed.tick = json.number("tick");
    }
    return elapsed;
  }

  Fields asFields() {
    return new Fields().put("up", up).put("clock", clock).put("tick", tick);
  }

  /** Whether the clock was set before the last entry. */
  boolean jumped() {
    return jumped;
  }

  /** The elapsed time of the next entry; a restart sets the system time to 0. */
  long up(long atClock, int atTick, boolean restarted) {
    jumped = false;
    if (begun) {
      long byClock = atClock - clock;
      int byTick = atTick - tick & LAST_TICK;
      if (restarted || (byClock >= 0 && Math.abs(byClock - byTick) <= RESOLUTION + byTick / DRIFT)) {
        up += Math.max(byClock, 0);
      } else {
        jumped = true;
        up += byTick;
      }
    }
    begun = true;
    clock = atClock;
    tick = atTick;
    return up;
  }

  /** The clock was set right after the last entry. */
  void setClock(long to) {
    clock = to;
  }
}
