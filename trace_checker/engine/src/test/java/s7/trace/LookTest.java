package s7.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import s7.log.Fields;
import tla.Tiny;
import tla.tlc.Modules;
import util.ToolIO;

/** What a page asks about a log, with the specification itself. */
class LookTest {
  private static final String AT = "'at':'2026-03-02T08:00:31'}\"";
  private static final String HEADER =
      "\"{'format':'s7-interrupt-log/1','cpu':'S7-400','obs':[1,10,40,80],'clock':'2026-03-02T08:00:30','mode':'RUN'}\"";
  private static final String INTERRUPT = "\"{'event':'interrupt','ob':40," + AT;
  private static final String START = "\"{'event':'start','ob':40," + AT;
  private static final String WRONG = "\"{'event':'start','ob':80," + AT;

  private static Contract contract;

  private final Sessions sessions = new Sessions(contract, new WhyNot(new Clauses()));

  @BeforeAll
  static void load() {
    ToolIO.out = new PrintStream(OutputStream.nullOutputStream());
    contract = new Contract(new Modules(Path.of("..", "..", "spec"), Contract.MODULE).specification(Contract.TIMES));
  }

  @BeforeEach
  void open() {
    ask("open", "\"header\":" + HEADER);
  }

  private Fields ask(String message, String fields) {
    return sessions.answer(message, Fields.of(("{\"session\":\"a\"," + fields + "}").replace("'", "\\\"").getBytes()));
  }

  private static List<String> texts(List<?> lines) {
    return lines.stream().map(line -> ((Fields) line).text("text")).toList();
  }

  @Test
  @DisplayName("lines are added up to the one that is not possible, which is told in words")
  void add() {
    Fields answer = ask("add", "\"lines\":[" + String.join(",", INTERRUPT, START, WRONG, START) + "]");
    assertEquals(2, answer.number("lines"));
    assertEquals("2026-03-02T08:00:31.000", answer.text("clock"));
    Fields refusal = answer.object("refusal");
    int end = refusal.list("wanted").indexOf("end ob=40");
    String before = "{\"at\":\"2026-03-02T08:00:31.000\",\"event\":\"end\",\"ob\":40}";
    assertEquals(List.of(before, WRONG.substring(1, WRONG.length() - 1).replace("'", "\"")), refusal.list("instead").get(end));
    Fields situation = (Fields) refusal.list("situations").get(0);
    assertEquals(List.of("running", "OB 40 (class 16), interrupting OB 1 (class 1)"), situation.list("said").get(1));
  }

  @Test
  @DisplayName("what may come after any line, with the reason of what somebody waits for")
  void look() {
    ask("add", "\"lines\":[" + INTERRUPT + "," + START + "]");
    Fields before = ask("look", "\"after\":1,\"at\":\"2026-03-02T08:00:31.000\"").object("look");
    Fields after = ask("look", "\"after\":2").object("look");
    assertTrue(texts(before.list("possible")).contains("start ob=40"), before.toString());
    assertFalse(texts(before.list("possible")).contains("end ob=40"));
    assertTrue(texts(after.list("possible")).contains("end ob=40"));
    String then = "\"after\":2,\"at\":\"" + after.text("at") + "\"";
    assertTrue(texts(ask("impossible", then).list("impossible")).contains("start ob=40"));
    var ends = ask("look", then + ",\"only\":[\"end\"]").object("look");
    assertEquals(List.of("end ob=40"), texts(ends.list("possible")));
    assertEquals("2026-03-02T08:00:31.000", after.text("at"));
  }

  @Test
  @DisplayName("the answers to a call, why a line may not come, and the situations after several lines")
  void questions() {
    ask("add", "\"lines\":[" + INTERRUPT + "," + START + "]");
    String call = "\"{'event':'SRT_DINT','ob':20,'dtime':0,'sign':1,'ret':null," + AT;
    List<?> lines = ask("lines", "\"after\":2,\"at\":\"2026-03-02T08:00:31\",\"lines\":[" + call + "]").list("lines");
    assertTrue(lines.toString().contains("W#16#8091"), lines.toString());
    assertTrue(ask("why", "\"after\":2,\"line\":" + START).has("refusal"));
    assertFalse(ask("why", "\"after\":1,\"line\":" + START).has("refusal"));
    assertEquals(2, ask("states", "\"after\":1,\"to\":2").list("states").size());
  }

  @Test
  @DisplayName("a session may have other choices than its header")
  void chosen() {
    assertFalse(ask("open", "\"header\":" + HEADER + ",\"chosen\":{\"cpu\":\"S7-300\"}").has("error"));
    assertTrue(ask("open", "\"header\":" + HEADER + ",\"chosen\":{\"cpu\":\"S7-500\"}").has("error"));
  }
}
