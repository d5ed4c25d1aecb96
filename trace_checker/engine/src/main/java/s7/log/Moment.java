package s7.log;

/** A point in time as the specification has it: minutes, and the milliseconds in the minute. */
public record Moment(int minutes, int milliseconds) {
  static final int MS_PER_MINUTE = 60_000;

  /** So many milliseconds after any zero. */
  public static Moment of(long milliseconds) {
    return new Moment((int) (milliseconds / MS_PER_MINUTE), (int) (milliseconds % MS_PER_MINUTE));
  }

  long inMilliseconds() {
    return (long) minutes * MS_PER_MINUTE + milliseconds;
  }

  /** The moment as an object. */
  public Fields asFields() {
    return new Fields().put("min", minutes).put("ms", milliseconds);
  }

  /** The text in JSON. */
  @Override
  public String toString() {
    return asFields().toString();
  }
}
