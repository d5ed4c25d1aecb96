package s7.trace;

import java.nio.charset.StandardCharsets;
import java.time.DateTimeException;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;

/**
 * Takes the text of a line apart: the values of some fields, and the rest of the text with marks in
 * their place. Two lines with the same rest differ in these values alone.
 *
 * <p>The fields are those of points in time and counters, of which the values are read if they have
 * their plain form, and the implementer's own, which are passed over. Python says which these are.
 */
final class LineText {
  /** Bytes; a longer line is not taken apart. */
  private static final int LONGEST = 2_000;

  private static final int MOST_VALUES = 16;
  private static final int MOST_DIGITS = 15;
  private static final long EPOCH = LocalDate.of(1990, 1, 1).toEpochDay();

  /** Marks of a number and of a string; no JSON has these bytes. */
  private static final byte NUMBER = 1;

  private static final byte STRING = 2;

  /**
   * A field of a line, or of the object that the line has in the field {@code inside}.
   *
   * @param low the least of its values, and {@code high} the largest; dates are milliseconds since 1990
   */
  record Field(String path, byte[] inside, byte[] name, boolean isDate, long low, long high) {
    private static Field of(String path, JsonArray form) {
      int point = path.indexOf('.');
      return new Field(
          path,
          point < 0 ? null : ascii(path.substring(0, point)),
          ascii(path.substring(point + 1)),
          form.get(0).getAsString().equals("date"),
          form.get(1).getAsLong(),
          form.get(2).getAsLong());
    }

    private boolean isAt(byte[] bytes, int from, int to, byte[] object) {
      return Arrays.equals(bytes, from, to, name, 0, name.length)
          && (inside == null ? object == null : object != null && Arrays.equals(inside, object));
    }
  }

  private final List<Field> varying = new ArrayList<>();
  private final List<byte[]> objects = new ArrayList<>();
  private final byte[] own;

  private byte[] bytes;
  private int end;
  private final byte[] rest = new byte[LONGEST];
  private int length;
  private final Field[] fields = new Field[MOST_VALUES];
  private final long[] values = new long[MOST_VALUES];
  private int count;
  private int knownDate;
  private long knownDay;

  /**
   * @param varying such as {@code {"at":["date",0,9],"info.time":["date",0,9],"up":["number",0,9]}}: form and
   *     range of each field
   * @param own how the names of the implementer's own fields begin
   */
  LineText(JsonObject varying, String own) {
    for (Map.Entry<String, JsonElement> entry : varying.entrySet()) {
      var field = Field.of(entry.getKey(), entry.getValue().getAsJsonArray());
      this.varying.add(field);
      if (field.inside != null) {
        objects.add(field.inside);
      }
    }
    this.own = ascii(own);
  }

  private static byte[] ascii(String text) {
    return text.getBytes(StandardCharsets.US_ASCII);
  }

  /** The fields whose values were read, in the order of the line. */
  Field[] fields() {
    return Arrays.copyOf(fields, count);
  }

  /** The value of a field, which is that with the number {@code i} among {@link #fields}. */
  long value(int i) {
    return values[i];
  }

  /** A hash of the rest. */
  long hash() {
    long hash = length;
    for (int i = 0; i < length; i++) {
      hash = 31 * hash + rest[i];
    }
    return hash;
  }

  /** Whether the rest is this one. */
  boolean hasRest(byte[] other) {
    return Arrays.equals(rest, 0, length, other, 0, other.length);
  }

  /** The rest of the text. */
  byte[] rest() {
    return Arrays.copyOf(rest, length);
  }

  /** Takes a line apart; false if the value of a field is not in its plain form. */
  boolean take(byte[] line, int from, int to) {
    if (to - from > LONGEST) {
      return false;
    }
    bytes = line;
    end = to;
    length = 0;
    count = 0;
    int depth = 0;
    byte[] object = null;
    byte[] next = null;
    for (int at = from; at < end; ) {
      byte b = bytes[at];
      if (b != '"') {
        if (b == '{' || b == '[') {
          depth++;
          object = depth == 2 ? next : null;
        } else if (b == '}' || b == ']') {
          depth--;
          object = null;
        }
        rest[length++] = b;
        at++;
        continue;
      }
      int close = closing(at + 1);
      if (close < 0) {
        return false;
      }
      int name = at + 1;
      at = copy(at, close + 1);
      if (at == end || bytes[at] != ':') {
        continue;
      }
      at = copy(at, at + 1);
      while (at < end && bytes[at] == ' ') {
        at = copy(at, at + 1);
      }
      next = depth == 1 ? object(name, close) : null;
      if (depth == 1 || depth == 2 && object != null) {
        at = value(name, close, object, at);
        if (at < 0) {
          return false;
        }
      }
    }
    return true;
  }

  private int copy(int from, int to) {
    System.arraycopy(bytes, from, rest, length, to - from);
    length += to - from;
    return to;
  }

  /** The place of the quote at the end of a string; -1 if there is none. */
  private int closing(int from) {
    for (int at = from; at < end; at++) {
      if (bytes[at] == '"') {
        return at;
      }
      if (bytes[at] == '\\') {
        at++;
      }
    }
    return -1;
  }

  /** The name, if a field of the object in this field may differ. */
  private byte[] object(int from, int to) {
    for (byte[] each : objects) {
      if (Arrays.equals(bytes, from, to, each, 0, each.length)) {
        return each;
      }
    }
    return null;
  }

  /** Passes a value that may differ; the place after it, -1 if it is not in its plain form. */
  private int value(int name, int close, byte[] object, int at) {
    if (close - name >= own.length && Arrays.equals(bytes, name, name + own.length, own, 0, own.length)) {
      return own(at);
    }
    for (Field field : varying) {
      if (field.isAt(bytes, name, close, object)) {
        if (count == MOST_VALUES) {
          return -1;
        }
        int after = field.isDate ? date(at) : number(at);
        fields[count] = field;
        boolean allowed = after >= 0 && values[count] >= field.low && values[count] <= field.high;
        count++;
        return allowed ? after : -1;
      }
    }
    return at;
  }

  /** Passes the value of an implementer's own field if that is a short text or number. */
  private int own(int at) {
    if (at < end && bytes[at] == '"') {
      int close = at + 1;
      while (close < end && bytes[close] >= ' ' && bytes[close] != '"' && bytes[close] != '\\') {
        close++;
      }
      if (close < end && bytes[close] == '"') {
        rest[length++] = STRING;
        return close + 1;
      }
      return at;
    }
    int after = number(at);
    return after < 0 ? at : after;
  }

  /** A number without sign; -1 if there is none. */
  private int number(int from) {
    int at = from;
    long number = 0;
    while (at < end && isDigit(at)) {
      number = 10 * number + bytes[at++] - '0';
    }
    if (at == from || at - from > MOST_DIGITS || at - from > 1 && bytes[from] == '0') {
      return -1;
    }
    if (count < MOST_VALUES) {
      values[count] = number;
    }
    rest[length++] = NUMBER;
    return at;
  }

  /** Such as "2026-11-21T06:00:00.000"; seconds and milliseconds may be missing. */
  private int date(int from) {
    if (end - from < 18 || bytes[from] != '"') {
      return -1;
    }
    int year = digits(from + 1, 4, (byte) '"');
    int month = digits(from + 6, 2, (byte) '-');
    int day = digits(from + 9, 2, (byte) '-');
    int hour = digits(from + 12, 2, (byte) 'T');
    int minute = digits(from + 15, 2, (byte) ':');
    int at = from + 17;
    int second = 0;
    int ms = 0;
    if (bytes[at] == ':') {
      second = digits(at + 1, 2, (byte) ':');
      at += 3;
      if (at < end && bytes[at] == '.') {
        int unit = 100;
        for (at++; at < end && isDigit(at) && unit > 0; at++, unit /= 10) {
          ms += unit * (bytes[at] - '0');
        }
        if (unit == 100) {
          return -1;
        }
      }
    }
    if (at >= end || bytes[at] != '"' || (year | month | day | hour | minute | second) < 0
        || hour > 23 || minute > 59 || second > 59) {
      return -1;
    }
    int date = (year * 100 + month) * 100 + day;
    if (date != knownDate) {
      try {
        knownDay = LocalDate.of(year, month, day).toEpochDay() - EPOCH;
      } catch (DateTimeException e) {
        return -1;
      }
      knownDate = date;
    }
    values[count] = (((knownDay * 24 + hour) * 60 + minute) * 60 + second) * 1000 + ms;
    // The digits of the rest say the form alone.
    for (int i = from; i <= at; i++) {
      rest[length++] = isDigit(i) ? (byte) '0' : bytes[i];
    }
    return at + 1;
  }

  /** So many digits after the byte {@code before}; -1 if they are not there. */
  private int digits(int from, int many, byte before) {
    if (from + many > end || bytes[from - 1] != before) {
      return -1;
    }
    int number = 0;
    for (int at = from; at < from + many; at++) {
      if (!isDigit(at)) {
        return -1;
      }
      number = 10 * number + bytes[at] - '0';
    }
    return number;
  }

  private boolean isDigit(int at) {
    return bytes[at] >= '0' && bytes[at] <= '9';
  }
}
