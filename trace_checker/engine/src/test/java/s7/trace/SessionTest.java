package s7.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import tla.Tiny;
import tla.tlc.Modules;
import util.ToolIO;

/** Sessions with the specification itself. */
class SessionTest {
  private static final String HEADER =
      "{'format':'s7-interrupt-log/1','cpu':'S7-300','obs':[1,40],'clock':'1990-01-01T00:01','mode':'RUN'}";
  private static final String INTERRUPT = line("interrupt", 40);

  private static Contract contract;

  private final Sessions sessions = new Sessions(contract, new WhyNot(new Clauses()));

  @BeforeAll
  static void load() {
    ToolIO.out = new PrintStream(OutputStream.nullOutputStream());
    contract = new Contract(new Modules(Path.of("..", "..", "spec"), Contract.MODULE).specification(Contract.TIMES));
  }

  private static String line(String event, int ob) {
    return "{'event':'" + event + "','ob':" + ob + ",'at':'1990-01-01T00:01:00.0'}";
  }

  /** A text as a field of a message. */
  private static String field(String name, String text) {
    return "'" + name + "': " + quoted(text);
  }

  private static String quoted(String text) {
    return "'" + text.replace("'", "\\\'") + "'";
  }

  private JsonObject ask(String message, String fields) {
    return Tiny.json(sessions.answer(message, Tiny.text("{'session': 'a', " + fields + "}")));
  }

  private void open() {
    assertEquals(Tiny.json("{'clock': '1990-01-01T00:01:00.000'}"), ask("open", field("header", HEADER)));
  }

  /** The first and the last time of the start of OB 40 among the lines that are possible. */
  private String start() {
    for (JsonElement line : ask("possible", "'x': 0").getAsJsonObject("possible").getAsJsonArray("lines")) {
      JsonObject json = line.getAsJsonObject();
      if (json.getAsJsonObject("event").equals(Tiny.json("{'event': 'start', 'ob': 40}"))) {
        return json.get("first") + " to " + json.get("last");
      }
    }
    return "not possible";
  }

  @Test
  @DisplayName("what may come depends on the lines, which can be taken back")
  void possible() {
    open();
    assertEquals("not possible", start());
    assertEquals(Tiny.json("{'clock': '1990-01-01T00:01:00.000'}"), ask("feed", field("line", INTERRUPT)));
    assertEquals("0 to 1", start());
    ask("back", "'lines': 0");
    assertEquals("not possible", start());
  }

  @Test
  @DisplayName("a line that is not possible has its reasons, and is not added")
  void refusal() {
    open();
    String start = field("line", line("start", 40));
    assertTrue(ask("judge", start).has("refusal"));
    assertTrue(ask("feed", start).has("refusal"));
    ask("feed", field("line", INTERRUPT));
    assertFalse(ask("judge", start).has("refusal"));
    assertEquals("0 to 1", start());
  }

  @Test
  @DisplayName("what has to come has its time and its requirements")
  void due() {
    open();
    ask("feed", field("line", INTERRUPT));
    JsonObject possible = ask("possible", "'lines': []").getAsJsonObject("possible");
    assertFalse(possible.get("endless").getAsBoolean());
    JsonObject last = possible.getAsJsonArray("times").get(1).getAsJsonObject();
    assertEquals(Tiny.json("{'min': 0, 'ms': 10}"), last.get("up"));
    assertEquals(1, last.getAsJsonArray("due").size());
    assertFalse(last.getAsJsonArray("requirements").isEmpty());
  }

  @Test
  @DisplayName("a line that is asked about comes back with each answer of the CPU")
  void answers() {
    open();
    JsonObject possible =
        ask("possible", "'lines': [" + quoted("{'event':'DIS_AIRT','at':'1990-01-01T00:01:00.0','ret':null}") + "]").getAsJsonObject("possible");
    assertEquals(1, possible.getAsJsonArray("lines").size());
    JsonObject line = possible.getAsJsonArray("lines").get(0).getAsJsonObject();
    assertEquals(Tiny.json("{'event': 'DIS_AIRT', 'ret': 'W#16#0001'}"), line.get("event"));
    assertTrue(line.get("last").isJsonNull());
  }

  @Test
  @DisplayName("situations; a header and a line that are not of the format; a session that is not there")
  void others() {
    open();
    assertEquals(1, ask("situations", "'most': 3").getAsJsonArray("situations").size());
    var unusable = ask("open", field("header", HEADER.replace("{", "{'profile':'1890',"))).getAsJsonObject("unusable");
    assertEquals("profile", unusable.get("field").getAsString());
    assertEquals("at", ask("feed", field("line", "{'event':'hold','at':'1990-01-01T00:00'}")).getAsJsonObject("unusable").get("field").getAsString());
    ask("close", "'x': 0");
    assertThrows(IllegalArgumentException.class, () -> ask("possible", "'x': 0"));
  }
}
