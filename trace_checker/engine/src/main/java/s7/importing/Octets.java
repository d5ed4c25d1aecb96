package s7.importing;

import java.io.ByteArrayOutputStream;

import s7.log.Quoting;
import s7.log.Unusable;

/** Bytes of an S7, and how logs and people spell them. */
final class Octets {
  private Octets() {}

  static int one(byte[] raw, int at) {
    return raw[at] & 0xFF;
  }

  static int word(byte[] raw, int at) {
    return one(raw, at) << 8 | one(raw, at + 1);
  }

  static int doubleWord(byte[] raw, int at) {
    return word(raw, at) << 16 | word(raw, at + 2);
  }

  static String hex(int value, int digits) {
    return Quoting.hex(value, digits).toUpperCase();
  }

  static String asByte(int value) {
    return "B#16#" + hex(value, 2);
  }

  static String asWord(int value) {
    return "W#16#" + hex(value, 4);
  }

  /** Words as people write them: {@code 3502 1A50 C358}. */
  static String spaced(byte[] raw, int from, int to) {
    var text = new StringBuilder();
    for (int at = from; at < to; at++) {
      text.append(at > from && (at - from) % 2 == 0 ? " " : "").append(hex(one(raw, at), 2));
    }
    return text.toString();
  }

  /** The content, decoded if it is nothing but hexadecimal digits with white space and {@code 16#} between them. */
  static byte[] decoded(byte[] content) {
    var raw = new ByteArrayOutputStream();
    int digits = 0;
    int begun = 0;
    for (int at = 0; at < content.length; at++) {
      int c = one(content, at);
      if (c == '1' && at + 2 < content.length && content[at + 1] == '6' && content[at + 2] == '#') {
        at += 2;
      } else if (c == 0xC2 && at + 1 < content.length && one(content, at + 1) == 0xA0) {
        at++; // a no-break space, as digits from a web page have them between them
      } else if (c != ' ' && (c < '\t' || c > '\r')) {
        int digit = Character.digit(c, 16);
        if (digit < 0) {
          return content;
        }
        begun = begun << 4 | digit;
        if (++digits % 2 == 0) {
          raw.write(begun);
        }
      }
    }
    if (digits % 2 != 0) {
      throw new Unusable("two hexadecimal digits a byte", digits + " digits");
    }
    return digits == 0 ? content : raw.toByteArray();
  }
}
