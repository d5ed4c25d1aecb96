package s7.log;

import java.util.Arrays;
import java.util.List;

/**
 * The fields of a JSON object in their order. Values are strings, Boolean, Long or Integer, {@link JsonNumber} for other
 * numbers, null, List, Fields, and in normalised objects {@link Moment}.
 */
public final class Fields {
  private String[] names = new String[8];
  private Object[] values = new Object[8];
  private int size;

  /**
   * The fields of a JSON text.
   *
   * @throws Unusable for anything but an object
   */
  public static Fields of(byte[] text) {
    return Json.read(text);
  }

  /** The number of fields. */
  public int size() {
    return size;
  }

  public String name(int i) {
    return names[i];
  }

  public Object value(int i) {
    return values[i];
  }

  private int place(String name) {
    for (int i = 0; i < size; i++) {
      if (names[i].equals(name)) {
        return i;
      }
    }
    return -1;
  }

  public boolean has(String name) {
    return place(name) >= 0;
  }

  /** The value of a field; null if there is none. */
  public Object get(String name) {
    int place = place(name);
    return place < 0 ? null : values[place];
  }

  /** Gives a field its value. */
  Fields put(String name, Object value) {
    int place = place(name);
    if (place < 0) {
      add(name, value);
    } else {
      values[place] = value;
    }
    return this;
  }

  /** Adds a field that is known to be new. */
  void add(String name, Object value) {
    if (size == names.length) {
      names = Arrays.copyOf(names, 2 * size);
      values = Arrays.copyOf(values, 2 * size);
    }
    names[size] = name;
    values[size++] = value;
  }

  /** The same fields without some. */
  public Fields without(String... others) {
    var rest = new Fields();
    for (int i = 0; i < size; i++) {
      if (!Arrays.asList(others).contains(names[i])) {
        rest.add(names[i], values[i]);
      }
    }
    return rest;
  }

  /** The text, on one line. */
  @Override
  public String toString() {
    var text = new StringBuilder();
    write(text, this);
    return text.toString();
  }

  private static void write(StringBuilder text, Object value) {
    if (value instanceof String string) {
      Quoting.json(text, string);
    } else if (value instanceof Fields object) {
      char before = '{';
      for (int i = 0; i < object.size; i++, before = ',') {
        Quoting.json(text.append(before), object.names[i]);
        write(text.append(':'), object.values[i]);
      }
      text.append(before == '{' ? "{}" : "}");
    } else if (value instanceof List<?> list) {
      char before = '[';
      for (Object each : list) {
        write(text.append(before), each);
        before = ',';
      }
      text.append(before == '[' ? "[]" : "]");
    } else {
      text.append(value);
    }
  }
}
