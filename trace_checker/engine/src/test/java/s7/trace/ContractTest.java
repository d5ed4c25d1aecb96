package s7.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import s7.log.Fields;
import tla.Tiny;
import tla.spec.Specification;
import tla.tlc.Modules;
import util.ToolIO;

/** The contract beside the specification itself. */
class ContractTest {
  private static final String HEADER =
      "{'cpu': 'S7-300', 'obs': [1, 40], 'clock': {'min': 1, 'ms': 0}, 'mode': 'RUN', 'latency': 10,"
          + " 'records': ['call', 'ob', 'clock', 'mode', 'interrupt', 'load']}";

  private static Specification spec;
  private static Contract contract;

  @BeforeAll
  static void load() {
    ToolIO.out = new PrintStream(OutputStream.nullOutputStream());
    spec = new Modules(Path.of("..", "..", "spec"), Contract.MODULE).specification(Contract.TIMES);
    contract = new Contract(spec);
  }

  /** A line, {@code minutes} after the log began. */
  private static Fields line(String event, int ob, int minutes) {
    return Tiny.text(
        String.format(
            "{'event': '%s', 'ob': %d, 'at': {'min': %d, 'ms': 0}, 'up': {'min': %d, 'ms': 0}}",
            event, ob, 1 + minutes, minutes));
  }

  @ParameterizedTest
  @EnumSource
  @DisplayName("the specification has each operator, with this number of parameters")
  void operator(Contract.Operator operator) {
    assertEquals(operator.arity, spec.arity(operator.tla));
  }

  static Stream<String> fields() {
    return Stream.of(Contract.KIND.stream(), Stream.of(Contract.OB), Stream.of(Contract.OF_TIME)).flatMap(each -> each);
  }

  @ParameterizedTest
  @MethodSource("fields")
  @DisplayName("an event has each field")
  void field(String name) {
    var names = contract.event(Tiny.text("{}")).names;
    assertTrue(Arrays.stream(names).anyMatch(n -> n.equals(name)), () -> Arrays.toString(names));
  }

  @Test
  @DisplayName("a log begins, its lines are observed, and a line that is not possible has its reasons")
  void log() {
    var explanation = new Explanation(contract, Tiny.text(HEADER));
    assertNull(explanation.observe(contract.event(line("interrupt", 40, 0))));
    var refusal = explanation.observe(contract.event(line("start", 41, 0)));
    assertFalse(refusal.late());
    assertNotEquals(0, refusal.expected().size());
    assertNotEquals(0, refusal.requirements().size());
    assertNotEquals(0, refusal.situations().size());
    assertNotEquals(0, refusal.candidates().size());
  }

  @Test
  @DisplayName("a line that comes too late has its reasons")
  void late() {
    var explanation = new Explanation(contract, Tiny.text(HEADER));
    assertNull(explanation.observe(contract.event(line("interrupt", 40, 0))));
    var refusal = explanation.observe(contract.event(line("start", 40, 1)));
    assertTrue(refusal.late());
    assertNotEquals(0, refusal.expected().size());
    assertNotEquals(0, refusal.requirements().size());
  }
}
