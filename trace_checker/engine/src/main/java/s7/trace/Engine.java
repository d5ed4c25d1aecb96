package s7.trace;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.Function;

import s7.importing.Importing;
import s7.log.Fields;
import s7.log.LogReader;
import s7.log.Onward;
import s7.log.ProfileFile;
import s7.log.Unusable;
import tla.spec.Decisions;
import tla.spec.Specification;
import tlc2.value.impl.RecordValue;

/**
 * The trace checker's engine: reads logs from standard input and prints a verdict for each as soon as it is decided.
 *
 * <p>A message is a JSON object on a line, whose first field is its kind:
 *
 * <ul>
 *   <li>{@code {"message":"begin"}} begins a log. {@code "chosen":{"cpu":...,"profile":...,"readings":{...}}} takes the
 *       place of its header's own choices. With {@code "follow":N} the answer has the situations after the last N events.
 *       {@code "file"} is what a header needs that names a file as its profile ({@link #file}); with {@code
 *       "outcomes":true} the answer has {@code outcomes}.
 *   <li>{@code {"message":"bytes","count":N}} is in front of N bytes of the log, in UTF-8 without a byte order mark.
 *   <li>{@code {"message":"verdict"}} asks whether the log is decided. If it is not, the answer is {@code
 *       {"verdict":"open"}}; if it is, its verdict has been printed. What lines behind tell of one is not waited for.
 *   <li>{@code {"message":"finish"}} ends it; with {@code "broken":true} amid a line, which does not count.
 *   <li>{@code {"message":"texts","clauses":[{"id":...,"text":...}...],"events":{"4568":...}}} has the words of the rules
 *       and of event IDs, from which sentences are made; the answer is empty.
 *   <li>{@code {"message":"rejected","line":TEXT}} asks why the last log was rejected, at that line: the {@code refusal}
 *       has what {@link WhyNot} tells of it.
 *   <li>{@code {"message":"read","count":N}} asks, between two logs, how the log is read of which N bytes follow,
 *       with {@code file} and {@code chosen} as above: the answer has its {@code header} and its {@code events}, and what is
 *       {@code unusable}; with {@code "others":{"rules":[...],"asked":[...]}} also the headers beside it; {@code readings} asks what a
 *       report says of the verdicts under these ({@link OtherHeaders} has both); with {@code "spelled":true} events are
 *       lines in one spelling, without their time.
 *   <li>{@code {"message":"program","count":N}} has a program of the kit checked, of which N bytes follow: the answer
 *       has its {@code object} with one spelling for each value, or what is {@code unusable}. {@code offer} does so with
 *       what a CPU offers to programs; of {@code program of} the bytes are a log, with {@code file}, and the object has
 *       the header, duration, events from outside and bodies of its program.
 *   <li>{@code {"message":"simulate","count":N}} runs a program of the kit, of which N bytes follow; with {@code header},
 *       {@code readings}, {@code latency} and {@code seed} as {@link Simulation} has them. The answer has the {@code object} with its
 *       {@code log}, or with {@code "all":true} the tree of {@link Outcomes}; or what is {@code unusable}, or an {@code
 *       error} where the specification cannot be evaluated.
 *   <li>{@code {"message":"import","count":N}} has a log made of a source, and other messages ask about sources, of which
 *       N bytes follow: {@link Importing} has them. The answer has the {@code object} or what is {@code unusable}.
 *   <li>{@code {"message":"alternatives"}} asks, between two logs, which words a log may have.
 *   <li>{@code {"message":"open","session":NAME,"header":TEXT}} and the messages of {@link Sessions}
 *       ask, between two logs, about logs that grow.
 *   <li>{@code {"message":"decisions"}} asks, between two logs, for the decisions of the specification.
 * </ul>
 *
 * <p>Output: {@code {"engine":"ready",...}} once, then for each log an object whose {@code verdict} is "accepted",
 * "rejected", "unusable" or "error", and for each question an object with its answer. The {@code asked} of a log are the
 * open questions whose letter its verdict depends on; without it all of them may be. The {@code outcomes} of a log are
 * those of the decisions on the way to the last line that was explained: 2k where decision k was true, has another value
 * or was taken, 2k + 1 where it was false. They are those of all explanations of the log; {@code open} has those of some
 * of them. What is {@code unusable} has {@code line}, {@code field}, {@code expected} and {@code found}.
 */
public final class Engine {
  private static final String MESSAGE = "message";
  private static final String COUNT = "count";

  private final Contract spec;
  private final Supplier<Specification> another;
  private final Consumer<String> out;
  private final Clauses clauses = new Clauses();
  private final WhyNot why = new WhyNot(clauses);
  private final Sessions sessions;
  private final Judging withoutOutcomes;

  /** For logs whose outcomes are asked for; null before the first one. */
  private Contract telling;

  private Judging withOutcomes;

  /** What judges the log. */
  private Judging judging;

  /** Judges events, perhaps while the next lines are read. */
  private final Handover ahead;

  private Input input;
  private LogReader reader;
  private Onward onward;

  /** Whether a line of the log could not be read. */
  private boolean unusable;

  /**
   * @param specification gives the parsed specification, before its first evaluation, each time
   * @param ahead gets what is to be judged
   * @param out gets each answer, a line
   */
  public Engine(Supplier<Specification> specification, Handover ahead, Consumer<String> out) {
    this(new Contract(specification.get()), specification, ahead, out);
  }

  Engine(Contract spec, Supplier<Specification> another, Handover ahead, Consumer<String> out) {
    this.spec = spec;
    this.another = another;
    this.ahead = ahead;
    this.out = out;
    sessions = new Sessions(spec, why);
    withoutOutcomes = new Judging(spec, this::print);
    judging = withoutOutcomes;
  }

  private Contract telling() {
    if (telling == null) {
      telling = new Contract(another.get(), true);
      withOutcomes = new Judging(telling, this::print);
    }
    return telling;
  }

  /** Answers messages until they end. */
  public void serve(InputStream in) throws IOException {
    input = new Input(in);
    for (Fields message = input.next(); message != null; message = input.next()) {
      take(message.text(MESSAGE), message);
    }
    ahead.settle();
  }

  private void take(String kind, Fields message) throws IOException {
    if (!"bytes".equals(kind)) {
      ahead.settle();
    }
    switch (kind) {
      case "begin" -> begin(message);
      case "bytes" -> {
        input.pass(message.number(COUNT), (bytes, from, to) -> attempt(() -> reader.take(bytes, from, to)));
        ahead.flush();
      }
      case "verdict" -> {
        onward.end();
        ahead.settle();
        if (!judging.decided()) {
          print(new Fields().put("verdict", "open"));
        }
      }
      case "finish" -> {
        if (!message.has("broken")) {
          attempt(reader::end);
        }
        onward.end();
        ahead.settle();
        judging.finish();
      }
      case "texts" -> {
        clauses.take(message);
        print(new Fields());
      }
      case "rejected" -> {
        byte[] line = message.text("line").getBytes(StandardCharsets.UTF_8);
        print(new Fields().put("refusal", why.told(judging.refusal(), line)));
      }
      case "readings" -> print(new Fields().put("parts", OtherHeaders.told(message, clauses)));
      case "read" -> print(read(message));
      case "program" -> print(object(message, spec.format()::program));
      case "program of" -> print(object(message, log -> spec.format().programOf(log, file(message))));
      case "simulate" -> print(object(message, program -> simulated(new Simulation(spec, program, message), message)));
      case "offer" -> print(object(message, spec.format()::offer));
      case "kind", "import", "entries", "mode", "ring", "slots", "ring events", "state" ->
          print(object(message, source -> Importing.answer(kind, message, source, spec.format(), file(message))));
      case "alternatives" -> print(new Fields().put("alternatives", spec.alternatives()));
      case "decisions" -> print(new Fields().put("decisions", telling().decisions().stream().map(Engine::json).toList()));
      default -> print(sessions.answer(kind, message));
    }
  }

  private static Fields simulated(Simulation simulation, Fields message) {
    return message.has("all") ? Outcomes.of(simulation) : simulation.run();
  }

  private static Fields json(Decisions.Decision decision) {
    return new Fields()
        .put("kind", decision.kind().name())
        .put("module", decision.module())
        .put("definition", decision.definition())
        .put("line", decision.line())
        .put("column", decision.column())
        .put("text", decision.text())
        .put("requirements", decision.requirements());
  }

  private void begin(Fields message) {
    Contract judges = message.has("outcomes") ? telling() : spec;
    judging = judges == spec ? withoutOutcomes : withOutcomes;
    judging.begin(message.has("follow") ? message.number("follow") : 0);
    unusable = false;
    onward =
        new Onward(
            new LogReader.Taker() {
              @Override
              public void header(Fields header) {
                judging.header(chosen(header, message));
              }

              @Override
              public void event(int line, Fields event) {
                RecordValue read = judges.event(event);
                ahead.add(() -> judging.observe(line, read));
              }
            });
    reader = new LogReader(spec.format(), onward, file(message));
  }

  /** Reads a part of the log, unless it is decided: the rest means nothing then. */
  private void attempt(Runnable part) {
    Unusable wrong = unusable || judging.decided() ? null : refused(part);
    if (wrong != null) {
      unusable = true;
      onward.end();
      ahead.settle();
      judging.unusable(wrong.asJson());
    }
  }

  /** How a log is read. */
  private Fields read(Fields message) throws IOException {
    var answer = new Fields();
    var events = new ArrayList<Fields>();
    var onward =
        new Onward(
            new LogReader.Taker() {
              @Override
              public void header(Fields given) {
                answer.put("header", chosen(given, message));
                if (message.has("others")) {
                  Fields header = answer.object("header");
                  answer.put("others", OtherHeaders.of(spec.alternatives(), header, message.object("others"), clauses));
                }
              }

              @Override
              public void event(int line, Fields event) {
                events.add(message.has("spelled") ? spelled(event) : event.put("line", line));
              }
            });
    var reading = new LogReader(spec.format(), onward, file(message));
    Unusable[] first = {null};
    input.pass(
        message.number(COUNT),
        (bytes, from, to) -> {
          if (first[0] == null) {
            first[0] = refused(() -> reading.take(bytes, from, to));
          }
        });
    Unusable wrong = first[0] == null ? refused(reading::end) : first[0];
    onward.end();
    answer.put("events", events);
    if (wrong != null) {
      answer.put("unusable", wrong.asJson());
    }
    return answer;
  }

  /** An event without its time, as a log spells it. */
  private static Fields spelled(Fields event) {
    return Spelled.line(Fields.of(event.without("at", "up").toString().getBytes(StandardCharsets.UTF_8)));
  }

  /** A text as an object that a reader makes of it. */
  private Fields object(Fields message, Function<byte[], Fields> reader) throws IOException {
    var text = new ByteArrayOutputStream();
    input.pass(message.number(COUNT), (bytes, from, to) -> text.write(bytes, from, to - from));
    var answer = new Fields();
    try {
      Unusable wrong = refused(() -> answer.put("object", reader.apply(text.toByteArray())));
      return wrong == null ? answer : answer.put("unusable", wrong.asJson());
    } catch (NotCovered | StackOverflowError e) {
      return answer.put("error", NotCovered.said(e));
    }
  }

  private static Unusable refused(Runnable part) {
    try {
      part.run();
      return null;
    } catch (Unusable wrong) {
      return wrong;
    }
  }

  /**
   * What a message tells of the file that a header may name as its profile: {@code {"text":...}}, its bytes as the first
   * 256 characters of Unicode, or why it is {@code missing}; null if nothing.
   */
  static ProfileFile file(Fields message) {
    if (!message.has("file")) {
      return null;
    }
    Fields file = message.object("file");
    return file.has("text")
        ? new ProfileFile(file.text("text").getBytes(StandardCharsets.ISO_8859_1), null)
        : new ProfileFile(null, file.text("missing"));
  }

  /** A header with the choices of a message. */
  private Fields chosen(Fields header, Fields message) {
    return message.has("chosen")
        ? spec.format().chosen(header, message.object("chosen"))
        : header;
  }

  private void print(Fields answer) {
    out.accept(answer.toString());
  }
}
