package s7.log;

/** The calendar, as far as the reading of a log needs it. */
public final class Days {
  static final int FIRST_YEAR = 1990;
  static final int LAST_YEAR = 2089;

  private static final int[] LENGTHS = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  private static final int MS_PER_DAY = 86_400_000;

  private Days() {}

  /** The number of its days. */
  public static int ofMonth(int year, int month) {
    return month == 2 && isLeap(year) ? 29 : LENGTHS[month - 1];
  }

  private static boolean isLeap(int year) {
    return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
  }

  private static int ofYear(int year) {
    return isLeap(year) ? 366 : 365;
  }

  /** The days from 1990-01-01 to a date that exists. */
  public static int to(int year, int month, int day) {
    // From 1990 to 2089 each fourth year is a leap year, 1992 the first.
    int days = 365 * (year - FIRST_YEAR) + (year - FIRST_YEAR + 1) / 4 + day - 1;
    for (int before = 1; before < month; before++) {
      days += ofMonth(year, before);
    }
    return days;
  }

  /** Milliseconds since 1990-01-01T00:00 as a log spells them, such as {@code 2026-11-21T06:00:00.000}. */
  public static String iso(long milliseconds) {
    int days = (int) (milliseconds / MS_PER_DAY);
    int rest = (int) (milliseconds % MS_PER_DAY);
    int year = FIRST_YEAR;
    for (; days >= ofYear(year); year++) {
      days -= ofYear(year);
    }
    int month = 1;
    for (; days >= ofMonth(year, month); month++) {
      days -= ofMonth(year, month);
    }
    return spelled(
        year, month, days + 1, rest / 3_600_000, rest / 60_000 % 60, rest / 1_000 % 60, rest % 1_000);
  }

  /** Year to milliseconds, which need not exist, as a log spells them. */
  public static String spelled(int... parts) {
    var text = new StringBuilder();
    for (int i = 0; i < parts.length; i++) {
      String number = String.valueOf(parts[i]);
      String before = i == 0 ? "" : "--T::.".substring(i - 1, i);
      text.append(before).append("000", 0, (i == 0 ? 4 : i == 6 ? 3 : 2) - number.length()).append(number);
    }
    return text.toString();
  }
}
