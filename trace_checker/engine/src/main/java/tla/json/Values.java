package tla.json;

import java.util.ArrayList;
import java.util.List;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import tlc2.value.impl.BoolValue;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.SetEnumValue;
import tlc2.value.impl.StringValue;
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;
import tlc2.value.impl.ValueVec;
import util.UniqueString;

/** Converts between JSON and the values of TLC. */
public final class Values {
  private Values() {}

  /**
   * The value of a JSON text, shaped like {@code template}: a record takes its fields from the JSON
   * object and, where the object has none, from the template; a set takes the elements of an array.
   *
   * @throws IllegalArgumentException if the JSON has another shape
   */
  public static Value like(Value template, Json json) {
    try {
      return next(template, json);
    } catch (IndexOutOfBoundsException | IllegalArgumentException | ArithmeticException e) {
      throw new IllegalArgumentException("expected a value like " + template + ", not " + json, e);
    }
  }

  private static Value next(Value template, Json json) {
    if (template instanceof RecordValue record) {
      return overlay(record, json);
    }
    if (template instanceof SetEnumValue) {
      return new SetEnumValue(elements(json), false);
    }
    Value value = of(json);
    if (value.getClass() != template.getClass()) {
      throw new IllegalArgumentException();
    }
    return value;
  }

  private static RecordValue overlay(RecordValue template, Json json) {
    Value[] values = template.values.clone();
    json.pass('{');
    while (json.more('}')) {
      int place = json.name(template.names);
      if (place < 0) {
        json.skip();
      } else {
        values[place] = next(values[place], json);
      }
    }
    return new RecordValue(template.names, values, true);
  }

  /** Objects become records, arrays tuples. */
  private static Value of(Json json) {
    return switch (json.peek()) {
      case '{' -> record(json);
      case '[' -> new TupleValue(elements(json));
      case '"' -> new StringValue(json.string());
      case 't', 'f' -> json.truth() ? BoolValue.ValTrue : BoolValue.ValFalse;
      default -> IntValue.gen(json.number());
    };
  }

  private static Value record(Json json) {
    var names = new ArrayList<UniqueString>();
    var values = new ArrayList<Value>();
    json.pass('{');
    while (json.more('}')) {
      names.add(UniqueString.uniqueStringOf(json.name()));
      values.add(of(json));
    }
    return new RecordValue(
        names.toArray(UniqueString[]::new), values.toArray(Value[]::new), false);
  }

  private static Value[] elements(Json json) {
    var values = new ArrayList<Value>();
    json.pass('[');
    while (json.more(']')) {
      values.add(of(json));
    }
    return values.toArray(Value[]::new);
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
  public static JsonElement toJson(Value value) {
    if (value instanceof IntValue number) {
      return new JsonPrimitive(number.val);
    }
    if (value instanceof StringValue string) {
      return new JsonPrimitive(string.val.toString());
    }
    if (value instanceof BoolValue truth) {
      return new JsonPrimitive(truth.val);
    }
    var record = value.toRcd();
    if (value instanceof RecordValue && record instanceof RecordValue fields) {
      var object = new JsonObject();
      for (int i = 0; i < fields.names.length; i++) {
        object.add(fields.names[i].toString(), toJson(fields.values[i]));
      }
      return object;
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
  public static JsonObject given(RecordValue record, RecordValue template) {
    record.normalize();
    template.normalize();
    var object = new JsonObject();
    for (int i = 0; i < record.names.length; i++) {
      if (!record.values[i].equals(template.values[i])) {
        object.add(record.names[i].toString(), toJson(record.values[i]));
      }
    }
    return object;
  }

  private static JsonArray array(ValueVec elements) {
    var array = new JsonArray();
    for (int i = 0; i < elements.size(); i++) {
      array.add(toJson(elements.elementAt(i)));
    }
    return array;
  }

  private static JsonArray array(Value[] elements) {
    var array = new JsonArray();
    for (Value element : elements) {
      array.add(toJson(element));
    }
    return array;
  }
}
