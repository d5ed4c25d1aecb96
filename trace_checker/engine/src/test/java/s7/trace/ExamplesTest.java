package s7.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tla.Tiny;
import tla.json.Json;
import tla.spec.Specification;
import tlc2.value.impl.RecordValue;
import util.ToolIO;

/** Lines that are read by examples. Python's tests compare their verdicts with those of its reader. */
class ExamplesTest {
  private static final String VARYING =
      "{'at': ['date', 0, 3155759999999], 'to': ['date', 0, 3155759999999], 'up': ['number', 0, 5000],"
          + " 'info.time': ['date', 0, 3155759999999]}";

  /** A line, {@code %s} for the values that may differ; at the begin of 1990 plus a second. */
  private static final String LINE =
      "{'event':'start','ob':35,'at':'1990-01-%s','up':%s,'info':{'time':'1990-01-%s'},'x_':%s}";

  private static Contract contract;

  private Examples examples;
  private Clocks clocks;

  @BeforeAll
  static void load() {
    ToolIO.out = new PrintStream(OutputStream.nullOutputStream());
    contract = new Contract(new Specification(Path.of("..", "..", "spec"), Contract.MODULE, Contract.TIMES));
  }

  @BeforeEach
  void example() {
    examples = new Examples(contract.noEvent(), new LineText(Tiny.json(VARYING), "x_"));
    clocks = new Clocks(Tiny.json("{'jumps_logged': true, 'clock': 0, 'up': 0, 'elapsed': 0}"));
    assertNull(read(line("01T00:00:01.000", "1000", "01T00:00:00.999", "7")));
    examples.learn(event(0, 1000, 1000, 0, 999));
  }

  private static Json line(Object... values) {
    return Tiny.text(String.format(LINE, values));
  }

  private RecordValue read(Json line) {
    return examples.read(line, clocks);
  }

  private static RecordValue event(int minutes, int ms, int counter, int minutesOfTime, int msOfTime) {
    return contract.event(
        Tiny.text(
            String.format(
                "{'event':'start','ob':35,'at':{'min':%d,'ms':%d},'up':{'min':0,'ms':%d},"
                    + "'counter':{'min':0,'ms':%d},'info':{'time':{'min':%d,'ms':%d}}}",
                minutes, ms, counter, counter, minutesOfTime, msOfTime)));
  }

  @Test
  @DisplayName("a line that differs in times has the event of the example with its own times")
  void times() {
    assertEquals(event(0, 1000, 1000, 0, 999), read(line("01T00:00:01.000", "1000", "01T00:00:00.999", "8")));
    assertEquals(event(1441, 59_999, 4000, 44639, 0), read(line("02T00:01:59.999", "4000", "31T23:59:00.000", "9")));
  }

  @Test
  @DisplayName("where a line has no time of its own the clock tells how much has elapsed")
  void elapsed() {
    String line = "{'event':'run','at':'1990-01-01T00:00:%s'}";
    String event = "{'event':'run','at':{'min':0,'ms':%d},'up':{'min':0,'ms':%d}}";
    assertNull(read(Tiny.text(String.format(line, "02"))));
    examples.learn(contract.event(Tiny.text(String.format(event, 2000, 2000))));
    clocks.set(Tiny.json("{'clock': 2000, 'up': 0, 'elapsed': 7000}"));
    assertEquals(contract.event(Tiny.text(String.format(event, 5000, 10_000))), read(Tiny.text(String.format(line, "05"))));
    assertNull(read(Tiny.text(String.format(line, "04"))));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "01T00:00:01.00|1000|01T00:00:00.999|7",
        "32T00:00:01.000|1000|01T00:00:00.999|7",
        "01T24:00:01.000|1000|01T00:00:00.999|7",
        "01T00:00:60.000|1000|01T00:00:00.999|7",
        "01T00:00:01.000|5001|01T00:00:00.999|7",
        "01T00:00:01.000|01000|01T00:00:00.999|7",
        "01T00:00:01.000|-1|01T00:00:00.999|7",
        "01T00:00:01.000|1000|01T00:00:00|7",
        "01T00:00:01.000|1000|01T00:00:00.999|[7]",
      })
  @DisplayName("another form, a value out of range, a date that does not exist: the line is Python's")
  void odd(String values) {
    assertNull(read(line((Object[]) values.split("\\|"))));
  }

  @Test
  @DisplayName("clocks do not run backward, and an example stays one after a line that was odd")
  void backward() {
    assertNotNull(read(line("01T00:00:03.000", "3000", "01T00:00:00.000", "7")));
    assertNull(read(line("01T00:00:02.999", "3000", "01T00:00:00.000", "7")));
    assertNull(read(line("01T00:00:03.000", "2999", "01T00:00:00.000", "7")));
    assertNotNull(read(line("01T00:00:03.000", "3000", "01T00:00:00.000", "7")));
  }

  @Test
  @DisplayName("an event that does not have the line's values is no example")
  void other() {
    assertNull(read(line("01T00:00:04", "4000", "01T00:00:00", "7")));
    examples.learn(event(0, 4001, 4000, 0, 0));
    assertNull(read(line("01T00:00:04", "4000", "01T00:00:00", "7")));
  }
}
