package tla.spec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import tla.Tiny;
import tlc2.value.impl.IntValue;

class GuardsTest {
  private static Specification spec;

  @BeforeAll
  static void load() {
    spec = Tiny.load();
  }

  private static List<Guards.Failure> failures(String action, int argument) {
    return List.copyOf(spec.failures(action, record -> null, spec.initialState("Init"), IntValue.gen(argument)));
  }

  @Test
  @DisplayName("an action that is enabled has no failure")
  void enabled() {
    assertEquals(List.of(), failures("Guarded", 0));
  }

  @Test
  @DisplayName("the first false conjunct is found, with the values of its operands, inside operators")
  void conjunct() {
    var failure = failures("Guarded", 5).get(0);
    assertEquals("count + n < 3", failure.conjunct());
    assertEquals("count + n = 5", failure.values());
    assertEquals(Set.of("TINY-04"), failure.requirements());
    assertTrue(failure.place().startsWith("Explain:"));
  }

  @Test
  @DisplayName("every alternative of an action has its own, and a choice from nothing says so")
  void alternatives() {
    var failures = failures("Either", 5);
    assertEquals(
        List.of("Guarded(5)", "Either", "Either"),
        failures.stream().map(Guards.Failure::action).toList());
    assertEquals("m \\in {}", failures.get(1).conjunct());
    assertEquals("the set is empty", failures.get(1).values());
    assertEquals("count > n", failures.get(2).conjunct());
  }
}
