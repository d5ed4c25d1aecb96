package tla.spec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.function.IntFunction;

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
    return List.copyOf(spec.failures(action, record -> null, name -> null, spec.initialState("Init"), IntValue.gen(argument)));
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
  @DisplayName("numbers are spelled as those of an operand or a parameter are")
  void spelled() {
    Function<String, IntFunction<String>> numbers =
        name -> Set.of("n", "count", "count + n").contains(name) ? number -> "#" + number : null;
    var all = spec.failures("Either", record -> null, numbers, spec.initialState("Init"), IntValue.gen(5));
    assertEquals(
        List.of("Guarded(#5) count + n = #5", "Either the set is empty", "Either count = #0, n = #5"),
        all.stream().map(one -> one.action() + " " + one.values()).toList());
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
