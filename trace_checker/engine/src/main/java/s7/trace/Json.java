package s7.trace;

import com.google.gson.JsonParser;
import util.UniqueString;

/**
 * Reads a text that is known to be JSON, part by part: what is asked for has to come next. It builds
 * nothing that is not asked for, which makes it several times faster than a parser for all purposes;
 * and it takes the commas on trust, since an encoder has written them.
 */
final class Json {
  private final String text;
  private int at;

  Json(String text) {
    this.text = text;
  }

  /** The next character, which is not passed; 0 at the end. */
  char peek() {
    while (at < text.length()) {
      char c = text.charAt(at);
      if (c > ' ') {
        return c;
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

  /** Whether there is another element or field; if not, the end of the array or object is passed. */
  boolean more(char end) {
    char c = peek();
    if (c == ',' || c == end) {
      at++;
    }
    return c != end;
  }

  /** Passes the name of a field and says which of {@code names} it is; -1 if it is none of them. */
  int name(UniqueString[] names) {
    int begin = at(peek(), '"') + 1;
    passString();
    int length = at - 1 - begin;
    pass(':');
    for (int i = 0; i < names.length; i++) {
      String name = names[i].toString();
      if (name.length() == length && text.startsWith(name, begin)) {
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
    int begin = at(peek(), '"');
    boolean plain = passString();
    return plain
        ? text.substring(begin + 1, at - 1)
        : JsonParser.parseString(text.substring(begin, at)).getAsString();
  }

  /** An integer of 32 bits. */
  int number() {
    peek();
    int begin = at;
    passWord();
    return Integer.parseInt(text, begin, at, 10);
  }

  boolean truth() {
    char c = peek();
    passWord();
    return c == 't';
  }

  /** Passes a value, whatever it is. */
  void skip() {
    int depth = 0;
    do {
      switch (peek()) {
        case '"' -> passString();
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

  private int at(char found, char expected) {
    if (found != expected) {
      throw refused("'" + expected + "'");
    }
    return at;
  }

  /** Passes a string and says whether its characters are those between its quotes. */
  private boolean passString() {
    boolean plain = true;
    for (at++; text.charAt(at) != '"'; at++) {
      if (text.charAt(at) == '\\') {
        plain = false;
        at++;
      }
    }
    at++;
    return plain;
  }

  /** Passes a number, true, false or null. */
  private void passWord() {
    while (at < text.length() && ",:]} ".indexOf(text.charAt(at)) < 0) {
      at++;
    }
  }

  private IllegalArgumentException refused(String expected) {
    return new IllegalArgumentException(expected + " expected at " + at + " of " + text);
  }
}
