package tla.json;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayDeque;
import java.util.Collection;

/** Splits a stream of bytes into lines, each as soon as it has come. */
public final class JsonLines {
  private final InputStream in;
  private byte[] buffer = new byte[1 << 16];
  private int begin;
  private int end;
  private final ArrayDeque<Json> again = new ArrayDeque<>();

  public JsonLines(InputStream in) {
    this.in = in;
  }

  /** The next line, valid until the next call; null at the end of the stream. */
  public Json next() throws IOException {
    return again.isEmpty() ? fresh() : again.removeFirst();
  }

  /** Puts lines back: they come again, before all others. */
  public void again(Collection<Json> lines) {
    again.addAll(lines);
  }

  private Json fresh() throws IOException {
    int at = begin;
    while (true) {
      for (; at < end; at++) {
        if (buffer[at] == '\n') {
          return line(at);
        }
      }
      at -= begin;
      makeRoom();
      int count = in.read(buffer, end, buffer.length - end);
      if (count < 0) {
        return begin == end ? null : line(end);
      }
      end += count;
    }
  }

  private Json line(int to) {
    var line = new Json(buffer, begin, to);
    begin = Math.min(to + 1, end);
    return line;
  }

  /** Moves the unfinished line to the begin of the buffer, or of a larger one if it fills this one. */
  private void makeRoom() {
    end -= begin;
    byte[] next = end == buffer.length ? new byte[2 * end] : buffer;
    System.arraycopy(buffer, begin, next, 0, end);
    buffer = next;
    begin = 0;
  }
}
