package tla.spec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import s7.trace.Values;
import tla.Tiny;
import tla.eval.State;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.Value;

class DecisionsTest {
  private static Specification spec;
  private static List<Decisions.Decision> decisions;

  @BeforeAll
  static void load() {
    spec = Tiny.load();
    decisions = spec.tellDecisions(Set.of("Begin", "Silent", "Observe", "Either")).described();
  }

  private static State begin(int first) {
    State blank = spec.initialState("Init");
    Value header = Values.like(spec.value("NoHeader", blank), Tiny.text("{'first': " + first + "}"));
    return spec.successors("Begin", blank, header).get(0);
  }

  private static Value event(String json) {
    return Values.like(spec.value("NoEvent", spec.initialState("Init")), Tiny.text(json));
  }

  /** Such as {@code count < 8 TRUE}, or the name of an action or definition. */
  private static Set<String> outcomes(State... states) {
    return named(State.commonOutcomes(List.of(states)));
  }

  private static Set<String> named(BitSet outcomes) {
    var names = new TreeSet<String>();
    outcomes.stream()
        .forEach(
            n -> {
              Decisions.Decision one = decisions.get(n / 2);
              names.add((one.text().isEmpty() ? one.definition() : one.text()) + (n % 2 == 0 ? "" : " FALSE"));
            });
    return names;
  }

  @Test
  @DisplayName("decisions have their place, and the requirements that stand there")
  void described() {
    Decisions.Decision observe =
        decisions.stream().filter(one -> one.definition().equals("Observe") && one.text().isEmpty()).findAny().get();
    assertEquals(Decisions.Kind.ACTION, observe.kind());
    assertEquals(Set.of("TINY-03"), observe.requirements());
    Decisions.Decision small =
        decisions.stream().filter(one -> one.definition().equals("Small")).findAny().get();
    assertEquals(Decisions.Kind.DEFINITION, small.kind());
    assertEquals(Set.of("TINY-04"), small.requirements());
    Decisions.Decision guard =
        decisions.stream().filter(one -> one.text().equals("n >= 0")).findAny().get();
    assertEquals(Decisions.Kind.GUARD, guard.kind());
    assertEquals("Guarded", guard.definition());
  }

  @Test
  @DisplayName("a state tells the outcomes on its way, and nothing of steps that were not possible")
  void onTheWay() {
    State two = begin(2);
    assertEquals(Set.of("Begin"), outcomes(two));
    State four = spec.successors("Silent", two, event("{}")).get(0);
    assertEquals(Set.of("Begin", "Silent", "count < 8"), outcomes(four));
    assertTrue(spec.successors("Silent", begin(9), event("{}")).isEmpty());
    State read = spec.successors("Observe", four, event("{'event': 'read', 'value': 4}")).get(0);
    assertTrue(outcomes(read).containsAll(Set.of("Silent", "Observe", "count = e.value")));
  }

  @Test
  @DisplayName("of an action only the branch is taken that leads to the successor; its conditions have been asked")
  void branches() {
    Set<String> found = outcomes(spec.successors("Either", begin(7), IntValue.gen(2)).get(0));
    assertTrue(found.containsAll(Set.of("Either", "n >= 0", "Small(n) FALSE", "double > 1", "count > n")), found.toString());
    assertFalse(found.contains("Guarded"));
    assertFalse(found.contains("Silent"));
  }

  @Test
  @DisplayName("remembered steps tell the same")
  void remembered() {
    for (int i = 0; i < 12; i++) {
      State seven = spec.successors("Silent", begin(7), event("{'at': " + i + "}")).get(0);
      assertEquals(Set.of("Begin", "Silent", "count < 8"), outcomes(seven));
    }
  }

  @Test
  @DisplayName("of two ways the outcomes count that both have")
  void common() {
    State begun = begin(4);
    State doubled = spec.successors("Silent", begin(2), event("{}")).get(0);
    assertEquals(Set.of("Begin"), outcomes(begun, doubled));
    assertEquals(
        Set.of("Begin", "Silent", "count < 8"), named(State.allOutcomes(List.of(begun, doubled))));
    doubled.alsoBy(begun);
    assertEquals(Set.of("Begin"), outcomes(doubled));
  }
}
