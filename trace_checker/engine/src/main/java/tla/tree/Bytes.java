package tla.tree;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/** Bytes that are being written: numbers in as few bytes as they need, seven bits each. */
final class Bytes extends ByteArrayOutputStream {
  void number(int number) {
    int rest = number;
    while ((rest & ~0x7F) != 0) {
      write(rest & 0x7F | 0x80);
      rest >>>= 7;
    }
    write(rest);
  }

  /** A text with its length. */
  void text(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    number(bytes.length);
    writeBytes(bytes);
  }
}
