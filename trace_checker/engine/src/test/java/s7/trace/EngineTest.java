package s7.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.TreeSet;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import tla.Tiny;

class EngineTest {
  private static final String FINISH = "{'message': 'finish'}";
  private static final String QUESTION = "{'message': 'alternatives'}";
  private static final JsonObject ACCEPTED_ONE = Tiny.json("{'verdict': 'accepted', 'events': 1}");

  private static Contract spec;

  @BeforeAll
  static void load() {
    spec = new Contract(Tiny.load());
  }

  /** The answers to the lines, without what they cost and what they tell of decisions. */
  private static List<JsonObject> serve(String... lines) throws IOException {
    List<JsonObject> answers = served(lines);
    for (JsonObject answer : answers) {
      List.of("largest", "followed", "outcomes", "open", "classes").forEach(answer::remove);
    }
    return answers;
  }

  /** The answers to the lines, which are written as the Python side writes them, without spaces. */
  private static List<JsonObject> served(String... lines) throws IOException {
    var printed = new ByteArrayOutputStream();
    String input = String.join("\n", lines).replace('\'', '"').replace("\": ", "\":");
    new Engine(spec, new PrintStream(printed, false, StandardCharsets.UTF_8))
        .serve(new ByteArrayInputStream(input.getBytes(StandardCharsets.UTF_8)));
    return printed.toString(StandardCharsets.UTF_8).lines().map(Tiny::json).toList();
  }

  private static String begin(int first) {
    return begin("{'first': " + first + "}");
  }

  private static String begin(String header) {
    return "{'message': 'begin', 'header': " + header + "}";
  }

  private static String read(int line, int value) {
    return "{'line': " + line + ", 'event': 'read', 'value': " + value + "}";
  }

  @Test
  @DisplayName("a log without events is accepted")
  void empty() throws IOException {
    assertEquals(
        List.of(Tiny.json("{'verdict': 'accepted', 'events': 0}")), serve(begin(0), FINISH));
  }

  @Test
  @DisplayName("logs follow each other, each with its own state and count")
  void severalLogs() throws IOException {
    assertEquals(
        List.of(ACCEPTED_ONE, ACCEPTED_ONE),
        serve(begin(10), read(2, 10), FINISH, begin(20), read(2, 20), FINISH));
  }

  @Test
  @DisplayName("a rejection comes at once, with its line, and nothing else comes for this log")
  void rejection() throws IOException {
    var rejected =
        Tiny.json(
            "{'line': 3, 'late': false, 'expected': [{'event': 'read', 'value': 10}],"
                + " 'requirements': ['TINY-01', 'TINY-read'], 'states': 1,"
                + " 'situations': [{'count': 10}],"
                + " 'candidates': [{'action': 'Observe', 'conjunct': 'count = e.value',"
                + " 'values': 'count = 10, e.value = 11', 'place': 'Explain:37', 'requirements': ['TINY-03']}],"
                + " 'verdict': 'rejected', 'events': 1}");
    assertEquals(List.of(rejected), serve(begin(10), read(2, 10), read(3, 11)));
    assertEquals(
        List.of(rejected),
        serve(begin(10), read(2, 10), read(3, 11), read(4, 12), "{'event': 'no'}", FINISH));
  }

  @Test
  @DisplayName("asked for its verdict a log is open, or nothing is said beside its rejection")
  void verdict() throws IOException {
    String asked = "{'message': 'verdict'}";
    var answers = serve(begin(10), asked, read(2, 10), asked, read(3, 11), asked, begin(20), asked);
    JsonObject open = Tiny.json("{'verdict': 'open'}");
    assertEquals(4, answers.size());
    assertEquals(List.of(open, open, open), List.of(answers.get(0), answers.get(1), answers.get(3)));
    assertEquals("rejected", answers.get(2).get("verdict").getAsString());
  }

  @Test
  @DisplayName("the log after a rejected one is judged")
  void afterRejection() throws IOException {
    var answers = serve(begin(10), read(2, 11), read(3, 11), FINISH, begin(20), read(2, 20), FINISH);
    assertEquals("rejected", answers.get(0).get("verdict").getAsString());
    assertEquals(List.of(ACCEPTED_ONE), answers.subList(1, answers.size()));
  }

  @Test
  @DisplayName("an event that the specification does not have is an error with its line")
  void foreignEvent() throws IOException {
    var answers =
        serve(begin(10), read(2, 10), "{'line': 3, 'event': 'hold'}", read(4, 10), FINISH,
            begin(20), read(2, 20), FINISH);
    assertEquals(2, answers.size());
    assertEquals("error", answers.get(0).get("verdict").getAsString());
    assertEquals(3, answers.get(0).get("line").getAsInt());
    assertEquals(1, answers.get(0).get("events").getAsInt());
    assertTrue(answers.get(0).get("message").getAsString().contains("hold"));
    assertEquals(ACCEPTED_ONE, answers.get(1));
  }

  @Test
  @DisplayName("an answer tells the outcomes of decisions on the way, and the decisions can be asked for")
  void decisions() throws IOException {
    var answers = served("{'message': 'decisions'}", begin(10), read(2, 10), read(3, 11));
    var decisions = answers.get(0).getAsJsonArray("decisions");
    var told = new TreeSet<String>();
    for (JsonElement outcome : answers.get(1).getAsJsonArray("outcomes")) {
      JsonObject decision = decisions.get(outcome.getAsInt() / 2).getAsJsonObject();
      String text = decision.get("text").getAsString();
      told.add((text.isEmpty() ? decision.get("definition").getAsString() : text) + outcome.getAsInt() % 2);
    }
    assertTrue(told.containsAll(List.of("Begin0", "Observe0", "count = e.value0")), told.toString());
    assertEquals(new JsonArray(), answers.get(1).getAsJsonArray("open"));
  }

  @Test
  @DisplayName("the values of a header can be asked for between logs, also after a rejected one")
  void question() throws IOException {
    var answers = serve(QUESTION, begin(10), read(2, 11), QUESTION);
    assertEquals(Tiny.json("{'alternatives': [1, 2]}"), answers.get(0));
    assertEquals(answers.get(0), answers.get(2));
  }

  @Test
  @DisplayName("a log that is followed is answered with its last situations")
  void followed() throws IOException {
    var answers = serve("{'message': 'begin', 'header': {'first': 5}, 'follow': 2}", read(2, 5), read(3, 10), read(4, 10), FINISH);
    assertEquals(
        Tiny.json(
            "{'verdict': 'accepted', 'events': 3, 'steps': ["
                + "{'line': 3, 'situation': {'count': 10}}, {'line': 4, 'situation': {'count': 10}}]}"),
        answers.get(0));
  }

  @Test
  @DisplayName("a header that the specification cannot judge is an error without a line")
  void foreignHeader() throws IOException {
    var answers = serve(begin("{'foreign': ['AMB-99']}"), read(2, 0), FINISH);
    assertEquals(1, answers.size());
    assertEquals("error", answers.get(0).get("verdict").getAsString());
    assertEquals(false, answers.get(0).has("line"));
    assertTrue(answers.get(0).get("message").getAsString().contains("AMB-99"));
  }

  @Test
  @DisplayName("an answer says what the log cost: the most states at a time, and the steps")
  void cost() throws IOException {
    var answer = served(begin("{'choices': [10, 20]}"), read(2, 20), FINISH).get(0);
    assertEquals(3, answer.get("largest").getAsInt());
    assertTrue(answer.get("followed").getAsInt() >= 3);
  }
}
