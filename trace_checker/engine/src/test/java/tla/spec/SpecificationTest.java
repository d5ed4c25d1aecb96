package tla.spec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import s7.trace.Values;
import tla.Tiny;
import tla.eval.State;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.Value;

class SpecificationTest {
  private static Specification spec;

  @BeforeAll
  static void load() {
    spec = Tiny.load();
  }

  private static Value header(String json) {
    return Values.like(spec.value("NoHeader", spec.initialState("Init")), Tiny.text(json));
  }

  private static Value noEvent() {
    return spec.value("NoEvent", spec.initialState("Init"));
  }

  private static List<State> begin(String header) {
    return spec.successors("Begin", spec.initialState("Init"), header(header));
  }

  @Test
  @DisplayName("distinct states have distinct keys")
  void keys() {
    List<State> states = begin("{'choices': [1, 2, 3, 4, 5]}");
    var seen = new HashSet<Long>();
    for (int i = 0; i < states.size(); i++) {
      seen.add(spec.key("Distinct", states.get(i)));
    }
    assertEquals(6, seen.size());
  }

  @Test
  @DisplayName("equal states have equal keys, however they were reached")
  void equalStates() {
    State two = begin("{'first': 2}").get(0);
    State doubled = spec.successors("Silent", two, noEvent()).get(0);
    assertEquals(
        spec.key("Distinct", begin("{'first': 4}").get(0)), spec.key("Distinct", doubled));
  }

  @Test
  @DisplayName("an action that is not enabled has no successors")
  void notEnabled() {
    assertEquals(0, spec.successors("Silent", begin("{'first': 8}").get(0), noEvent()).size());
  }

  @Test
  @DisplayName("a state predicate depends on the state and on its argument")
  void predicates() {
    assertFalse(spec.holds("Stirs", spec.initialState("Init"), noEvent()));
    assertTrue(spec.holds("Stirs", begin("{'first': 1}").get(0), noEvent()));
    assertTrue(spec.holds("Arrived", spec.initialState("Init"), noEvent()));
    Value later = Values.like(noEvent(), Tiny.text("{'at': 1}"));
    assertFalse(spec.holds("Arrived", spec.initialState("Init"), later));
  }

  @Test
  @DisplayName("a constant is evaluated")
  void constants() {
    assertEquals(IntValue.gen(99), spec.value("Full", spec.initialState("Init")));
  }

  @Test
  @DisplayName("an operator that is missing is named")
  void missingOperator() {
    var error = assertThrows(
        IllegalStateException.class, () -> spec.value("Missing", spec.initialState("Init")));
    assertTrue(error.getMessage().contains("Missing"));
  }

  @Test
  @DisplayName("an operator has as many parameters as its definition, a missing one none to tell")
  void arities() {
    assertEquals(0, spec.arity("NoEvent"));
    assertEquals(2, spec.arity("Deciding"));
    assertEquals(-1, spec.arity("Missing"));
  }
}
