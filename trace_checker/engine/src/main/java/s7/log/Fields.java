package s7.log;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;

/**
 * The fields of a JSON object in their order. Values are strings, Boolean, Long or Integer, {@link JsonNumber} for other
 * numbers, null, List or another Collection, Fields, and in normalised objects {@link Moment}.
 */
public final class Fields {
  private String[] names = new String[8];
  private Object[] values = new Object[8];
  private int size;
  private Fields example;
  private Object noted;

  /** The same fields, on their own. {@code of} is an object that differs from them in dates alone; null for none. */
  Fields likewise(Fields of) {
    var copy = new Fields();
    copy.names = names.clone();
    copy.values = values.clone();
    copy.size = size;
    copy.example = of;
    return copy;
  }

  /** Whether it differs in dates alone from an object for which {@link #note} keeps something. */
  public boolean hasExample() {
    return example != null;
  }

  /** What somebody has noted about an object like this one, which differs in dates alone; null if nobody has. */
  public Object noted() {
    return example == null ? null : example.noted;
  }

  /** Notes something about all objects like this one. */
  public void note(Object what) {
    example.noted = what;
  }

  /**
   * The fields of a JSON text.
   *
   * @throws Unusable for anything but an object
   */
  public static Fields of(byte[] text) {
    return of(text, 0, text.length);
  }

  /** As {@link #of(byte[])}, of a part of the bytes. */
  public static Fields of(byte[] bytes, int from, int to) {
    return new Json().read(bytes, from, to);
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

  /** The value of a field that is a string. */
  public String text(String name) {
    return (String) get(name);
  }

  /** The value of a field that is an integer of 32 bits. */
  public int number(String name) {
    return ((Number) get(name)).intValue();
  }

  /** The value of a field that is an object. */
  public Fields object(String name) {
    return (Fields) get(name);
  }

  /** The value of a field that is an array; no elements if there is no such field. */
  public List<?> list(String name) {
    return has(name) ? (List<?>) get(name) : List.of();
  }

  /** Gives a field its value. */
  public Fields put(String name, Object value) {
    int place = place(name);
    if (place < 0) {
      add(name, value);
    } else {
      values[place] = value;
    }
    return this;
  }

  /** Gives the field at a place its value. */
  void set(int place, Object value) {
    values[place] = value;
  }

  /** Adds a field that is known to be new. */
  public void add(String name, Object value) {
    if (size == names.length) {
      names = Arrays.copyOf(names, 2 * size);
      values = Arrays.copyOf(values, 2 * size);
    }
    names[size] = name;
    values[size++] = value;
  }

  /** Gives it the fields of another object, too. */
  public Fields with(Fields others) {
    for (int i = 0; i < others.size; i++) {
      put(others.names[i], others.values[i]);
    }
    return this;
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
    } else if (value instanceof Collection<?> list) {
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
