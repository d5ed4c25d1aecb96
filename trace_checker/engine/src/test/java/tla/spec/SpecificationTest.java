package tla.spec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import tla.Tiny;
import tla.json.Values;
import tlc2.tool.StateVec;
import tlc2.tool.TLCState;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.Value;

class SpecificationTest {
  private static Specification spec;

  @BeforeAll
  static void load() {
    spec = Tiny.load();
  }

  private static Value header(String json) {
    return Values.like(spec.value("NoHeader", spec.initialState()), Tiny.text(json));
  }

  private static Value noEvent() {
    return spec.value("NoEvent", spec.initialState());
  }

  private static StateVec begin(String header) {
    return spec.successors("Begin", spec.initialState(), header(header));
  }

  @Test
  @DisplayName("distinct states have distinct fingerprints")
  void fingerprints() {
    StateVec states = begin("{'choices': [1, 2, 3, 4, 5]}");
    var seen = new HashSet<Long>();
    for (int i = 0; i < states.size(); i++) {
      seen.add(states.elementAt(i).fingerPrint());
    }
    assertEquals(6, seen.size());
  }

  @Test
  @DisplayName("equal states have equal fingerprints, however they were reached")
  void equalStates() {
    TLCState two = begin("{'first': 2}").elementAt(0);
    TLCState doubled = spec.successors("Silent", two, noEvent()).elementAt(0);
    assertEquals(begin("{'first': 4}").elementAt(0).fingerPrint(), doubled.fingerPrint());
  }

  @Test
  @DisplayName("an action that is not enabled has no successors")
  void notEnabled() {
    assertEquals(0, spec.successors("Silent", begin("{'first': 8}").elementAt(0), noEvent()).size());
  }

  @Test
  @DisplayName("a state predicate depends on the state and on its argument")
  void predicates() {
    assertFalse(spec.holds("Stirs", spec.initialState(), noEvent()));
    assertTrue(spec.holds("Stirs", begin("{'first': 1}").elementAt(0), noEvent()));
    assertTrue(spec.holds("Arrived", spec.initialState(), noEvent()));
    Value later = Values.like(noEvent(), Tiny.text("{'at': 1}"));
    assertFalse(spec.holds("Arrived", spec.initialState(), later));
  }

  @Test
  @DisplayName("a constant is evaluated")
  void constants() {
    assertEquals(IntValue.gen(99), spec.value("Full", spec.initialState()));
  }

  @Test
  @DisplayName("an operator that is missing is named")
  void missingOperator() {
    var error = assertThrows(
        IllegalStateException.class, () -> spec.value("Missing", spec.initialState()));
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
