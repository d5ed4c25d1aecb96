package s7.trace;

import com.google.gson.JsonObject;

/**
 * The two clocks of a log of which the engine reads lines: the CPU's, which can be set, and elapsed
 * time. Python's reader begins a log and hands them over. All times are milliseconds.
 */
final class Clocks {
  /** No time. */
  static final long NONE = -1;

  private final boolean jumpsLogged;
  private long clock;
  private long up;
  private long elapsed;

  /**
   * @param json {@code jumps_logged}, whether every setting of the clock is in the log, and the readings
   */
  Clocks(JsonObject json) {
    jumpsLogged = json.get("jumps_logged").getAsBoolean();
    set(json);
  }

  /** Takes the readings that Python has after a line that it has read. */
  void set(JsonObject json) {
    clock = json.get("clock").getAsLong();
    up = json.get("up").getAsLong();
    elapsed = json.get("elapsed").getAsLong();
  }

  /** The readings. */
  JsonObject json() {
    var json = new JsonObject();
    json.addProperty("clock", clock);
    json.addProperty("up", up);
    json.addProperty("elapsed", elapsed);
    return json;
  }

  /** Whether the next line may have these times; Python says why not. */
  boolean allow(long at, long counter) {
    return (at >= clock || !jumpsLogged) && (counter == NONE || counter >= up);
  }

  /**
   * Goes on to a line.
   *
   * @param at the CPU clock at the line
   * @param counter the elapsed time that the line says, or NONE
   * @param to the clock after the line if it is set there, or NONE
   * @return the time elapsed since the log began
   */
  long advance(long at, long counter, long to) {
    if (counter == NONE) {
      elapsed += Math.max(at - clock, 0);
    } else {
      up = counter;
      elapsed = Math.max(elapsed, counter);
    }
    clock = to == NONE ? at : to;
    return elapsed;
  }
}
