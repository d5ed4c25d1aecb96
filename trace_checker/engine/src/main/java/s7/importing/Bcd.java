package s7.importing;

import s7.log.Days;

/** DATE_AND_TIME: eight bytes of BCD, {@code yy mm dd hh mi ss ms ms|weekday}; the weekday is not looked at. */
final class Bcd {
  static final int LENGTH = 8;

  /** Two-digit years from here on are of the 20th century. */
  private static final int FIRST_YEAR = 90;

  private Bcd() {}

  /**
   * The date and time as a log spells it, whether it exists or not, since a program may pass any.
   *
   * @return null if a half-byte is no decimal digit, which no spelling can express
   */
  static String digits(byte[] raw, int at) {
    int[] parts = parts(raw, at);
    return parts == null ? null : Days.spelled(parts);
  }

  /** As {@link #digits}; null also for one that does not exist. */
  static String instant(byte[] raw, int at) {
    int[] parts = parts(raw, at);
    return parts != null && exists(parts) ? Days.spelled(parts) : null;
  }

  /** Milliseconds since 1990 of one that exists. */
  static long milliseconds(byte[] raw, int at) {
    int[] parts = parts(raw, at);
    long minutes = (Days.to(parts[0], parts[1], parts[2]) * 24L + parts[3]) * 60 + parts[4];
    return (minutes * 60 + parts[5]) * 1000 + parts[6];
  }

  static boolean exists(int... parts) {
    return parts[0] >= 1
        && parts[1] >= 1
        && parts[1] <= 12
        && parts[2] >= 1
        && parts[2] <= Days.ofMonth(parts[0], parts[1])
        && parts[3] < 24
        && parts[4] < 60
        && parts[5] < 60;
  }

  /** A year of two digits, whole. */
  static int year(int ofTwoDigits) {
    return ofTwoDigits + (ofTwoDigits >= FIRST_YEAR ? 1900 : 2000);
  }

  private static int[] parts(byte[] raw, int at) {
    if (at + LENGTH > raw.length) {
      return null;
    }
    var digits = new int[2 * LENGTH];
    for (int i = 0; i < digits.length; i++) {
      digits[i] = Octets.one(raw, at + i / 2) >> (i % 2 == 0 ? 4 : 0) & 0xF;
      if (digits[i] > 9 && i < digits.length - 1) {
        return null;
      }
    }
    var parts = new int[7];
    for (int i = 0; i < 6; i++) {
      parts[i] = 10 * digits[2 * i] + digits[2 * i + 1];
    }
    parts[0] = year(parts[0]);
    parts[6] = 100 * digits[12] + 10 * digits[13] + digits[14];
    return parts;
  }
}
