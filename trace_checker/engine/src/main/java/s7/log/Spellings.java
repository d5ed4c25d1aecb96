package s7.log;

import java.util.Arrays;
import java.util.Collection;

/** The spellings of single values. */
final class Spellings {
  /** Stands for {@code null} in normalised events. */
  static final int NOT_LOGGED = -1;

  private static final String DATE_EXPECTED = "a date and time such as \"2026-11-21T06:00:00.000\"";
  private static final String DURATION_EXPECTED =
      "a duration such as \"T#1s500ms\" or an integer -2147483648..2147483647 of milliseconds";

  /** A word, 0..65535; signed integers are taken as their 16 bits. */
  static final Reader WORD =
      value -> hexadecimal(value, -0x8000, 0xFFFF, "a word such as \"W#16#8090\" or an integer -32768..65535");

  /** A word, or {@link #NOT_LOGGED}. */
  static final Reader WORD_OR_NULL =
      value ->
          value == null
              ? (Object) NOT_LOGGED
              : hexadecimal(
                  value, -0x8000, 0xFFFF, "a word such as \"W#16#8090\" or an integer -32768..65535", ", or null");

  /** A byte, 0..255. */
  static final Reader BYTE =
      value -> hexadecimal(value, 0, 0xFF, "a byte such as \"B#16#80\" or an integer 0..255");

  static final Reader TRUTH =
      value -> {
        if (value instanceof Boolean) {
          return value;
        }
        throw new Unusable("true or false", Quoting.quote(value));
      };

  /** 1 for {@code true}, 0 for {@code false}; a field that is not given has another number. */
  static final Reader TRUTH_NUMBER = value -> (Boolean) TRUTH.read(value) ? 1 : 0;

  private Spellings() {}

  /** Integers in a range. */
  static Reader integer(long low, long high) {
    String expected = "an integer " + low + ".." + high;
    return value -> {
      if (value instanceof Long number && low <= number && number <= high) {
        return number;
      }
      throw new Unusable(expected, Quoting.quote(value));
    };
  }

  /** One of these strings. */
  static Reader choice(String... allowed) {
    return choice(Arrays.asList(allowed));
  }

  static Reader choice(Collection<String> allowed) {
    String expected = "\"" + String.join("\" or \"", allowed) + "\"";
    return value -> {
      if (value instanceof String text && allowed.contains(text)) {
        return value;
      }
      throw new Unusable(expected, Quoting.quote(value));
    };
  }

  /** The length of a date and time to the millisecond in ISO's way, and where its parts end. */
  static final int ISO_LENGTH = 23;

  private static final int[] ENDS = {4, 7, 10, 13, 16, 19, ISO_LENGTH};

  private static int hexadecimal(Object value, int low, int high, String expected) {
    return hexadecimal(value, low, high, expected, "");
  }

  /** Integers in a range, and S7's hexadecimal spellings of them. */
  private static int hexadecimal(Object value, int low, int high, String expected, String more) {
    if (value instanceof Long number && low <= number && number <= high) {
      return (int) (number & 0xFFFF);
    }
    if (value instanceof String text) {
      int number = digits(text, text.startsWith("16#") ? 3 : begins(text, "w#16#") ? 5 : -1, 4);
      if (number < 0 && begins(text, "b#16#")) {
        number = digits(text, 5, 2);
      }
      if (number >= 0 && number <= high) {
        return number;
      }
      number = begins(text, "0x") ? digits(text, 2, 4) : -1;
      if (number >= 0 && number <= high) {
        String digits = Quoting.hex(number, high == 0xFF ? 2 : 4).toUpperCase();
        throw new Unusable("the spelling \"16#" + digits + "\"" + more, Quoting.quote(value));
      }
    }
    throw new Unusable(expected + more, Quoting.quote(value));
  }

  /** Whether a text begins with these characters; S7 writes its letters, those of ASCII, in either case. */
  private static boolean begins(String text, String lower) {
    if (text.length() < lower.length()) {
      return false;
    }
    for (int i = 0; i < lower.length(); i++) {
      if (lower(text.charAt(i)) != lower.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  private static char lower(char c) {
    return c >= 'A' && c <= 'Z' ? (char) (c + 'a' - 'A') : c;
  }

  /** The number of the hexadecimal digits behind {@code from}, one at least; -1 if there is anything else. */
  private static int digits(String text, int from, int most) {
    int count = text.length() - from;
    if (from < 0 || count < 1 || count > most) {
      return -1;
    }
    int number = 0;
    for (int i = from; i < text.length(); i++) {
      int digit = "0123456789abcdef".indexOf(lower(text.charAt(i)));
      if (digit < 0) {
        return -1;
      }
      number = 16 * number + digit;
    }
    return number;
  }

  /** A TIME: milliseconds in signed 32 bits, or S7's spelling such as {@code T#-1m_30s}. */
  static Object duration(Object value) {
    Long number = value instanceof Long given ? given : value instanceof String text ? new Spelled(text).duration() : null;
    if (number != null && number == number.intValue()) {
      return number.intValue();
    }
    throw new Unusable(DURATION_EXPECTED, Quoting.quote(value));
  }

  /** The numbers of a date and time that need not exist; this is how a program may have passed it. */
  static Object dateComponents(Object value) {
    int[] parts = parts(value);
    var components = new Fields();
    String[] names = {"year", "month", "day", "hour", "minute", "second", "ms"};
    for (int i = 0; i < names.length; i++) {
      components.add(names[i], parts[i]);
    }
    return components;
  }

  /** Year to milliseconds of a date and time that need not exist. */
  static int[] parts(Object value) {
    int[] parts = null;
    if (value instanceof String text) {
      parts = iso(text);
      parts = parts == null ? new Spelled(text).date() : parts;
    }
    if (parts == null) {
      throw new Unusable(DATE_EXPECTED, Quoting.quote(value));
    }
    return parts;
  }

  /** Year to milliseconds of a date and time such as {@code 2026-11-21T06:00:00.000}; null if it is none. */
  private static int[] iso(String text) {
    int length = text.length();
    if (length < 16 || text.charAt(4) != '-' || text.charAt(7) != '-' || text.charAt(10) != 'T'
        || text.charAt(13) != ':') {
      return null;
    }
    int second = 0;
    int ms = 0;
    if (length > 16) {
      second = text.charAt(16) == ':' ? number(text, 17, 19) : -1;
    }
    if (length > 19) {
      ms = text.charAt(19) == '.' && length <= 23 ? number(text, 20, length) : -1;
      ms *= length == 21 ? 100 : length == 22 ? 10 : 1;
    }
    int[] parts = {
      number(text, 0, 4), number(text, 5, 7), number(text, 8, 10), number(text, 11, 13), number(text, 14, 16), second, ms
    };
    return (parts[0] | parts[1] | parts[2] | parts[3] | parts[4] | second | ms) < 0 ? null : parts;
  }

  /** The number of the digits from one place to before another, one at least; -1 if something else is there. */
  private static int number(String text, int from, int to) {
    int number = from < to && to <= text.length() ? 0 : -1;
    for (int i = from; i < to && number >= 0; i++) {
      char c = text.charAt(i);
      number = c >= '0' && c <= '9' ? 10 * number + c - '0' : -1;
    }
    return number;
  }

  /** A date and time that exists, 1990 to 2089, as milliseconds since 1990-01-01T00:00. */
  static Long instant(Object value) {
    int[] parts = parts(value);
    if (parts[0] < Days.FIRST_YEAR || parts[0] > Days.LAST_YEAR) {
      throw new Unusable("a date and time from 1990-01-01 to 2089-12-31", Quoting.quote(value));
    }
    if (!exists(parts)) {
      throw new Unusable("a date and time that exists", Quoting.quote(value));
    }
    return milliseconds(parts);
  }

  private static boolean exists(int... parts) {
    return parts[0] >= Days.FIRST_YEAR && parts[0] <= Days.LAST_YEAR && parts[1] >= 1 && parts[1] <= 12
        && parts[2] >= 1 && parts[2] <= Days.ofMonth(parts[0], parts[1])
        && parts[3] <= 23 && parts[4] <= 59 && parts[5] <= 59;
  }

  private static long milliseconds(int... parts) {
    long hours = 24L * Days.to(parts[0], parts[1], parts[2]) + parts[3];
    return ((hours * 60 + parts[4]) * 60 + parts[5]) * 1000 + parts[6];
  }

  /** The same of bytes such as {@code 2026-11-21T06:00:00.000}; -1 for others. */
  static long instant(byte[] text, int from) {
    for (int i = 0; i < 6; i++) {
      if (text[from + ENDS[i]] != "--T::.".charAt(i)) {
        return -1;
      }
    }
    var parts = new int[7];
    for (int i = 0; i < parts.length; i++) {
      for (int k = i == 0 ? 0 : ENDS[i - 1] + 1; k < ENDS[i]; k++) {
        int digit = text[from + k] - '0';
        if (digit < 0 || digit > 9) {
          return -1;
        }
        parts[i] = 10 * parts[i] + digit;
      }
    }
    return exists(parts) ? milliseconds(parts) : -1;
  }

  /** The same as a moment. */
  static Object moment(Object value) {
    return Moment.of(instant(value));
  }

  /** The same as whole minutes. */
  static Object minute(Object value) {
    return (int) (instant(value) / Moment.MS_PER_MINUTE);
  }

  /** The milliseconds of the unit in which a date and time is written. */
  static int step(String date) {
    if (date.indexOf('.') >= 0) {
      return 1;
    }
    return date.indexOf(':') < date.lastIndexOf(':') ? 1000 : Moment.MS_PER_MINUTE;
  }

  /** A text that is read from left to right. */
  private static final class Spelled {
    private static final String[] UNITS = {"d", "h", "m", "s", "ms"};
    private static final int[] MILLISECONDS = {86_400_000, 3_600_000, 60_000, 1_000, 1};
    private static final int MOST_DIGITS = 10;

    private final String text;
    private int at;

    Spelled(String text) {
      this.text = text;
    }

    private boolean pass(char c) {
      boolean is = at < text.length() && text.charAt(at) == c;
      at += is ? 1 : 0;
      return is;
    }

    private boolean passAny(String... begins) {
      for (String begin : begins) {
        if (begins(text, begin)) {
          at = begin.length();
          return true;
        }
      }
      return false;
    }

    /** A number of so many digits; -1 if there are others. */
    private long number(int fewest, int most) {
      int from = at;
      long number = 0;
      while (at < text.length() && text.charAt(at) >= '0' && text.charAt(at) <= '9') {
        number = 10 * number + text.charAt(at++) - '0';
      }
      return at - from < fewest || at - from > most ? -1 : number;
    }

    private boolean isAtEnd() {
      return at == text.length();
    }

    Long duration() {
      if (!passAny("t#", "time#")) {
        return null;
      }
      boolean negative = pass('-');
      long sum = 0;
      int last = -1;
      do {
        long number = number(1, MOST_DIGITS);
        int unit = unit();
        if (number < 0 || unit <= last) {
          return null;
        }
        sum += number * MILLISECONDS[unit];
        last = unit;
        if (pass('_') && (isAtEnd() || unit == UNITS.length - 1)) {
          return null;
        }
      } while (!isAtEnd());
      return negative ? -sum : sum;
    }

    /** Passes a unit; -1 if there is none. */
    private int unit() {
      for (int unit = UNITS.length - 1; unit >= 0; unit--) {
        if (begins(text.substring(at), UNITS[unit])) {
          at += UNITS[unit].length();
          return unit;
        }
      }
      return -1;
    }

    /** Year to milliseconds of S7's spelling; null if it is no date. */
    int[] date() {
      if (!passAny("dt#", "date_and_time#")) {
        return null;
      }
      var parts = new int[7];
      char[] before = {0, '-', '-', '-', ':', ':'};
      for (int i = 0; i < before.length; i++) {
        if (i == 5 && isAtEnd()) {
          return parts;
        }
        long part = i > 0 && !pass(before[i]) ? -1 : i == 0 ? number(4, 4) : number(1, 2);
        if (part < 0) {
          return null;
        }
        parts[i] = (int) part;
      }
      if (pass('.')) {
        int from = at;
        long fraction = number(1, 3);
        for (int digits = at - from; digits < 3; digits++) {
          fraction *= 10;
        }
        parts[6] = (int) fraction;
        return fraction < 0 || !isAtEnd() ? null : parts;
      }
      return isAtEnd() ? parts : null;
    }
  }
}
