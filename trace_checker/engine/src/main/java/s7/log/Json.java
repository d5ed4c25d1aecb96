package s7.log;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;

/** Reads one JSON object, and is stricter than JSON: UTF-8, no lone surrogate, no key twice, some bounds. */
final class Json {
  /** Levels of nesting. */
  static final int DEEPEST = 900;

  /** Digits of the longest integer. */
  private static final int MOST_DIGITS = 4_300;

  /** From half a step above the largest double on. */
  private static final BigDecimal INFINITE = new BigDecimal(
      BigInteger.ONE.shiftLeft(54).subtract(BigInteger.ONE).shiftLeft(970));

  private static final int EXCERPT = 30;
  private static final int SURELY_LONG = 18;
  private static final int SHORT = 16;
  private static final int FEW = 16;
  private static final String OBJECT = "a JSON object";

  /** Stands for bytes that are no character. */
  private static final int REPLACEMENT = 0xFFFD;

  private byte[] bytes;
  private int begin;
  private int end;
  private int at;
  private int depth;

  /** The first key that is twice in an object. */
  private String twice;

  /** Strings that were met, by a hash: most names and short values come again. */
  private final String[] met = new String[256];

  /**
   * The object in a part of the bytes.
   *
   * @throws Unusable for anything else
   */
  Fields read(byte[] text, int from, int to) {
    bytes = text;
    begin = from;
    end = to;
    at = from;
    depth = 0;
    twice = null;
    Object value = value();
    skip();
    if (at < end) {
      throw malformed("trailing characters");
    }
    if (!(value instanceof Fields object)) {
      throw new Unusable(OBJECT, Quoting.quote(value));
    }
    if (twice != null) {
      throw new Unusable("each key once in an object", "it twice", Quoting.printable(twice));
    }
    return object;
  }

  private void skip() {
    while (at < end && (bytes[at] == ' ' || bytes[at] == '\t' || bytes[at] == '\r' || bytes[at] == '\n')) {
      at++;
    }
  }

  /** The next byte behind spaces, which stays the next. */
  private byte peek() {
    skip();
    return here();
  }

  private byte here() {
    if (at == end) {
      throw new Unusable(OBJECT, "a line cut off after " + excerpt(Math.max(begin, end - EXCERPT), end));
    }
    return bytes[at];
  }

  private Object value() {
    return switch (peek()) {
      case '{' -> object();
      case '[' -> list();
      case '"' -> string();
      case 't' -> word("true", Boolean.TRUE);
      case 'f' -> word("false", Boolean.FALSE);
      case 'n' -> word("null", null);
      case '-', '0', '1', '2', '3', '4', '5', '6', '7', '8', '9' -> number();
      default -> throw malformed("invalid character");
    };
  }

  private void enter() {
    if (++depth > DEEPEST) {
      throw new Unusable(OBJECT, "too many levels of nesting");
    }
    at++;
  }

  private Fields object() {
    enter();
    var object = new Fields();
    HashSet<String> known = null;
    String again = null;
    boolean first = true;
    while (peek() != '}' || !first) {
      if (!first && !more('}')) {
        break;
      }
      if (peek() != '"') {
        throw malformed(bytes[at] == '}' ? "trailing comma in object" : "object keys must be strings");
      }
      String name = string();
      if (peek() != ':') {
        throw malformed("expected ':'");
      }
      at++;
      if (object.size() == FEW) {
        known = new HashSet<>();
        for (int i = 0; i < FEW; i++) {
          known.add(object.name(i));
        }
      }
      boolean isNew = known == null ? !object.has(name) : known.add(name);
      again = isNew || again != null ? again : name;
      object.add(name, value());
      first = false;
    }
    twice = twice == null ? again : twice;
    return close(object);
  }

  private List<Object> list() {
    enter();
    var list = new ArrayList<Object>();
    if (peek() != ']') {
      do {
        if (peek() == ']') {
          throw malformed("trailing comma in array");
        }
        list.add(value());
      } while (more(']'));
    }
    return close(list);
  }

  private <T> T close(T value) {
    at++;
    depth--;
    return value;
  }

  /** Passes a comma; false before the bracket that may come in its place. */
  private boolean more(char last) {
    byte b = peek();
    if (b == ',') {
      at++;
    } else if (b != last) {
      throw malformed("expected ',' or '" + last + "'");
    }
    return b == ',';
  }

  private Object word(String word, Object value) {
    for (int i = 0; i < word.length(); i++, at++) {
      if (here() != word.charAt(i)) {
        throw malformed("invalid character");
      }
    }
    return value;
  }

  private Object number() {
    int from = at;
    boolean negative = bytes[at] == '-';
    if (negative) {
      at++;
    }
    int first = at;
    long number = digits();
    int count = at - first;
    if (count > 1 && bytes[first] == '0') {
      at = first + 1;
      throw malformed("invalid number");
    }
    boolean isInteger = true;
    if (at < end && bytes[at] == '.') {
      isInteger = false;
      at++;
      digits();
    }
    if (at < end && (bytes[at] | 0x20) == 'e') {
      isInteger = false;
      at++;
      if (here() == '+' || bytes[at] == '-') {
        at++;
      }
      digits();
    }
    if (isInteger && count <= SURELY_LONG) {
      return negative ? -number : number;
    }
    String text = plain(from, at);
    if (isInteger ? count > MOST_DIGITS : isInfinite(text)) {
      throw new Unusable(OBJECT, isInteger ? "integer value out of range" : "number out of range");
    }
    return new JsonNumber(text, isInteger);
  }

  /** Whether no number of 64 bits is as large. Not by Double.parseDouble: TeaVM's loses an exponent of 20 digits. */
  private static boolean isInfinite(String number) {
    try {
      return new BigDecimal(number).abs().compareTo(INFINITE) >= 0;
    } catch (NumberFormatException tooManyDigits) {
      return number.indexOf('-', 1) < 0;
    }
  }

  /** At least one digit; their number means something if they are few. */
  private long digits() {
    if (here() < '0' || bytes[at] > '9') {
      throw malformed("invalid character");
    }
    long number = 0;
    while (at < end && bytes[at] >= '0' && bytes[at] <= '9') {
      number = 10 * number + bytes[at++] - '0';
    }
    return number;
  }

  private String string() {
    int from = ++at;
    while (at < end && bytes[at] >= ' ' && bytes[at] != '"' && bytes[at] != '\\') {
      at++;
    }
    if (here() != '"') {
      at = from;
      return unescaped();
    }
    String string = at - from <= SHORT ? known(from, at) : plain(from, at);
    at++;
    return string;
  }

  private String plain(int from, int to) {
    return new String(bytes, from, to - from, StandardCharsets.ISO_8859_1);
  }

  private String known(int from, int to) {
    int hash = 0;
    for (int i = from; i < to; i++) {
      hash = 31 * hash + bytes[i];
    }
    int place = (hash ^ hash >> 8) & met.length - 1;
    String known = met[place];
    if (known != null && known.length() == to - from) {
      int i = from;
      while (i < to && bytes[i] == known.charAt(i - from)) {
        i++;
      }
      if (i == to) {
        return known;
      }
    }
    met[place] = plain(from, to);
    return met[place];
  }

  /** The rest of a string with anything in it. */
  private String unescaped() {
    var text = new StringBuilder();
    Unusable wrong = null;
    while (here() != '"') {
      int from = at;
      int b = bytes[at++];
      if (b == '\\') {
        text.append(escape());
      } else if (b >= ' ') {
        text.append((char) b);
      } else if (b >= 0) {
        at = from;
        throw malformed("invalid character");
      } else {
        int point = point(b & 0xFF);
        if (point >= 0) {
          text.appendCodePoint(point);
        } else {
          at = from + 1;
          // A string without end is none, whatever is in it.
          wrong = wrong == null ? notUtf8(from) : wrong;
        }
      }
    }
    if (wrong != null) {
      throw wrong;
    }
    at++;
    return text.toString();
  }

  /** The rest of a character in UTF-8; -1 if it is none. */
  private int point(int first) {
    if (first < 0xC2 || first > 0xF4) {
      return -1;
    }
    int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
    int point = first & 0x3F >> more;
    for (int i = 0; i < more; i++) {
      if (at == end || (bytes[at] & 0xC0) != 0x80) {
        return -1;
      }
      point = point << 6 | bytes[at++] & 0x3F;
    }
    boolean isShortest = more == 1 || (more == 2 ? point >= 0x800 : point >= 0x10000);
    boolean isCharacter = point <= Character.MAX_CODE_POINT && (point < 0xD800 || point > 0xDFFF);
    return isShortest && isCharacter ? point : -1;
  }

  private Unusable notUtf8(int place) {
    int first = bytes[place] & 0xFF;
    boolean half = first == 0xED && place + 1 < end && (bytes[place + 1] & 0xFF) >= 0xA0;
    return half ? lone() : new Unusable("UTF-8", "the byte 16#" + Quoting.hex(first, 2).toUpperCase());
  }

  private static Unusable lone() {
    return new Unusable("whole characters", "a lone surrogate");
  }

  /** The characters that the rest of an escape sequence stands for. */
  private String escape() {
    byte b = here();
    at++;
    int named = "\"\\/bfnrt".indexOf(b);
    if (named >= 0) {
      return "\"\\/\b\f\n\r\t".substring(named, named + 1);
    }
    if (b != 'u') {
      at--;
      throw malformed("invalid escape character in string");
    }
    char c = unit();
    if (!Character.isSurrogate(c)) {
      return String.valueOf(c);
    }
    if (Character.isLowSurrogate(c) || end - at < 6 || bytes[at] != '\\' || bytes[at + 1] != 'u') {
      throw lone();
    }
    at += 2;
    char low = unit();
    if (!Character.isLowSurrogate(low)) {
      throw lone();
    }
    return "" + c + low;
  }

  private char unit() {
    int unit = 0;
    for (int i = 0; i < 4; i++, at++) {
      int digit = "0123456789abcdefABCDEF".indexOf(here());
      if (digit < 0) {
        throw malformed("invalid character in unicode escape");
      }
      unit = 16 * unit + (digit < 16 ? digit : digit - 6);
    }
    return (char) unit;
  }

  private Unusable malformed(String reason) {
    if (end - begin >= 3 && (bytes[begin] & 0xFF) == 0xEF && (bytes[begin + 1] & 0xFF) == 0xBB && at == begin) {
      return new Unusable(OBJECT, "a byte order mark");
    }
    String excerpt = excerpt(at, Math.min(end, at + EXCERPT));
    return new Unusable(OBJECT, excerpt + " at byte " + (at - begin + 1) + " (" + reason + ")");
  }

  /** A part of the bytes, which may begin or end amid a character. */
  private String excerpt(int from, int to) {
    var text = new StringBuilder();
    int here = at;
    int last = end;
    end = to;
    for (at = from; at < to; ) {
      int b = bytes[at++];
      int point = b >= 0 ? b : point(b & 0xFF);
      text.appendCodePoint(point >= 0 ? point : REPLACEMENT);
    }
    at = here;
    end = last;
    return Quoting.printable(text.toString().strip());
  }
}
