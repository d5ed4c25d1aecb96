package s7.importing;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import s7.log.Days;
import s7.log.Quoting;
import s7.log.Unusable;

/**
 * The diagnostic buffer as STEP 7 V5 saves it as text (Module Information, Diagnostic Buffer, Save As).
 *
 * <p>What counts is the same in every language: the line that begins an entry, the event ID in it or in a line of its
 * own, as TIA Portal shows it, the coding in parentheses, the line that ends with time and date. The descriptions
 * between them are not read.
 */
final class Step7Text {
  private static final String EVENT = "(?:Event|Ereignis|.v.nement|Evento)";
  private static final Pattern BEGIN =
      pattern(
          "\\s*(?:Details (?:on|zum) |D.tails de l')?" + EVENT
              + "(?: ?details)?\\s?:?\\s+(\\d{1,9})\\s+(?:of|von|sur|de|di)\\s+\\d+\\b(.*)");
  private static final Pattern EVENT_ID =
      pattern("\\s*:?\\s*(?:" + EVENT + "[ -]ID|ID (?:d'|de |di )?" + EVENT + ")\\s?:?\\s*16#\\s*([0-9A-F]{4})\\s*");

  /** In any language, of which some have letters beyond ASCII there. */
  private static final String CODING_BEGINS = "\\s*\\([CK]od[\\w\u00AA-\u024F]+\\s?:";

  /** A word of a coding; a group of these that is repeated is too deep for the executables. */
  private static final String WORD = "[0-9A-F]{4}\\s*";

  private static final Pattern BEGUN_CODING = pattern(CODING_BEGINS + ".*");
  private static final Pattern CODING = pattern(CODING_BEGINS + "\\s*16#\\s*(" + WORD.repeat(6) + ")\\)\\s*");

  /** What stands in place of the coding in an entry that STEP 7 has no text for, in the order of the bytes. */
  private static final List<Pattern> PARTS =
      List.of(
          pattern("\\s*P[KC]\\s?:\\s*16#\\s*([0-9A-F]{2})\\s*"),
          pattern("\\s*OB\\s?:\\s*16#\\s*([0-9A-F]{2})\\s*"),
          pattern("\\s*DatID\\s*1\\s*/\\s*2\\s?:\\s*16#\\s*([0-9A-F]{2}\\s*[0-9A-F]{2}\\s*)"),
          pattern(
              "\\s*(?:Supplementary info|Zusatzinfo|Info\\.? suppl\\w*\\.?)\\s*1\\s*/\\s*2\\s*/\\s*3\\s?:"
                  + "\\s*16#\\s*(" + WORD.repeat(3) + ")"));

  private static final Pattern TIME =
      pattern(
          ".*?\\b(\\d{1,2}):(\\d{2}):(\\d{2})[.:,](\\d{3})\\s*([AP]M)?"
              + "\\s+(\\d{1,4})([./-])(\\d{1,2})\\7(\\d{1,4})\\s*");

  private static final String AN_ID = "an event ID such as \"Event ID 16# 4302\"";

  /** Letters that end a line, beside the pair of carriage return and line feed. */
  private static final String ENDS = "\n\r\u000B\f\u001C\u001D\u001E\u2028\u2029";

  /** The one more that ends a line; a string of C cannot have it. */
  private static final char NEXT_LINE = 0x85;

  private static final String BY_YEAR = "YMD";

  /** Letters of the longest line that may say something of an entry; longer ones are too deep for the executables. */
  private static final int LONGEST = 1000;

  private Step7Text() {}

  private static Pattern pattern(String text) {
    return Pattern.compile(text, Pattern.CASE_INSENSITIVE);
  }

  /** The lines of one entry, by their kinds of fact. */
  private static final class Block {
    final int number;
    final String place;
    final Map<Integer, byte[]> parts = new HashMap<>();
    int id = -1;
    byte[] coding;
    Matcher time;
    String timed;

    Block(int number, int line) {
      this.number = number;
      place = "entry " + number + " (line " + line + ")";
    }

    Unusable wrong(String expected, String found) {
      return new Unusable(expected, found).of(place);
    }
  }

  /** Whether an entry begins in the text. */
  static boolean hasEntry(byte[] content) {
    return lines(decoded(content)).stream().anyMatch(line -> BEGIN.matcher(line.plain).matches());
  }

  /**
   * The buffer of a text.
   *
   * @param dates the order of day, month and year, such as {@code DMY}; if it is null, the dates have to tell it
   */
  static Diagnostics read(byte[] content, String dates) {
    var blocks = new ArrayList<Block>();
    List<Line> lines = lines(decoded(content));
    for (int i = 0; i < lines.size(); i++) {
      Matcher begin = BEGIN.matcher(lines.get(i).plain);
      if (begin.matches()) {
        blocks.add(begun(begin, lines.get(i), i + 1));
      } else if (!blocks.isEmpty()) {
        add(blocks.get(blocks.size() - 1), lines.get(i));
      }
    }
    if (blocks.isEmpty()) {
      throw new Unusable(
          "entries such as \"Event 1 of 100: Event ID 16# 4302\" or \"Ereignis 1 von 100: Ereignis-ID 16# 4302\"",
          "none");
    }
    String order = dates == null ? orderOf(blocks) : dates;
    var entries = new ArrayList<Entry>();
    for (Block block : blocks) {
      if (block.id < 0) {
        throw block.wrong(AN_ID, "none");
      }
      entries.add(new Entry(block.number, block.place, block.id, at(block, order), coding(block)));
    }
    return new Diagnostics(entries, 0);
  }

  /** A line, and the same with a space for each kind of it: a text from a forum has no-break ones. */
  private record Line(String text, String plain) {
    static Line of(String text) {
      if (text.length() > LONGEST) {
        return new Line(text, "");
      }
      var plain = new StringBuilder(text);
      for (int i = 0; i < text.length(); i++) {
        char c = text.charAt(i);
        if (c <= ' ' ? c >= '\t' && c <= '\r' || c >= 0x1C : Character.getType(c) == Character.SPACE_SEPARATOR) {
          plain.setCharAt(i, ' ');
        }
      }
      return new Line(text, plain.toString());
    }

    String shown() {
      int from = 0;
      int to = plain.length();
      while (to > 0 && plain.charAt(to - 1) == ' ') {
        to--;
      }
      while (from < to && plain.charAt(from) == ' ') {
        from++;
      }
      return Quoting.inMarks(text.substring(from, to));
    }
  }

  private static List<Line> lines(String text) {
    var lines = new ArrayList<Line>();
    int begin = 0;
    for (int at = 0; at < text.length(); at++) {
      if (text.charAt(at) == NEXT_LINE || ENDS.indexOf(text.charAt(at)) >= 0) {
        lines.add(Line.of(text.substring(begin, at)));
        if (text.startsWith("\r\n", at)) {
          at++;
        }
        begin = at + 1;
      }
    }
    lines.add(Line.of(text.substring(begin)));
    return lines;
  }

  private static String decoded(byte[] content) {
    if (content.length > 1 && (Octets.word(content, 0) == 0xFFFE || Octets.word(content, 0) == 0xFEFF)) {
      var text = new StringBuilder();
      int low = Octets.one(content, 0) == 0xFF ? 0 : 1;
      for (int at = 2; at + 1 < content.length; at += 2) {
        text.append((char) (Octets.one(content, at + low) | Octets.one(content, at + 1 - low) << 8));
      }
      return text.toString();
    }
    int mark = content.length > 2 && Octets.word(content, 0) == 0xEFBB && Octets.one(content, 2) == 0xBF ? 3 : 0;
    // The last letter may be cut off.
    for (int end = content.length; end >= mark && end > content.length - 4; end--) {
      byte[] part = Arrays.copyOfRange(content, mark, end);
      String text = new String(part, StandardCharsets.UTF_8);
      if (Arrays.equals(text.getBytes(StandardCharsets.UTF_8), part)) {
        return text;
      }
    }
    // Any Windows code page: all else that is read is ASCII.
    return new String(content, mark, content.length - mark, StandardCharsets.ISO_8859_1);
  }

  private static Block begun(Matcher begin, Line line, int number) {
    var block = new Block(Integer.parseInt(begin.group(1)), number);
    Matcher id = EVENT_ID.matcher(begin.group(2));
    if (id.matches()) {
      block.id = Integer.parseInt(id.group(1), 16);
    } else if (!begin.group(2).replace(':', ' ').isBlank()) {
      throw block.wrong(AN_ID, line.shown());
    }
    return block;
  }

  private static void add(Block block, Line line) {
    Matcher id = EVENT_ID.matcher(line.plain);
    Matcher time = TIME.matcher(line.plain);
    if (block.id < 0 && id.matches()) {
      block.id = Integer.parseInt(id.group(1), 16);
    } else if (BEGUN_CODING.matcher(line.plain).matches()) {
      Matcher coding = CODING.matcher(line.plain);
      if (!coding.matches()) {
        throw block.wrong("a coding of six words", line.shown());
      }
      block.coding = bytes(coding.group(1));
    } else if (time.matches()) {
      block.time = time;
      block.timed = line.shown();
    } else {
      for (int i = 0; i < PARTS.size(); i++) {
        Matcher part = PARTS.get(i).matcher(line.plain);
        if (part.matches()) {
          block.parts.put(i, bytes(part.group(1)));
        }
      }
    }
  }

  private static byte[] bytes(String digits) {
    return Octets.decoded(digits.getBytes(StandardCharsets.ISO_8859_1));
  }

  private static byte[] coding(Block block) {
    byte[] coding = block.coding;
    if (coding == null && block.parts.size() == PARTS.size()) {
      coding = Arrays.copyOf(new byte[] {(byte) (block.id >> 8), (byte) block.id}, Entry.CODED);
      int at = 2;
      for (int i = 0; i < PARTS.size(); i++) {
        byte[] part = block.parts.get(i);
        System.arraycopy(part, 0, coding, at, part.length);
        at += part.length;
      }
    }
    if (coding != null && Octets.word(coding, 0) != block.id) {
      throw block.wrong(
          "a coding that begins with the event ID 16# " + Octets.hex(block.id, 4),
          "16# " + Octets.hex(Octets.word(coding, 0), 4));
    }
    return coding;
  }

  private static String at(Block block, String order) {
    Matcher time = block.time;
    if (time == null) {
      throw block.wrong("a line that ends like \"05:36:29.972 PM 03/18/2012\"", "none");
    }
    int hour = Integer.parseInt(time.group(1));
    boolean wrong = false;
    if (time.group(5) != null) {
      wrong = hour > 12;
      // 12 AM is midnight, 12 PM is noon.
      hour = hour % 12 + (time.group(5).equalsIgnoreCase("PM") ? 12 : 0);
    }
    int[] date = date(time, order);
    int minute = Integer.parseInt(time.group(2));
    int second = Integer.parseInt(time.group(3));
    int[] parts = {date[0], date[1], date[2], hour, minute, second, Integer.parseInt(time.group(4))};
    if (wrong || !Bcd.exists(parts)) {
      throw block.wrong("a time and a date (" + order + ")", block.timed);
    }
    return Days.spelled(parts);
  }

  /** Year, month and day. */
  private static int[] date(Matcher time, String order) {
    var date = new int[3];
    for (int i = 0; i < 3; i++) {
      String part = time.group(i == 0 ? 6 : 7 + i);
      int number = Integer.parseInt(part);
      int place = BY_YEAR.indexOf(order.charAt(i));
      date[place] = place == 0 && part.length() == 2 ? Bcd.year(number) : number;
    }
    return date;
  }

  /** The one order in which all dates can be read. */
  private static String orderOf(List<Block> blocks) {
    List<Block> timed = blocks.stream().filter(block -> block.time != null).toList();
    if (timed.stream().allMatch(block -> block.time.group(6).length() == 4)) {
      return BY_YEAR;
    }
    if (timed.stream().allMatch(block -> block.time.group(7).equals("."))) {
      return "DMY";
    }
    List<String> possible =
        List.of("DMY", "MDY").stream()
            .filter(order -> timed.stream().allMatch(block -> isPossible(date(block.time, order))))
            .toList();
    if (possible.size() == 1) {
      return possible.get(0);
    }
    throw new Unusable(
        "dates that tell the order of day and month, unlike " + timed.get(0).timed,
        (possible.isEmpty() ? "no order that fits all of them" : "several ways to read them")
            + "; name it with --dates");
  }

  private static boolean isPossible(int... date) {
    return date[1] >= 1 && date[1] <= 12 && date[2] >= 1 && date[2] <= 31;
  }
}
