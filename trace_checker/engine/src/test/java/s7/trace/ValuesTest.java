package s7.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.google.gson.JsonParser;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import s7.log.Fields;
import tla.Tiny;
import tlc2.value.impl.BoolValue;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.SetEnumValue;
import tlc2.value.impl.StringValue;
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;
import util.UniqueString;

class ValuesTest {
  private static final Value MOMENT =
      record("min", IntValue.gen(-1), "ms", IntValue.gen(0));
  private static final Value TEMPLATE =
      record(
          "at", MOMENT,
          "name", new StringValue("none"),
          "obs", new SetEnumValue(new Value[] {IntValue.gen(1)}, true),
          "on", BoolValue.ValFalse,
          "pair", new TupleValue(new Value[] {IntValue.gen(1), IntValue.gen(2)}));

  private static Value record(Object... fields) {
    var names = new UniqueString[fields.length / 2];
    var values = new Value[names.length];
    for (int i = 0; i < names.length; i++) {
      names[i] = UniqueString.uniqueStringOf((String) fields[2 * i]);
      values[i] = (Value) fields[2 * i + 1];
    }
    // Templates come from the specification, normalized. The order of names hangs on what ran before.
    var record = new RecordValue(names, values, false);
    record.normalize();
    return record;
  }

  private static Value like(Value template, String json) {
    return Values.like(template, Tiny.text("{'value': " + json + "}").get("value"));
  }

  private static void assertJson(String expected, Value value) {
    var printed = Tiny.json(new Fields().put("value", Values.toJson(value)));
    assertEquals(JsonParser.parseString(expected.replace('\'', '"')), printed.get("value"));
  }

  @Test
  @DisplayName("an object without fields gives the template")
  void defaults() {
    assertEquals(TEMPLATE, like(TEMPLATE, "{}"));
    assertJson(
        "{'at': {'min': -1, 'ms': 0}, 'name': 'none', 'obs': [1], 'on': false, 'pair': [1, 2]}",
        TEMPLATE);
  }

  @Test
  @DisplayName("given fields take the place of the template's, in inner records too")
  void overlay() {
    Value value = like(TEMPLATE, "{'at': {'min': 7}, 'on': true, 'name': 'x'}");
    assertJson(
        "{'at': {'min': 7, 'ms': 0}, 'name': 'x', 'obs': [1], 'on': true, 'pair': [1, 2]}", value);
  }

  @Test
  @DisplayName("fields that the template does not have are dropped")
  void unknownField() {
    assertEquals(TEMPLATE, like(TEMPLATE, "{'x_note': 1}"));
  }

  @Test
  @DisplayName("the template itself stays as it was")
  void templateIsNotChanged() {
    like(TEMPLATE, "{'name': 'x', 'obs': [2, 3]}");
    assertEquals(like(TEMPLATE, "{}"), like(TEMPLATE, "{'name': 'none', 'obs': [1]}"));
  }

  @Test
  @DisplayName("a set has no order and no element twice")
  void sets() {
    Value set = like(TEMPLATE, "{'obs': [80, 1, 80, 10]}");
    assertEquals(like(TEMPLATE, "{'obs': [1, 10, 80]}"), set);
    assertJson("[1, 10, 80]", ((RecordValue) set).select(new StringValue("obs")));
  }

  @Test
  @DisplayName("arrays inside a set are tuples, objects inside it records")
  void elements() {
    Value empty = new SetEnumValue();
    assertJson("[['AMB-01', 'a']]", like(empty, "[['AMB-01', 'a']]"));
    Value records = like(empty, "[{'ob': 10, 'active': true}]");
    assertJson("[{'active': true, 'ob': 10}]", records);
    assertInstanceOf(RecordValue.class, ((SetEnumValue) records).elems.elementAt(0));
  }

  @Test
  @DisplayName("a tuple keeps its order")
  void tuples() {
    assertJson("[2, 1, 2]", like(new TupleValue(new Value[0]), "[2, 1, 2]"));
  }

  @ParameterizedTest
  @CsvSource({"0", "-1", "2147483647", "-2147483648"})
  @DisplayName("integers of 32 bits are kept")
  void integers(int number) {
    assertEquals(IntValue.gen(number), like(IntValue.gen(5), String.valueOf(number)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{'name': 1}", "{'on': 'yes'}", "{'obs': 1}", "{'obs': {}}", "{'at': 3}", "{'at': []}",
        "{'pair': {'a': 1}}", "{'at': {'ms': '0'}}", "[]", "1"
      })
  @DisplayName("another shape than the template's is refused")
  void wrongShape(String json) {
    assertThrows(IllegalArgumentException.class, () -> like(TEMPLATE, json));
  }
}
