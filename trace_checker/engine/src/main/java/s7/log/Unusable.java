package s7.log;

/**
 * A line that is not of the format.
 *
 * <p>Texts are for people, free of control characters. The line is the physical one, from 1; the field is a path such
 * as {@code info.time}, or null where the whole line is meant.
 */
public final class Unusable extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final String expected;
  private final String found;
  private String field;
  private int line;

  Unusable(String expected, String found) {
    this(expected, found, null);
  }

  Unusable(String expected, String found, String field) {
    super(expected, null, false, false);
    this.expected = expected;
    this.found = found;
    this.field = field;
  }

  /** The same, in a field of this name. */
  Unusable inside(String name) {
    String shown = Quoting.printable(name);
    field = field == null ? shown : shown + "." + field;
    return this;
  }

  Unusable at(int number) {
    line = number;
    return this;
  }

  /** The error as an object: {@code expected}, {@code found}, and {@code field} and {@code line} where they are known. */
  public Fields asJson() {
    var json = new Fields();
    json.put("expected", expected);
    json.put("found", found);
    if (field != null) {
      json.put("field", field);
    }
    if (line > 0) {
      json.put("line", line);
    }
    return json;
  }
}
