package s7.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import tla.Tiny;

class ExplanationTest {
  private static Contract spec;

  @BeforeAll
  static void load() {
    spec = new Contract(Tiny.load());
  }

  private static Explanation begin(String header) {
    return new Explanation(spec, Tiny.text(header));
  }

  private static Explanation.Refusal observe(Explanation explanation, String event) {
    return explanation.observe(spec.event(Tiny.text(event)));
  }

  @Test
  @DisplayName("the header may leave several states, each of them once")
  void header() {
    assertEquals(1, begin("{}").size());
    assertEquals(3, begin("{'first': 5, 'choices': [5, 6, 7]}").size());
  }

  @Test
  @DisplayName("an event leaves the states that explain it")
  void narrowing() {
    var explanation = begin("{'choices': [10, 20]}");
    assertNull(observe(explanation, "{'event': 'read', 'value': 20}"));
    assertEquals(1, explanation.size());
  }

  @Test
  @DisplayName("states that have become equal are counted once")
  void merging() {
    var explanation = begin("{'choices': [10, 20]}");
    assertNull(observe(explanation, "{'event': 'set', 'value': 3}"));
    assertEquals(1, explanation.size());
  }

  @Test
  @DisplayName("silent steps are taken, any number of them, before an event")
  void silentClosure() {
    for (int value : new int[] {1, 2, 4, 8}) {
      assertNull(observe(begin("{'first': 1}"), "{'event': 'read', 'value': " + value + "}"));
    }
    for (int value : new int[] {3, 16}) {
      assertNotNull(observe(begin("{'first': 1}"), "{'event': 'read', 'value': " + value + "}"));
    }
  }

  @Test
  @DisplayName("time elapses to the event, step by step")
  void elapsing() {
    var explanation = begin("{}");
    assertNull(observe(explanation, "{'event': 'set', 'at': 500, 'value': 9}"));
    assertNull(observe(explanation, "{'event': 'read', 'at': 500, 'value': 9}"));
    assertNull(observe(explanation, "{'event': 'read', 'at': 501, 'value': 9}"));
  }

  @Test
  @DisplayName("a state that goes on alone takes as many steps as it needs, in constant memory")
  void manySteps() {
    var explanation = begin("{'first': 9}");
    assertNull(observe(explanation, "{'event': 'read', 'at': 3000000, 'value': 9}"));
  }

  @Test
  @DisplayName("a state that goes round in circles never arrives")
  void circle() {
    var refusal = observe(begin("{'first': 98}"), "{'event': 'read', 'at': 100000, 'value': 98}");
    assertTrue(refusal.late());
  }

  @Test
  @DisplayName("a refusal has the events that each state allows and the requirements; the states stay")
  void refusal() {
    var explanation = begin("{'first': 10, 'choices': [20]}");
    var refusal = observe(explanation, "{'event': 'read', 'value': 30}");
    assertFalse(refusal.late());
    assertEquals(
        List.of(
            Tiny.json("{'event': 'read', 'value': 10, 'text': 'read'}"),
            Tiny.json("{'event': 'read', 'value': 20, 'text': 'read'}")),
        Tiny.json(refusal.asJson()).getAsJsonArray("expected").asList());
    assertEquals(Set.of("TINY-01"), refusal.requirements());
    assertEquals(2, explanation.size());
  }

  @Test
  @DisplayName("the requirements depend on the lines before the refused one")
  void past() {
    var explanation = begin("{'first': 10}");
    assertNull(observe(explanation, "{'event': 'set', 'value': 3}"));
    var refusal = observe(explanation, "{'event': 'read', 'value': 4}");
    assertEquals(Set.of("TINY-01", "TINY-set"), refusal.requirements());
  }

  @Test
  @DisplayName("of the lines before, the latest are kept and of older ones the last of a kind")
  void longPast() {
    var explanation = begin("{'first': 10}");
    assertNull(observe(explanation, "{'event': 'any', 'value': 1}"));
    for (int i = 0; i <= 2 * Past.LATEST; i++) {
      assertNull(observe(explanation, "{'event': 'set', 'value': 30}"));
    }
    var refusal = observe(explanation, "{'event': 'read', 'value': 4}");
    assertEquals(Set.of("TINY-01", "TINY-any", "TINY-set"), refusal.requirements());
  }

  @Test
  @DisplayName("an event that no time can elapse to comes too late")
  void tooLate() {
    var refusal = observe(begin("{'first': 99}"), "{'event': 'read', 'at': 1, 'value': 99}");
    assertTrue(refusal.late());
    assertEquals(List.of(Tiny.json("{'event': 'set', 'value': 0, 'text': 'set'}")), Tiny.json(refusal.asJson()).getAsJsonArray("expected").asList());
    assertEquals(Set.of("TINY-02"), refusal.requirements());
  }

  @Test
  @DisplayName("as many states as the limit are followed, one more is too many")
  void limit() {
    var most = "{'event': 'any', 'value': " + Explanation.MOST_STATES + "}";
    var explanation = begin("{}");
    assertNull(observe(explanation, most));
    assertEquals(Explanation.MOST_STATES, explanation.size());
    var more = "{'event': 'any', 'value': " + (Explanation.MOST_STATES + 1) + "}";
    var error = assertThrows(NotCovered.class, () -> observe(begin("{}"), more));
    assertTrue(error.getMessage().contains(String.valueOf(Explanation.MOST_STATES)));
  }

  @Test
  @DisplayName("many states at each line are too much work at last, few are not")
  void work() {
    var few = begin("{}");
    for (int line = 0; line < 800; line++) {
      assertNull(observe(few, "{'event': 'any', 'value': 30}"));
    }
    assertEquals(30, few.size());
    var many = begin("{}");
    var error = assertThrows(NotCovered.class, () -> {
      for (int line = 0; line < 800; line++) {
        assertNull(observe(many, "{'event': 'any', 'value': 100}"));
      }
    });
    assertTrue(error.getMessage().contains("steps"));
  }

  @Test
  @DisplayName("questions about what may come are no work for the log")
  void questions() {
    var explanation = begin("{}");
    assertNull(observe(explanation, "{'event': 'any', 'value': 100}"));
    for (int question = 0; question < 800; question++) {
      explanation.closure(explanation.states(), spec.noEvent());
      explanation.arrivals(spec.event(Tiny.text("{'event': 'read', 'at': 1, 'value': 1}")));
    }
    assertNull(observe(explanation, "{'event': 'any', 'value': 100}"));
  }

  @Test
  @DisplayName("an event that the specification does not have is named")
  void foreignEvent() {
    var error = assertThrows(NotCovered.class, () -> observe(begin("{}"), "{'event': 'hold'}"));
    assertTrue(error.getMessage().contains("hold"));
  }

  @Test
  @DisplayName("a reading that the specification does not have is named")
  void foreignHeader() {
    var error = assertThrows(NotCovered.class, () -> begin("{'foreign': ['AMB-99']}"));
    assertTrue(error.getMessage().contains("AMB-99"));
  }
}
