package s7.trace;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;

import s7.log.Fields;

/** Messages, each an object in JSON on a line, as soon as it has come. */
final class Input {
  private final InputStream in;
  private byte[] buffer = new byte[1 << 16];
  private int begin;
  private int end;

  Input(InputStream in) {
    this.in = in;
  }

  /** The next message; null at the end of the stream. */
  Fields next() throws IOException {
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

  /** Takes bytes that are no messages, a part from {@code from} to before {@code to} at a time. */
  interface Bytes {
    void take(byte[] bytes, int from, int to);
  }

  /** Passes so many bytes, each part as soon as it has come. */
  void pass(int count, Bytes taker) throws IOException {
    int left = count;
    while (left > 0) {
      if (begin == end) {
        begin = 0;
        end = Math.max(in.read(buffer, 0, buffer.length), 0);
        if (end == 0) {
          throw new EOFException();
        }
      }
      int part = Math.min(left, end - begin);
      taker.take(buffer, begin, begin + part);
      begin += part;
      left -= part;
    }
  }

  private Fields line(int to) {
    Fields line = Fields.of(buffer, begin, to);
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
