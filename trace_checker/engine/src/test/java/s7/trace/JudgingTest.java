package s7.trace;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import s7.log.Fields;
import tla.Tiny;
import tla.eval.State;
import tla.spec.Guards;
import tla.spec.Interpreter;
import tla.spec.Specification;
import tlc2.value.impl.Value;

class JudgingTest {
  private static final JsonObject ACCEPTED_ONE = Tiny.json(
          "{'message': 'the specification explains every event', 'verdict': 'accepted', 'events': 1}");

  private static Contract spec;

  private final List<JsonObject> answers = new ArrayList<>();
  private final Judging judging = new Judging(spec, answer -> answers.add(Tiny.json(answer)));

  @BeforeAll
  static void load() {
    spec = new Contract(Tiny.load(), true);
  }

  /** The answers so far, without what they cost and what they tell of decisions. */
  private List<JsonObject> answers() {
    for (JsonObject answer : answers) {
      List.of("largest", "followed", "outcomes", "open", "classes").forEach(answer::remove);
    }
    return answers;
  }

  private void begin(int first) {
    begin("{'first':" + first + "}", 0);
  }

  private void begin(String header, int follow) {
    judging.begin(follow);
    judging.header(Tiny.text(header));
  }

  private void read(int line, int value) {
    judging.observe(line, spec.event(Tiny.text("{'event':'read','value':" + value + "}")));
  }

  @Test
  @DisplayName("a log without events is accepted")
  void empty() {
    begin(0);
    judging.finish();
    assertEquals("accepted 0", answers().get(0).get("verdict").getAsString() + " " + answers().get(0).get("events"));
  }

  @Test
  @DisplayName("logs follow each other, each with its own state and count")
  void severalLogs() {
    for (int value : new int[] {10, 20}) {
      begin(value);
      read(2, value);
      judging.finish();
    }
    assertEquals(List.of(ACCEPTED_ONE, ACCEPTED_ONE), answers());
  }

  @Test
  @DisplayName("a rejection comes at once, with its line, and nothing else comes for this log")
  void rejection() {
    begin(10);
    read(2, 10);
    assertFalse(judging.decided());
    read(3, 11);
    assertTrue(judging.decided());
    var rejected =
        Tiny.json(
            "{'line': 3, 'late': false, 'expected': [{'event': 'read', 'value': 10, 'text': 'read'}],"
                + " 'requirements': ['TINY-01', 'TINY-read'],"
                + " 'message': 'no behaviour of the specification explains this line',"
                + " 'verdict': 'rejected', 'events': 1}");
    assertEquals(List.of(rejected), answers());
    var candidate =
        new Guards.Failure("Observe", "count = e.value", "count = 10, e.value = 11", "Explain:37", Set.of("TINY-03"));
    assertEquals(Set.of(candidate), judging.refusal().candidates());
    assertEquals("[{\"count\":10}]", judging.refusal().situations().toString());
    read(4, 12);
    judging.unusable(new Fields());
    judging.finish();
    assertEquals(List.of(rejected), answers());
  }

  @Test
  @DisplayName("the log after a rejected one is judged")
  void afterRejection() {
    begin(10);
    read(2, 11);
    judging.finish();
    begin(20);
    read(2, 20);
    judging.finish();
    assertEquals("rejected", answers().get(0).get("verdict").getAsString());
    assertEquals(List.of(ACCEPTED_ONE), answers().subList(1, answers.size()));
  }

  @Test
  @DisplayName("a log that cannot be read further ends with the reason, and the events before it count")
  void unusable() {
    begin(10);
    read(2, 10);
    judging.unusable(Tiny.text("{'line': 3}"));
    judging.finish();
    assertEquals(List.of(Tiny.json("{'unusable': {'line': 3}, 'verdict': 'unusable', 'events': 1}")), answers());
  }

  @Test
  @DisplayName("an event that the specification does not have is an error with its line")
  void foreignEvent() {
    begin(10);
    read(2, 10);
    judging.observe(3, spec.event(Tiny.text("{'event':'hold'}")));
    read(4, 10);
    judging.finish();
    begin(20);
    read(2, 20);
    judging.finish();
    assertEquals(2, answers().size());
    assertEquals("error", answers.get(0).get("verdict").getAsString());
    assertEquals(3, answers.get(0).get("line").getAsInt());
    assertEquals(1, answers.get(0).get("events").getAsInt());
    assertTrue(answers.get(0).get("message").getAsString().contains("hold"));
    assertEquals(ACCEPTED_ONE, answers.get(1));
  }

  @Test
  @DisplayName("an answer tells the outcomes of decisions on the way, and the decisions can be asked for")
  void decisions() {
    begin(10);
    read(2, 10);
    read(3, 11);
    var told = new TreeSet<String>();
    for (JsonElement outcome : answers.get(0).getAsJsonArray("outcomes")) {
      var decision = spec.decisions().get(outcome.getAsInt() / 2);
      told.add((decision.text().isEmpty() ? decision.definition() : decision.text()) + outcome.getAsInt() % 2);
    }
    assertTrue(told.containsAll(List.of("Begin0", "Observe0", "count = e.value0")), told.toString());
    assertEquals(new JsonArray(), answers.get(0).getAsJsonArray("open"));
  }

  @Test
  @DisplayName("a log that is followed is answered with its last situations")
  void followed() {
    begin("{'first':5}", 2);
    read(2, 5);
    read(3, 10);
    read(4, 10);
    judging.finish();
    assertEquals(
        Tiny.json("{'steps': [{'line': 3, 'situation': {'count': 10}}, {'line': 4, 'situation': {'count': 10}}]}")
            .get("steps"),
        answers().get(0).get("steps"));
  }

  @Test
  @DisplayName("a header that the specification cannot judge is an error without a line")
  void foreignHeader() {
    begin("{'foreign':['AMB-99']}", 0);
    read(2, 0);
    judging.finish();
    assertEquals(1, answers().size());
    assertEquals("error", answers.get(0).get("verdict").getAsString());
    assertFalse(answers.get(0).has("line"));
    assertTrue(answers.get(0).get("message").getAsString().contains("AMB-99"));
  }

  @Test
  @DisplayName("an answer says what the log cost: the most states at a time, and the steps")
  void cost() {
    begin("{'choices':[10,20]}", 0);
    read(2, 20);
    judging.finish();
    assertEquals(3, answers.get(0).get("largest").getAsInt());
    assertTrue(answers.get(0).get("followed").getAsInt() >= 3);
  }

  @Test
  @DisplayName("an evaluation for which the stack is too small ends the log with advice, not with \"null\"")
  void deep() {
    Interpreter bottomless =
        new Interpreter() {
          @Override
          public boolean compares() {
            return true;
          }

          @Override
          public List<State> initial(String name, List<State> found) {
            return found;
          }

          @Override
          public List<State> successors(String name, List<State> found, State state, Value... arguments) {
            throw new StackOverflowError();
          }

          @Override
          public Value value(String name, Value found, State state, Value... arguments) {
            return found;
          }
        };
    var deep = new Contract(new Specification(Tiny.modules().parsed(), Set.of(), bottomless));
    new Judging(deep, answer -> answers.add(Tiny.json(answer))).header(Tiny.text("{'first':1}"));
    assertEquals("error", answers().get(0).get("verdict").getAsString());
    String said = answers().get(0).get("message").getAsString();
    assertTrue(said.startsWith("the specification goes too deep here for the engine's stack: "), said);
  }
}
