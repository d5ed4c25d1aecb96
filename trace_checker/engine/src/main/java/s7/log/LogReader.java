package s7.log;

import java.util.Arrays;

/**
 * Reads one log, whose bytes come in pieces of any length: UTF-8, without a byte order mark. Memory stays constant.
 *
 * <p>A line that is not of the format is {@link Unusable} with its number, after everything before it has been taken.
 */
public final class LogReader {
  /** Bytes of the longest line that is read; it bounds the memory that a log can take. */
  private static final int LONGEST_LINE = 1024 * 1024;

  /** Takes what is read. */
  public interface Taker {
    void header(Fields header);

    /** An event, with the number of its line. */
    void event(int line, Fields event);
  }

  private final Format format;
  private final Taker taker;
  private final ProfileFile file;
  private final Json json = new Json();
  private final Alike alike = new Alike();
  private Clocks clocks;
  private int line = 1;

  /** The begin of the line that has not ended yet. */
  private byte[] begun = new byte[1024];

  private int length;

  /**
   * @param file the file that the header may name as its profile; null if there is none
   */
  public LogReader(Format format, Taker taker, ProfileFile file) {
    this.format = format;
    this.taker = taker;
    this.file = file;
  }

  /** Takes the next bytes. */
  public void take(byte[] bytes, int from, int to) {
    int begin = from;
    for (int at = from; at < to; at++) {
      if (bytes[at] == '\n') {
        if (length == 0) {
          line(bytes, begin, at);
        } else {
          keep(bytes, begin, at);
          line(begun, 0, length);
          length = 0;
        }
        line++;
        begin = at + 1;
      }
    }
    keep(bytes, begin, to);
  }

  /** Ends the log; its last line need not have an end. */
  public void end() {
    if (length > 0) {
      line(begun, 0, length);
      length = 0;
    }
    if (clocks == null) {
      throw new Unusable("a header", "an empty log").at(1);
    }
  }

  private void keep(byte[] bytes, int from, int to) {
    if (to - from > LONGEST_LINE - length) {
      throw tooLong();
    }
    if (length + to - from > begun.length) {
      begun = Arrays.copyOf(begun, Math.max(2 * begun.length, length + to - from));
    }
    System.arraycopy(bytes, from, begun, length, to - from);
    length += to - from;
  }

  private Unusable tooLong() {
    return new Unusable("a line of at most " + LONGEST_LINE + " bytes", "a longer one").at(line);
  }

  private void line(byte[] bytes, int from, int to) {
    if (to - from > LONGEST_LINE) {
      throw tooLong();
    }
    if (isBlank(bytes, from, to)) {
      return;
    }
    try {
      if (clocks != null) {
        clocks.requireOpen();
      }
      if (clocks == null) {
        Fields header = format.header(json.read(bytes, from, to), file);
        clocks = Format.clocksOf(header);
        taker.header(header);
      } else {
        Fields event = event(bytes, from, to);
        clocks.stamp(event);
        taker.event(line, event);
      }
    } catch (Unusable wrong) {
      throw wrong.at(line);
    }
  }

  /** The event of a line, before the clocks have gone on to it. */
  private Fields event(byte[] bytes, int from, int to) {
    Fields event = alike.event(bytes, from, to);
    if (event == null) {
      event = format.event(json.read(bytes, from, to), clocks.cpu);
      alike.keep(bytes, from, to, event);
    }
    return event;
  }

  private static boolean isBlank(byte[] bytes, int from, int to) {
    for (int i = from; i < to; i++) {
      if (bytes[i] != ' ' && bytes[i] != '\t' && bytes[i] != '\r') {
        return false;
      }
    }
    return true;
  }
}
