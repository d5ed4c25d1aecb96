package s7.trace;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.List;
import java.util.function.Consumer;

import s7.log.Fields;
import tlc2.value.impl.RecordValue;

/** Judges logs, one after another: event by event, until an event decides or the log ends. */
final class Judging {
  private static final String LINE = "line";

  /** What an accepted log is. */
  static final String EXPLAINED = "the specification explains every event";

  /** The line of an error in the header. */
  private static final int NONE = 0;

  private final Contract spec;
  private final Consumer<Fields> out;
  private final ArrayDeque<Fields> followed = new ArrayDeque<>();
  private Explanation explanation;

  /** Why the last log was rejected; null if it was not. */
  private Explanation.Refusal refusal;

  private int follow;
  private int events;
  private int loose;
  private int wide;

  /** Two threads look at it, see {@link Engine}. */
  private volatile boolean decided;

  /**
   * @param out gets the answer to each log, as soon as it is decided
   */
  Judging(Contract spec, Consumer<Fields> out) {
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
    refusal = null;
    events = 0;
    loose = NONE;
    wide = NONE;
    followed.clear();
    follow = last;
  }

  /** Takes the header. */
  void header(Fields header) {
    spec.forgetAsked();
    attempt(NONE, () -> explanation = new Explanation(spec, header));
  }

  /** Takes an event; does nothing once the log is decided. */
  void observe(int line, RecordValue event) {
    if (!decided) {
      attempt(line, () -> explain(line, event));
    }
  }

  /** Why the last log was rejected; null if it was not. */
  Explanation.Refusal refusal() {
    return refusal;
  }

  /** Whether the answer is out. */
  boolean decided() {
    return decided;
  }

  /** The log goes no further, since it cannot be read; does nothing if it is decided. */
  void unusable(Fields reason) {
    if (!decided) {
      var answer = new Fields();
      answer.put("unusable", reason);
      answer("unusable", answer);
    }
  }

  /** The log has ended. */
  void finish() {
    if (!decided) {
      boolean crowded = loose != NONE && !explanation.partial();
      String message = crowded ? "too many explanations" : EXPLAINED;
      String end = crowded ? "; choose readings in the header" : "";
      answer("accepted", new Fields().put("message", message + loosened() + end));
    }
  }

  /** From which line on less is told apart. */
  private String loosened() {
    if (loose != NONE) {
      return "; from line " + loose + " on only definite facts are checked";
    }
    return wide == NONE
        ? ""
        : "; too many explanations: from line " + wide + " on start events that wait are not all told apart";
  }

  /** Does a part of the judging; where it fails the log ends without verdict. */
  private void attempt(int line, Runnable part) {
    try {
      part.run();
    } catch (NotCovered | StackOverflowError e) {
      var error = new Fields();
      if (line != NONE) {
        error.put(LINE, line);
      }
      error.put("message", NotCovered.said(e));
      answer("error", error);
    }
  }

  private void explain(int line, RecordValue event) {
    refusal = explanation.observe(event);
    loose = loose == NONE && explanation.loosened() ? line : loose;
    wide = wide == NONE && explanation.widened() ? line : wide;
    if (refusal != null) {
      answer("rejected", refusal.asJson().put(LINE, line).put("message", refusal.message() + loosened()));
      return;
    }
    events++;
    if (follow > 0) {
      remember(line);
    }
  }

  private void remember(int line) {
    var step = new Fields();
    step.put(LINE, line);
    step.put("situation", explanation.situation());
    followed.addLast(step);
    if (followed.size() > follow) {
      followed.removeFirst();
    }
  }

  private static List<Integer> numbers(BitSet bits) {
    return bits.stream().boxed().toList();
  }

  private void answer(String verdict, Fields answer) {
    answer.put("verdict", verdict);
    answer.put("events", events);
    if (loose != NONE) {
      answer.put("loose", loose);
      answer.put("partial", explanation.partial());
    }
    if (wide != NONE) {
      answer.put("wide", wide);
    }
    if (!followed.isEmpty()) {
      answer.put("steps", followed.clone());
    }
    if (explanation != null) {
      answer.put("largest", explanation.largest());
      answer.put("followed", explanation.steps());
      answer.put("outcomes", numbers(explanation.outcomes()));
      answer.put("open", numbers(explanation.openOutcomes()));
      answer.put("classes", explanation.classes());
      if (explanation.asked() != null) {
        answer.put("asked", explanation.asked());
      }
    }
    decided = true;
    explanation = null;
    out.accept(answer);
  }
}
