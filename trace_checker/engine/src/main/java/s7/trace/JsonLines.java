package s7.trace;

import java.io.IOException;
import java.io.InputStream;

/** Splits a stream of bytes into lines, each as soon as it has come. */
final class JsonLines {
  private final InputStream in;
  private byte[] buffer = new byte[1 << 16];
  private int begin;
  private int end;

  JsonLines(InputStream in) {
    this.in = in;
  }

  /** The next line, which can be read until the one after it is asked for; null at the end. */
  Json next() throws IOException {
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

  /** Moves what is not yet a line to the beginning, into a larger buffer if it fills this one. */
  private void makeRoom() {
    end -= begin;
    byte[] next = end == buffer.length ? new byte[2 * end] : buffer;
    System.arraycopy(buffer, begin, next, 0, end);
    buffer = next;
    begin = 0;
  }
}
