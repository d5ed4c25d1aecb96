package s7.log;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** JSON objects of one kind, read by a table of what their fields may be. */
final class Table implements Reader {
  /** How the names of an implementer's own fields begin. */
  static final String OWN = "x_";

  private final String what;
  private final Map<String, Entry> entries = new LinkedHashMap<>();
  private final Set<String> required;
  private final String names;

  private record Entry(Reader reader, boolean isRequired) {}

  /** Objects that messages call {@code what}. */
  Table(String what, Map<String, Reader> required, Map<String, Reader> optional) {
    this(what, required, optional, null);
  }

  /**
   * The same.
   *
   * @param names what messages call the fields; null for their list
   */
  Table(String what, Map<String, Reader> required, Map<String, Reader> optional, String names) {
    this.what = what;
    required.forEach((name, reader) -> entries.put(name, new Entry(reader, true)));
    optional.forEach((name, reader) -> entries.put(name, new Entry(reader, false)));
    this.required = required.keySet();
    this.names = names != null ? names : "a field of " + what + " (" + String.join(", ", entries.keySet()) + ")";
  }

  /** Objects with these keys, none required; messages call them {@code names}. */
  static Table mapping(String names, Map<String, Reader> readers) {
    return new Table("map", Map.of(), readers, names);
  }

  /** A table of names and readers in turn. */
  static Map<String, Reader> of(Object... namesAndReaders) {
    var table = new LinkedHashMap<String, Reader>();
    for (int i = 0; i < namesAndReaders.length; i += 2) {
      table.put((String) namesAndReaders[i], (Reader) namesAndReaders[i + 1]);
    }
    return table;
  }

  /** The normalised fields without the implementer's own; the first that is unknown, wrong or missing is refused. */
  @Override
  public Fields read(Object value) {
    if (!(value instanceof Fields raw)) {
      throw new Unusable("an object", Quoting.quote(value));
    }
    var fields = new Fields();
    int missing = required.size();
    for (int i = 0; i < raw.size(); i++) {
      String name = raw.name(i);
      Entry entry = entries.get(name);
      if (entry != null) {
        fields.add(name, readIn(name, entry.reader, raw.value(i)));
        missing -= entry.isRequired ? 1 : 0;
      } else if (!name.startsWith(OWN)) {
        throw new Unusable(names + " or a name that begins with \"" + OWN + "\"", "an unknown field").inside(name);
      }
    }
    for (String name : required) {
      if (missing > 0 && !fields.has(name)) {
        throw new Unusable("in every " + what, "none", name);
      }
    }
    return fields;
  }

  private static Object readIn(String name, Reader reader, Object value) {
    try {
      return reader.read(value);
    } catch (Unusable wrong) {
      throw wrong.inside(name);
    }
  }

  /** A reader of lists whose elements differ. */
  static Reader list(Reader reader) {
    return value -> {
      if (!(value instanceof List<?> list)) {
        throw new Unusable("a list", Quoting.quote(value));
      }
      var elements = new ArrayList<Object>();
      for (Object element : list) {
        Object normalised = reader.read(element);
        if (elements.contains(normalised)) {
          throw new Unusable("a list without repetitions", Quoting.quote(element) + " twice");
        }
        elements.add(normalised);
      }
      return elements;
    };
  }
}
