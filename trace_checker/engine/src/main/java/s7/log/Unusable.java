package s7.log;

/**
 * A line that is not of the format.
 *
 * <p>Texts are for people, free of control characters. The line is the physical one, from 1; the field is a path such
 * as {@code info.time}, or null where the whole line is meant. What is imported has in place of a line the
 * place in its source, such as {@code entry 3}.
 */
public final class Unusable extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final String expected;
  private final String found;
  private String field;
  private int line;
  private String place;

  /** Texts for people. */
  public Unusable(String expected, String found) {
    this(expected, found, null);
  }

  public Unusable(String expected, String found, String field) {
    super(expected, null, false, false);
    this.expected = expected;
    this.found = found;
    this.field = field;
  }

  /** The same, in a field of this name. */
  public Unusable inside(String name) {
    String shown = Quoting.printable(name);
    field = field == null ? shown : shown + "." + field;
    return this;
  }

  Unusable at(int number) {
    line = number;
    return this;
  }

  /** The same, at a place of a source of which a log is made. */
  public Unusable of(String where) {
    place = where;
    line = 0;
    return this;
  }

  /** The error as an object: {@code expected}, {@code found}; {@code field}, {@code line}, {@code place} if known. */
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
    if (place != null) {
      json.put("place", place);
    }
    return json;
  }
}
