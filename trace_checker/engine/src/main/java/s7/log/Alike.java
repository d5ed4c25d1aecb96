package s7.log;

import java.util.Arrays;

/**
 * Lines that differ from an earlier one of their log in {@code at} and in the {@code time} of their {@code info} alone:
 * most lines of a long log, which need not be read as JSON.
 *
 * <p>Both dates have to be written to the millisecond, in ISO's way, and no line has an escape.
 */
final class Alike {
  /** The most examples; one with the same hash takes the place of another. */
  private static final int MOST = 256;

  private static final String INFO = "info";
  private static final String TIME = "time";
  private static final int NONE = -1;

  private final Example[] examples = new Example[MOST];

  /** Of the line at hand: its hash without the dates, and where these begin. */
  private int hash;

  private int at;
  private int time;

  /** A line, the event that was read from it, and where its dates begin. */
  private record Example(byte[] line, int at, int time, Fields event) {}

  /** The event of a line, before its time is known to fit; null if no line was like it, or if it has no such date. */
  Fields event(byte[] bytes, int from, int to) {
    look(bytes, from, to);
    Example example = examples[hash & MOST - 1];
    if (example == null || at == NONE || !isLike(example, bytes, from, to)) {
      return null;
    }
    long moment = Spellings.instant(bytes, from + at);
    long inside = time == NONE ? 0 : Spellings.instant(bytes, from + time);
    if (moment < 0 || inside < 0) {
      return null;
    }
    Fields event = example.event.likewise(example.event).put(Events.AT, moment);
    if (time != NONE) {
      Fields info = event.object(INFO);
      event.put(INFO, info.likewise(null).put(TIME, Moment.of(inside)));
    }
    return event;
  }

  /** Keeps an event as an example for lines like its own, the last one that was asked for, if it may be one. */
  void keep(byte[] bytes, int from, int to, Fields event) {
    boolean hasTime = event.get(INFO) instanceof Fields info && info.has(TIME);
    if (at == NONE || hasTime != (time != NONE) || event.has(Events.UP) || Spellings.instant(bytes, from + at) < 0) {
      return;
    }
    for (int i = from; i < to; i++) {
      if (bytes[i] == '\\') {
        return;
      }
    }
    examples[hash & MOST - 1] = new Example(Arrays.copyOfRange(bytes, from, to), at, time, event.likewise(null));
  }

  private void look(byte[] bytes, int from, int to) {
    at = NONE;
    time = NONE;
    int sum = 0;
    // The keys must be those of the event and of its info: neither may be there twice.
    boolean odd = false;
    for (int i = from; i < to; i++) {
      sum = 31 * sum + bytes[i];
      if (bytes[i] != '"') {
        continue;
      }
      boolean isAt = isKey(bytes, i, to, Events.AT);
      if (isAt || isKey(bytes, i, to, TIME)) {
        int date = date(bytes, i + 2 + (isAt ? Events.AT : TIME).length(), to);
        odd |= date == NONE || (isAt ? at : time) != NONE;
        if (odd) {
          break;
        }
        at = isAt ? date - from : at;
        time = isAt ? time : date - from;
        i = date + Spellings.ISO_LENGTH - 1;
      }
    }
    at = odd ? NONE : at;
    hash = sum ^ sum >>> 8 ^ sum >>> 16;
  }

  private static boolean isKey(byte[] bytes, int quote, int to, String key) {
    int last = quote + key.length() + 1;
    if (last >= to || bytes[last] != '"') {
      return false;
    }
    for (int i = 0; i < key.length(); i++) {
      if (bytes[quote + 1 + i] != key.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  /** Where the string behind a key begins, if it is as long as a date; else none. */
  private static int date(byte[] bytes, int behind, int to) {
    if (behind + 3 + Spellings.ISO_LENGTH >= to || bytes[behind] != ':') {
      return NONE;
    }
    int quote = bytes[behind + 1] == ' ' ? behind + 2 : behind + 1;
    return bytes[quote] == '"' && bytes[quote + 1 + Spellings.ISO_LENGTH] == '"' ? quote + 1 : NONE;
  }

  private boolean isLike(Example example, byte[] bytes, int from, int to) {
    byte[] line = example.line;
    if (line.length != to - from || example.at != at || example.time != time) {
      return false;
    }
    for (int i = 0; i < line.length; i++) {
      if (i == at || i == time) {
        i += Spellings.ISO_LENGTH;
      }
      if (line[i] != bytes[from + i]) {
        return false;
      }
    }
    return true;
  }
}
