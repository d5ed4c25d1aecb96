package tla.json;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;

/** Splits a stream of bytes into lines, each as soon as it has come. */
public final class JsonLines {
  private final InputStream in;
  private byte[] buffer = new byte[1 << 16];
  private int begin;
  private int end;

  public JsonLines(InputStream in) {
    this.in = in;
  }

  /** The next line, valid until the next call; null at the end of the stream. */
  public Json next() throws IOException {
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

  /** Takes bytes that are no lines, a part from {@code from} to before {@code to} at a time. */
  public interface Bytes {
    void take(byte[] bytes, int from, int to);
  }

  /** Passes so many bytes, each part as soon as it has come. */
  public void pass(int count, Bytes taker) throws IOException {
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
