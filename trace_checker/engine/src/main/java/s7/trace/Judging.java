package s7.trace;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.function.Consumer;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import tla.json.Json;
import tlc2.value.impl.RecordValue;

/** Judges logs, one after another: event by event, until an event decides or the log ends. */
final class Judging {
  private static final String LINE = "line";

  /** The line of an error in the header. */
  private static final int NONE = 0;

  private final Contract spec;
  private final Consumer<JsonObject> out;
  private final ArrayDeque<JsonObject> followed = new ArrayDeque<>();
  private Explanation explanation;
  private int follow;
  private int events;
  private int loose;
  private int wide;

  /** Two threads look at it, see {@link Engine}. */
  private volatile boolean decided;

  /**
   * @param out gets the answer to each log, as soon as it is decided
   */
  Judging(Contract spec, Consumer<JsonObject> out) {
    this.spec = spec;
    this.out = out;
  }

  /**
   * Begins a log, before its header has come.
   *
   * @param last so many situations at the end of the log are to be in the answer
   */
  void begin(int last) {
    decided = false;
    explanation = null;
    events = 0;
    loose = NONE;
    wide = NONE;
    followed.clear();
    follow = last;
  }

  /** Takes the header. */
  void header(Json header) {
    spec.forgetAsked();
    attempt(NONE, () -> explanation = new Explanation(spec, header));
  }

  /** Takes an event; does nothing once the log is decided. */
  void observe(int line, RecordValue event) {
    if (!decided) {
      attempt(line, () -> explain(line, event));
    }
  }

  /** Whether the answer is out. */
  boolean decided() {
    return decided;
  }

  /** The log goes no further, since it cannot be read; does nothing if it is decided. */
  void unusable(JsonObject reason) {
    if (!decided) {
      var answer = new JsonObject();
      answer.add("unusable", reason);
      answer("unusable", answer);
    }
  }

  /** The log has ended. */
  void finish() {
    if (!decided) {
      answer("accepted", new JsonObject());
    }
  }

  /** Does a part of the judging; where it fails the log ends without verdict. */
  private void attempt(int line, Runnable part) {
    try {
      part.run();
    } catch (NotCovered | StackOverflowError e) {
      var error = new JsonObject();
      if (line != NONE) {
        error.addProperty(LINE, line);
      }
      error.addProperty("message", String.valueOf(e.getMessage()));
      answer("error", error);
    }
  }

  private void explain(int line, RecordValue event) {
    Explanation.Refusal refusal = explanation.observe(event);
    loose = loose == NONE && explanation.loosened() ? line : loose;
    wide = wide == NONE && explanation.widened() ? line : wide;
    if (refusal != null) {
      JsonObject rejected = refusal.asJson();
      rejected.addProperty(LINE, line);
      answer("rejected", rejected);
      return;
    }
    events++;
    if (follow > 0) {
      remember(line);
    }
  }

  private void remember(int line) {
    var step = new JsonObject();
    step.addProperty(LINE, line);
    step.add("situation", explanation.situation());
    followed.addLast(step);
    if (followed.size() > follow) {
      followed.removeFirst();
    }
  }

  private static JsonArray numbers(BitSet bits) {
    var numbers = new JsonArray();
    bits.stream().forEach(numbers::add);
    return numbers;
  }

  private void answer(String verdict, JsonObject answer) {
    answer.addProperty("verdict", verdict);
    answer.addProperty("events", events);
    if (loose != NONE) {
      answer.addProperty("loose", loose);
    }
    if (wide != NONE) {
      answer.addProperty("wide", wide);
    }
    if (!followed.isEmpty()) {
      var steps = new JsonArray();
      followed.forEach(steps::add);
      answer.add("steps", steps);
    }
    if (explanation != null) {
      answer.addProperty("largest", explanation.largest());
      answer.addProperty("followed", explanation.steps());
      answer.add("outcomes", numbers(explanation.outcomes()));
      answer.add("open", numbers(explanation.openOutcomes()));
      answer.add("classes", new Gson().toJsonTree(explanation.classes()));
      if (explanation.asked() != null) {
        answer.add("asked", new Gson().toJsonTree(explanation.asked()));
      }
    }
    decided = true;
    explanation = null;
    out.accept(answer);
  }
}
