package s7.trace;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

import s7.log.Fields;
import s7.log.Moment;
import tlc2.value.impl.BoolValue;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.SetEnumValue;
import tlc2.value.impl.StringValue;
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;
import tlc2.value.impl.ValueVec;
import util.UniqueString;

/** Converts between JSON, as {@link Fields} has it, and the values of TLC. */
public final class Values {
  private Values() {}

  /**
   * The value of a JSON value, shaped like {@code template}: a record takes its fields from the JSON
   * object and, where the object has none, from the template; a set takes the elements of an array.
   *
   * @throws IllegalArgumentException if the JSON has another shape
   */
  public static Value like(Value template, Object json) {
    try {
      return next(template, json);
    } catch (IllegalArgumentException | ArithmeticException e) {
      throw new IllegalArgumentException("expected a value like " + template + ", not " + json, e);
    }
  }

  private static Value next(Value template, Object json) {
    if (json instanceof Moment moment) {
      return next(template, moment.asFields());
    }
    if (template instanceof RecordValue record && json instanceof Fields fields) {
      return overlay(record, fields);
    }
    if (template instanceof SetEnumValue && json instanceof Collection<?> list) {
      return new SetEnumValue(elements(list), false);
    }
    Value value = of(json);
    if (value.getClass() != template.getClass()) {
      throw new IllegalArgumentException();
    }
    return value;
  }

  private static RecordValue overlay(RecordValue template, Fields fields) {
    Value[] values = template.values.clone();
    for (int i = 0; i < fields.size(); i++) {
      int place = place(template, fields.name(i));
      if (place >= 0) {
        values[place] = next(values[place], fields.value(i));
      }
    }
    return new RecordValue(template.names, values, true);
  }

  /** Objects become records, arrays tuples. */
  private static Value of(Object json) {
    if (json instanceof Fields fields) {
      return record(fields);
    }
    if (json instanceof Collection<?> list) {
      return new TupleValue(elements(list));
    }
    if (json instanceof String text) {
      return new StringValue(text);
    }
    if (json instanceof Boolean truth) {
      return truth ? BoolValue.ValTrue : BoolValue.ValFalse;
    }
    if (json instanceof Number number) {
      return IntValue.gen(Math.toIntExact(number.longValue()));
    }
    throw new IllegalArgumentException();
  }

  private static Value record(Fields fields) {
    var names = new UniqueString[fields.size()];
    var values = new Value[names.length];
    for (int i = 0; i < names.length; i++) {
      names[i] = UniqueString.uniqueStringOf(fields.name(i));
      values[i] = of(fields.value(i));
    }
    return new RecordValue(names, values, false);
  }

  private static Value[] elements(Collection<?> list) {
    return list.stream().map(Values::of).toArray(Value[]::new);
  }

  /** The string or number in a record's field; an empty string if the record has no field {@code name}. */
  public static Object field(RecordValue record, String name) {
    int place = place(record, name);
    if (place < 0) {
      return "";
    }
    return record.values[place] instanceof StringValue string
        ? string.val.toString()
        : ((IntValue) record.values[place]).val;
  }

  /** The place of a field among the values of a record; -1 if it has none of this name. */
  public static int place(RecordValue record, String name) {
    for (int i = 0; i < record.names.length; i++) {
      if (record.names[i].equals(name)) {
        return i;
      }
    }
    return -1;
  }

  /**
   * Records become objects, sets and tuples arrays; a set's elements come in TLC's order.
   *
   * @throws IllegalArgumentException for any other value
   */
  public static Object toJson(Value value) {
    if (value instanceof IntValue number) {
      return (long) number.val;
    }
    if (value instanceof StringValue string) {
      return string.val.toString();
    }
    if (value instanceof BoolValue truth) {
      return truth.val;
    }
    if (value instanceof RecordValue) {
      return object(value);
    }
    if (value.toSetEnum() instanceof SetEnumValue set) {
      set.normalize();
      return array(set.elems);
    }
    if (value.toTuple() instanceof TupleValue tuple) {
      return array(tuple.elems);
    }
    throw new IllegalArgumentException("no JSON for " + value);
  }

  /** The object for a record. */
  public static Fields object(Value value) {
    var record = (RecordValue) value.toRcd();
    var object = new Fields();
    for (int i = 0; i < record.names.length; i++) {
      object.add(record.names[i].toString(), toJson(record.values[i]));
    }
    return object;
  }

  /** The elements of a finite set, in TLC's order. */
  public static List<Value> elements(Value set) {
    SetEnumValue all = (SetEnumValue) set.toSetEnum();
    all.normalize();
    var elements = new ArrayList<Value>(all.elems.size());
    for (int i = 0; i < all.elems.size(); i++) {
      elements.add(all.elems.elementAt(i));
    }
    return elements;
  }

  /** The fields of {@code record} whose values are not those of {@code template}, a record with the same fields. */
  public static Fields given(RecordValue record, RecordValue template) {
    record.normalize();
    template.normalize();
    var object = new Fields();
    for (int i = 0; i < record.names.length; i++) {
      if (!record.values[i].equals(template.values[i])) {
        object.add(record.names[i].toString(), toJson(record.values[i]));
      }
    }
    return object;
  }

  private static List<Object> array(ValueVec elements) {
    var array = new ArrayList<Object>(elements.size());
    for (int i = 0; i < elements.size(); i++) {
      array.add(toJson(elements.elementAt(i)));
    }
    return array;
  }

  private static List<Object> array(Value... elements) {
    var array = new ArrayList<Object>(elements.length);
    for (Value element : elements) {
      array.add(toJson(element));
    }
    return array;
  }
}
