package tla.json;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

import com.google.gson.JsonParser;
import util.UniqueString;

/**
 * Reads a text that is known to be JSON, part by part: the caller asks for the part that has to come
 * next. It builds no other part, so it is several times faster than a parser for all purposes. It
 * takes the commas on trust, since an encoder has written them.
 *
 * <p>A part of another kind than the caller asks for is an IllegalArgumentException, a text that ends
 * too early an IndexOutOfBoundsException.
 */
public final class Json {
  private final byte[] bytes;
  private final int begin;
  private final int end;
  private int at;

  /** The text from {@code begin} to before {@code end}, in UTF-8. */
  Json(byte[] bytes, int begin, int end) {
    this.bytes = bytes;
    this.begin = begin;
    this.end = end;
    at = begin;
  }

  public static Json of(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    return new Json(bytes, 0, bytes.length);
  }

  /** The same text, which stays valid. */
  public Json copy() {
    byte[] own = Arrays.copyOfRange(bytes, begin, end);
    return new Json(own, 0, own.length);
  }

  /** A question about the bytes of a text. */
  public interface Question {
    boolean of(byte[] bytes, int begin, int end);
  }

  /** The answer to a question about the bytes. */
  public boolean ask(Question question) {
    return question.of(bytes, begin, end);
  }

  /** Whether it has spaces alone, or nothing. */
  public boolean isBlank() {
    for (int i = begin; i < end; i++) {
      if (bytes[i] != ' ' && bytes[i] != '\t' && bytes[i] != '\r') {
        return false;
      }
    }
    return true;
  }

  /** The whole text. */
  @Override
  public String toString() {
    return text(begin, end);
  }

  /**
   * The string in the first field of an object, if that field is called {@code name}; else null. The
   * object can then be read from its begin.
   */
  public String first(String name) {
    at = begin;
    pass('{');
    String found = more('}') && name().equals(name) && peek() == '"' ? string() : null;
    at = begin;
    return found;
  }

  /** The next character, which stays the next; 0 at the end. */
  char peek() {
    while (at < end) {
      if (bytes[at] > ' ') {
        return (char) bytes[at];
      }
      at++;
    }
    return 0;
  }

  /** Passes a character that has to come next. */
  void pass(char expected) {
    if (peek() != expected) {
      throw refused("'" + expected + "'");
    }
    at++;
  }

  /** Whether another element or field follows; if not, passes {@code last}, the end of the array or object. */
  boolean more(char last) {
    char c = peek();
    if (c == ',' || c == last) {
      at++;
    }
    return c != last;
  }

  /** Passes the name of a field and returns its place in {@code names}, or -1. */
  int name(UniqueString[] names) {
    pass('"');
    int from = at;
    passString();
    int length = at - 1 - from;
    pass(':');
    for (int i = 0; i < names.length; i++) {
      String name = names[i].toString();
      if (name.length() == length && isAt(from, name)) {
        return i;
      }
    }
    return -1;
  }

  /** Passes the name of a field. */
  String name() {
    String name = string();
    pass(':');
    return name;
  }

  String string() {
    pass('"');
    int from = at;
    boolean plain = passString();
    return plain
        ? text(from, at - 1)
        : JsonParser.parseString(text(from - 1, at)).getAsString();
  }

  /** An integer of 32 bits. */
  int number() {
    boolean negative = peek() == '-';
    if (negative) {
      at++;
    }
    int from = at;
    long number = 0;
    while (at < end && bytes[at] >= '0' && bytes[at] <= '9' && at - from < 10) {
      number = 10 * number + bytes[at++] - '0';
    }
    if (at == from) {
      throw refused("an integer");
    }
    return Math.toIntExact(negative ? -number : number);
  }

  boolean truth() {
    char c = peek();
    passWord();
    return c == 't';
  }

  /** Passes a value of any kind. */
  void skip() {
    int depth = 0;
    do {
      switch (peek()) {
        case '"' -> {
          at++;
          passString();
        }
        case '{', '[' -> {
          depth++;
          at++;
        }
        case '}', ']' -> {
          depth--;
          at++;
        }
        case ',', ':' -> at++;
        case 0 -> throw refused("a value");
        default -> passWord();
      }
    } while (depth > 0);
  }

  /** Passes the rest of a string; false if it has an escaped character. */
  private boolean passString() {
    boolean plain = true;
    while (bytes[at] != '"') {
      if (bytes[at] == '\\') {
        plain = false;
        at++;
      }
      at++;
    }
    at++;
    return plain;
  }

  /** Passes a number, true, false or null. */
  private void passWord() {
    while (at < end && ",:]} ".indexOf(bytes[at]) < 0) {
      at++;
    }
  }

  private boolean isAt(int from, String part) {
    if (part.length() > end - from) {
      return false;
    }
    for (int i = 0; i < part.length(); i++) {
      if (bytes[from + i] != part.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  private String text(int from, int to) {
    return new String(bytes, from, to - from, StandardCharsets.UTF_8);
  }

  private IllegalArgumentException refused(String expected) {
    return new IllegalArgumentException(expected + " expected at " + (at - begin) + " of " + this);
  }
}
