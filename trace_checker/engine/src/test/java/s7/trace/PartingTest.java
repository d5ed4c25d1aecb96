package s7.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.file.Path;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import s7.log.Fields;
import tla.Tiny;
import tla.tlc.Modules;
import util.ToolIO;

/** The search for the shortest log, with the specification itself. */
class PartingTest {
  private static final String HEADER =
      "{'format':'s7-interrupt-log/1','cpu':'%s','obs':[1,40],'clock':'1990-01-01T00:01','mode':'RUN','readings':{%s}}";

  private static Contract contract;

  private final Sessions sessions = new Sessions(contract, new WhyNot(new Clauses()));

  @BeforeAll
  static void load() {
    ToolIO.out = new PrintStream(OutputStream.nullOutputStream());
    contract = new Contract(new Modules(Path.of("..", "..", "spec"), Contract.MODULE).specification(Contract.TIMES));
  }

  private void open(String name, String cpu, String readings) {
    String header = String.format(HEADER, cpu, readings);
    assertTrue(answer("open", name, "header", header).has("clock"));
  }

  private JsonObject answer(String message, String session, String field, String text) {
    var question = new Fields().put("session", session).put(field, text.replace('\'', '"'));
    return Tiny.json(sessions.answer(message, question));
  }

  /** The text of a line that was found, all of which come within the first second. */
  private JsonObject parting(String bounds) {
    Fields answer = sessions.answer("parting", Tiny.text("{'session': 'a', 'from': 'b', " + bounds + "}"));
    return Tiny.json(answer).getAsJsonObject("parting");
  }

  private static String bounds(String only, int deepest, int most) {
    return String.format(
        "'lines': [], 'only': [%s], 'obs': [40], 'deepest': %d, 'most': %d", only, deepest, most);
  }

  @Test
  @DisplayName("a line that one side alone allows is found at once")
  void one() {
    open("a", "S7-300", "'AMB-22':'a'");
    open("b", "S7-300", "'AMB-22':'b'");
    JsonObject found = parting(bounds("'DIS_IRT'", 3, 1000));
    assertEquals(1, found.getAsJsonArray("lines").size());
    assertEquals(0, found.get("complete").getAsInt());
    JsonObject line = found.getAsJsonArray("lines").get(0).getAsJsonObject();
    assertEquals("DIS_IRT", line.get("event").getAsString());
    assertEquals("1990-01-01T00:01:00.000", line.get("at").getAsString());
  }

  @Test
  @DisplayName("the log has no line that it does not need, and each is explained")
  void several() {
    open("a", "S7-300", "'AMB-72':'a'");
    open("b", "S7-300", "'AMB-72':'b'");
    JsonArray lines = parting(bounds("'interrupt', 'DIS_IRT', 'start'", 5, 5000)).getAsJsonArray("lines");
    assertEquals(3, lines.size());
    for (int i = 0; i < lines.size(); i++) {
      String line = lines.get(i).toString();
      assertEquals(i == 2, answer("feed", "b", "line", line).has("refusal"));
      JsonObject fed = answer("feed", "a", "line", line);
      assertTrue(fed.has("clock") && !fed.has("refusal"), fed.toString());
    }
  }

  @Test
  @DisplayName("without a difference all logs within the bounds are looked at")
  void none() {
    open("a", "S7-300", "");
    open("b", "S7-300", "");
    JsonObject all = parting(bounds("'interrupt', 'start', 'end'", 2, 1000));
    assertFalse(all.has("lines"));
    assertEquals(2, all.get("complete").getAsInt());
    assertTrue(all.get("whole").getAsBoolean());
    JsonObject part = parting(bounds("'interrupt', 'start', 'end'", 9, 3));
    assertTrue(part.get("complete").getAsInt() < 9);
  }
}
