package tla.eval;

/**
 * Whether it is worth looking for inputs that have come before. Where few of them have, as in short logs, to look costs
 * more than it saves: then it rests for some time and tries again.
 */
final class Trial {
  /** So many inputs are looked for before it is judged. */
  private static final int LOOKS = 1 << 10;

  /** So many go by after a trial in which too few were known. */
  private static final int REST = 8 * LOOKS;

  /** One of so many has to be known. */
  private static final int LEAST = 3;

  private int rest;
  private int looks;
  private int known;

  /** Whether the next input is to be looked for; then {@link #found} follows. */
  boolean isOn() {
    return rest == 0 || --rest == 0;
  }

  void found(boolean wasKnown) {
    known += wasKnown ? 1 : 0;
    if (++looks == LOOKS) {
      rest = LEAST * known < LOOKS ? REST : 0;
      looks = 0;
      known = 0;
    }
  }
}
