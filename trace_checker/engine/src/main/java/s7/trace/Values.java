package s7.trace;

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
final class Values {
  private Values() {}

  /**
   * A value shaped like {@code template}: a record takes its fields from the JSON object and, where
   * the object has none, from the template; a set takes the elements of an array.
   *
   * @throws IllegalArgumentException if the JSON has another shape
   */
  static Value like(Value template, JsonElement json) {
    if (template instanceof RecordValue record && json.isJsonObject()) {
      return overlay(record, json.getAsJsonObject());
    }
    if (template instanceof SetEnumValue && json.isJsonArray()) {
      return new SetEnumValue(elements(json.getAsJsonArray()), false);
    }
    Value value = of(json);
    if (value.getClass() != template.getClass()) {
      throw new IllegalArgumentException("expected a value like " + template + ", not " + json);
    }
    return value;
  }

  private static RecordValue overlay(RecordValue template, JsonObject json) {
    Value[] values = template.values.clone();
    for (int i = 0; i < values.length; i++) {
      JsonElement given = json.get(template.names[i].toString());
      if (given != null) {
        values[i] = like(values[i], given);
      }
    }
    return new RecordValue(template.names, values, true);
  }

  /** Objects become records, arrays tuples. */
  private static Value of(JsonElement json) {
    if (json.isJsonObject()) {
      var fields = json.getAsJsonObject().entrySet();
      var names = new UniqueString[fields.size()];
      var values = new Value[fields.size()];
      int i = 0;
      for (var field : fields) {
        names[i] = UniqueString.uniqueStringOf(field.getKey());
        values[i++] = of(field.getValue());
      }
      return new RecordValue(names, values, false);
    }
    if (json.isJsonArray()) {
      return new TupleValue(elements(json.getAsJsonArray()));
    }
    JsonPrimitive primitive = json.getAsJsonPrimitive();
    if (primitive.isBoolean()) {
      return primitive.getAsBoolean() ? BoolValue.ValTrue : BoolValue.ValFalse;
    }
    if (primitive.isNumber()) {
      return IntValue.gen(primitive.getAsInt());
    }
    return new StringValue(primitive.getAsString());
  }

  private static Value[] elements(JsonArray json) {
    var values = new Value[json.size()];
    for (int i = 0; i < values.length; i++) {
      values[i] = of(json.get(i));
    }
    return values;
  }

  /** Records become objects, sets and tuples arrays; a set's elements come in TLC's order. */
  static JsonElement toJson(Value value) {
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
