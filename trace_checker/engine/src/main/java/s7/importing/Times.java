package s7.importing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import s7.log.Days;
import s7.log.Quoting;
import s7.log.Unusable;

/** How a source writes dates and times: what {@code strptime} of Python and C calls a format. */
final class Times {
  private static final List<String> MONTHS =
      List.of(
          "January", "February", "March", "April", "May", "June", "July", "August", "September", "October", "November",
          "December");

  private static final String SHORT_MONTHS = "Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec";

  /** Letter, what may stand for it, an example. */
  private static final List<String[]> DIRECTIVES =
      List.of(
          new String[] {"Y", "\\d{4}", "2026"},
          new String[] {"y", "\\d{2}", "26"},
          new String[] {"m", "1[0-2]|0[1-9]|[1-9]", "11"},
          new String[] {"b", SHORT_MONTHS, "Nov"},
          new String[] {"B", String.join("|", MONTHS), "November"},
          new String[] {"d", "3[01]|[12]\\d|0[1-9]|[1-9]", "21"},
          new String[] {"a", "Mon|Tue|Wed|Thu|Fri|Sat|Sun", "Sat"},
          new String[] {"A", "Monday|Tuesday|Wednesday|Thursday|Friday|Saturday|Sunday", "Saturday"},
          new String[] {"H", "2[0-3]|[01]\\d|\\d", "06"},
          new String[] {"I", "1[0-2]|0[1-9]|[1-9]", "06"},
          new String[] {"p", "AM|PM", "AM"},
          new String[] {"M", "[0-5]\\d|\\d", "00"},
          new String[] {"S", "[0-5]\\d|\\d", "30"},
          new String[] {"f", "\\d{1,6}", "500000"});

  private final String format;
  private final Pattern pattern;
  private final String letters;
  private final String example;

  Times(String format) {
    this.format = format;
    var text = new StringBuilder();
    var found = new StringBuilder();
    var like = new StringBuilder();
    for (int i = 0; i < format.length(); i++) {
      char c = format.charAt(i);
      String[] directive = c == '%' && !format.startsWith("%", i + 1) ? directive(format, i + 1) : null;
      if (directive != null) {
        text.append('(').append(directive[1]).append(')');
        found.append(directive[0]);
        like.append(directive[2]);
      } else {
        text.append(c == ' ' ? "\\s+" : Character.isLetterOrDigit(c) ? String.valueOf(c) : "\\" + c);
        like.append(c);
      }
      i += c == '%' ? 1 : 0;
    }
    pattern = Pattern.compile(text.toString(), Pattern.CASE_INSENSITIVE);
    letters = found.toString();
    example = like.toString();
  }

  private static String[] directive(String format, int at) {
    var names = new ArrayList<String>();
    for (String[] one : DIRECTIVES) {
      if (format.startsWith(one[0], at)) {
        return one;
      }
      names.add("%" + one[0]);
    }
    throw new Unusable("in \"times\" " + String.join(" ", names) + " or %%", Quoting.inMarks(format)).of("column map");
  }

  /** The time as a log spells it. */
  String read(String written) {
    Matcher found = pattern.matcher(written);
    int[] parts = {1900, 1, 1, 0, 0, 0, 0};
    if (found.matches()) {
      boolean afternoon = false;
      for (int i = 0; i < letters.length(); i++) {
        String part = found.group(i + 1);
        char letter = letters.charAt(i);
        afternoon |= letter == 'p' && part.equalsIgnoreCase("PM");
        take(parts, letter, part);
      }
      parts[3] += afternoon && letters.indexOf('I') >= 0 ? 12 : 0;
    }
    if (!found.matches() || !Bcd.exists(parts)) {
      throw new Unusable(
          "a time like " + Quoting.inMarks(example) + " (\"times\": " + Quoting.inMarks(format) + ")",
          Quoting.inMarks(written));
    }
    return Days.spelled(parts);
  }

  private static void take(int[] parts, char letter, String part) {
    switch (letter) {
      case 'Y' -> parts[0] = Integer.parseInt(part);
      case 'y' -> parts[0] = Integer.parseInt(part) + (part.compareTo("69") < 0 ? 2000 : 1900);
      case 'm' -> parts[1] = Integer.parseInt(part);
      case 'b', 'B' -> {
        String begin = part.substring(0, 3).toLowerCase();
        parts[1] = 1 + Arrays.asList(SHORT_MONTHS.toLowerCase().split("\\|")).indexOf(begin);
      }
      case 'd' -> parts[2] = Integer.parseInt(part);
      case 'H' -> parts[3] = Integer.parseInt(part);
      case 'I' -> parts[3] = Integer.parseInt(part) % 12;
      case 'M' -> parts[4] = Integer.parseInt(part);
      case 'S' -> parts[5] = Integer.parseInt(part);
      case 'f' -> parts[6] = Integer.parseInt((part + "00").substring(0, 3));
      default -> {
        // A day of the week says nothing more.
      }
    }
  }
}
