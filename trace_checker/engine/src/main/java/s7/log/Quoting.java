package s7.log;

import java.util.Collection;
import java.util.Iterator;
import java.util.List;
import java.util.TreeSet;

/** How a log's values are quoted in messages. */
public final class Quoting {
  private static final int LONGEST = 60;
  private static final String HEX = "0123456789abcdef";

  private Quoting() {}

  /** A decoded JSON value: short, on one line, printable. */
  static String quote(Object value) {
    if (value instanceof String text) {
      var json = new StringBuilder();
      json(json, cut(text, LONGEST));
      return printable(json.toString(), 2 * LONGEST);
    }
    if (value instanceof Fields) {
      return "an object";
    }
    if (value instanceof List) {
      return "a list";
    }
    if (value instanceof JsonNumber number && !number.isInteger()) {
      boolean whole = Double.parseDouble(number.text()) % 1 == 0;
      return printable(number.text()) + (whole ? ", not an integer" : "");
    }
    return printable(String.valueOf(value));
  }

  /** A part of a source. */
  public static String inMarks(String text) {
    return '"' + printable(text) + '"';
  }

  /** The text cut to a length that people read, with everything a terminal might obey escaped. */
  static String printable(String text) {
    return printable(text, LONGEST);
  }

  private static String printable(String text, int longest) {
    var shown = new StringBuilder();
    cut(text, longest).codePoints().forEach(point -> append(shown, point));
    return shown.toString();
  }

  private static String cut(String text, int longest) {
    return text.codePointCount(0, text.length()) <= longest
        ? text
        : text.substring(0, text.offsetByCodePoints(0, longest)) + "...";
  }

  private static void append(StringBuilder shown, int point) {
    if (point == ' ' || isPrintable(point)) {
      shown.appendCodePoint(point);
    } else if (point == '\n' || point == '\r' || point == '\t') {
      shown.append('\\').append(point == '\n' ? 'n' : point == '\r' ? 'r' : 't');
    } else if (point < 0x100) {
      shown.append("\\x").append(hex(point, 2));
    } else if (point < 0x10000) {
      shown.append("\\u").append(hex(point, 4));
    } else {
      shown.append("\\U").append(hex(point, 8));
    }
  }

  private static boolean isPrintable(int point) {
    return switch (Character.getType(point)) {
      case Character.CONTROL, Character.FORMAT, Character.SURROGATE, Character.PRIVATE_USE, Character.UNASSIGNED,
          Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR, Character.SPACE_SEPARATOR -> false;
      default -> true;
    };
  }

  /** So many hexadecimal digits. */
  public static String hex(int number, int digits) {
    var text = new StringBuilder();
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
      text.append(HEX.charAt(number >> shift & 0xF));
    }
    return text.toString();
  }

  /** Appends a string as JSON has it. */
  static void json(StringBuilder json, String text) {
    json.append('"');
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      int named = "\"\\\b\f\n\r\t".indexOf(c);
      if (named >= 0) {
        json.append('\\').append("\"\\bfnrt".charAt(named));
      } else if (c < ' ') {
        json.append("\\u").append(hex(c, 4));
      } else {
        json.append(c);
      }
    }
    json.append('"');
  }

  /** Such as {@code 1, 10-17, 80}. */
  static String ranges(Collection<Long> numbers) {
    var text = new StringBuilder();
    Iterator<Long> rest = new TreeSet<>(numbers).iterator();
    for (Long next = rest.next(); next != null; ) {
      long first = next;
      long last = first;
      next = rest.hasNext() ? rest.next() : null;
      while (next != null && next == last + 1) {
        last++;
        next = rest.hasNext() ? rest.next() : null;
      }
      text.append(text.isEmpty() ? "" : ", ").append(first).append(first == last ? "" : "-" + last);
    }
    return text.toString();
  }
}
