package s7.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import tla.Tiny;
import tla.spec.Specification;
import tla.tlc.Modules;
import util.ToolIO;

/** The protocol, with the specification itself. */
class EngineTest {
  private static final String BEGIN = "{'message':'begin'}\n";
  private static final String FINISH = "{'message':'finish'}\n";
  private static final String VERDICT = "{'message':'verdict'}\n";
  private static final String HEADER =
      "{'format':'s7-interrupt-log/1','cpu':'S7-300','obs':[1,40],'clock':'2026-11-21T06:00','mode':'RUN'}\n";
  private static final String RIGHT = "{'event':'DIS_AIRT','at':'2026-11-21T06:00','ret':1}\n";
  private static final String WRONG = "{'event':'DIS_AIRT','at':'2026-11-21T06:00','ret':7}\n";

  private static Contract spec;

  @BeforeAll
  static void load() {
    ToolIO.out = new PrintStream(OutputStream.nullOutputStream());
    spec = new Contract(specification());
  }

  private static Specification specification() {
    return new Modules(Path.of("..", "..", "spec"), Contract.MODULE).specification(Contract.TIMES);
  }

  private static List<JsonObject> serve(String... messages) throws IOException {
    var answers = new ArrayList<JsonObject>();
    byte[] input = String.join("", messages).replace('\'', '"').getBytes(StandardCharsets.UTF_8);
    new Engine(spec, EngineTest::specification, Runnable::run, answer -> answers.add(json(answer)))
        .serve(new ByteArrayInputStream(input));
    return answers;
  }

  private static JsonObject json(String answer) {
    return JsonParser.parseString(answer).getAsJsonObject();
  }

  private static String bytes(String text) {
    return "{'message':'bytes','count':" + text.length() + "}\n" + text;
  }

  private static String said(JsonObject answer) {
    return answer.get("verdict").getAsString() + " " + answer.get("events");
  }

  @Test
  @DisplayName("a log comes in pieces of any length, its last line need not end, and the next log is another one")
  void pieces() throws IOException {
    String log = HEADER + RIGHT + "\n" + WRONG;
    var answers =
        serve(BEGIN, bytes(log.substring(0, 20)), bytes(log.substring(20, 130)), bytes(log.substring(130)), FINISH,
            BEGIN, bytes(HEADER + RIGHT.strip()), FINISH);
    assertEquals(List.of("rejected 1", "accepted 1"), answers.stream().map(EngineTest::said).toList());
    assertEquals(4, answers.get(0).get("line").getAsInt());
  }

  @Test
  @DisplayName("asked for its verdict a log is open, or nothing is said beside its verdict")
  void verdict() throws IOException {
    var answers =
        serve(BEGIN, bytes(HEADER), VERDICT, bytes(RIGHT), VERDICT, bytes(WRONG), VERDICT,
            BEGIN, bytes(HEADER + "{}\n"), VERDICT, FINISH, BEGIN, VERDICT);
    assertEquals(
        List.of("open", "open", "rejected", "unusable", "open"),
        answers.stream().map(answer -> answer.get("verdict").getAsString()).toList());
  }

  @Test
  @DisplayName("what comes before an unusable line is judged first, and what comes behind it means nothing")
  void unusable() throws IOException {
    var answers =
        serve(BEGIN, bytes(HEADER + WRONG + "{}\n"), FINISH, BEGIN, bytes(HEADER + RIGHT + "{}\n" + WRONG), FINISH,
            BEGIN, FINISH);
    assertEquals(List.of("rejected 0", "unusable 1", "unusable 0"), answers.stream().map(EngineTest::said).toList());
    assertEquals(
        Tiny.json("{'line': 3, 'field': 'event', 'expected': 'in every line but the header', 'found': 'none'}"),
        answers.get(1).get("unusable"));
    assertEquals("an empty log", answers.get(2).getAsJsonObject("unusable").get("found").getAsString());
  }

  @Test
  @DisplayName("a log that breaks off amid a line is judged up to there")
  void broken() throws IOException {
    var answers =
        serve(BEGIN, bytes(HEADER + RIGHT + "{'event"), "{'message':'finish','broken':true}\n",
            BEGIN, bytes("{"), "{'message':'finish','broken':true}\n");
    assertEquals(List.of("accepted 1", "accepted 0"), answers.stream().map(EngineTest::said).toList());
  }

  @Test
  @DisplayName("choices take the place of the header's")
  void chosen() throws IOException {
    String chosen = "'chosen':{'cpu':'S7-400','profile':'2006','readings':{'AMB-12':'b'}}";
    String header = HEADER.replace("{", "{'readings':{'AMB-02':'a','AMB-12':'a'},");
    var read = serve("{'message':'read','count':" + header.length() + "," + chosen + "}\n" + header).get(0);
    assertEquals("S7-400", read.getAsJsonObject("header").get("cpu").getAsString());
    assertEquals("2006", read.getAsJsonObject("header").get("profile").getAsString());
    assertEquals("[[\"AMB-02\",\"a\"],[\"AMB-12\",\"b\"]]", read.getAsJsonObject("header").get("readings").toString());
    String foreign = "{'message':'begin','chosen':{'profile':'1890'}}\n";
    assertEquals("error 0", said(serve(foreign, bytes(HEADER), FINISH).get(0)));
  }

  @Test
  @DisplayName("a log can be read without a verdict")
  void read() throws IOException {
    String log = HEADER + WRONG + "{}\n";
    var read = serve("{'message':'read','count':" + log.length() + "}\n" + log).get(0);
    assertEquals(
        Tiny.json("{'event': 'DIS_AIRT', 'at': {'min': 19401480, 'ms': 0}, 'ret': 7, 'step': 60000,"
            + " 'up': {'min': 0, 'ms': 0}, 'line': 2}"),
        read.getAsJsonArray("events").get(0));
    assertEquals(3, read.getAsJsonObject("unusable").get("line").getAsInt());
  }

  @Test
  @DisplayName("questions have their answers between logs")
  void questions() throws IOException {
    var answers = serve("{'message':'alternatives'}\n", BEGIN, bytes(HEADER + WRONG), VERDICT, "{'message':'decisions'}\n");
    assertTrue(answers.get(0).has("alternatives"));
    assertFalse(answers.get(2).getAsJsonArray("decisions").isEmpty());
  }

  @Test
  @DisplayName("outcomes are told of the log for which they are asked, and logs before and after it have their verdict")
  void outcomes() throws IOException {
    String asking = "{'message':'begin','outcomes':true}\n";
    String log = bytes(HEADER + RIGHT) + FINISH;
    var answers = serve(BEGIN, log, asking, log, BEGIN, log);
    assertEquals(3, answers.size());
    answers.forEach(answer -> assertEquals("accepted", answer.get("verdict").getAsString()));
    assertTrue(answers.get(0).getAsJsonArray("outcomes").isEmpty());
    assertFalse(answers.get(1).getAsJsonArray("outcomes").isEmpty());
    assertTrue(answers.get(2).getAsJsonArray("outcomes").isEmpty());
  }
}
