package s7.trace;

import java.io.EOFException;
import java.io.File;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.function.Supplier;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import tla.json.Json;
import tla.json.JsonLines;
import tla.spec.Specification;
import tlc2.TLCGlobals;
import tlc2.value.impl.RecordValue;
import util.ToolIO;

/**
 * The trace checker's engine: reads normalised logs from standard input, one JSON object a line,
 * and prints a verdict for each log as soon as it is decided.
 *
 * <p>The first field of a line is its kind:
 *
 * <ul>
 *   <li>{@code {"message":"begin","header":HEADER}} begins a log. With {@code "follow":N} the answer
 *       has the situations after the last N events.
 *   <li>{@code {"message":"verdict"}} asks whether the log is decided. If it is not, the answer is {@code
 *       {"verdict":"open"}}; if it is, its verdict has been printed.
 *   <li>{@code {"message":"finish"}} ends it.
 *   <li>{@code {"message":"alternatives"}} asks, between two logs, which values a header may have.
 *   <li>{@code {"message":"open","session":NAME,"header":HEADER}} and the messages of {@link Sessions}
 *       ask, between two logs, about logs that grow.
 *   <li>{@code {"message":"decisions"}} asks, between two logs, for the decisions of the specification.
 *   <li>An object with another first field is an event of the log.
 *   <li>{@code {"message":"raw","clocks":CLOCKS,"varying":FIELDS,"own":"x_"}} says that lines follow as the log has
 *       them. {@code {"message":"lines","first":N,"count":K}} is in front of K of them. Of a line that it cannot
 *       read ({@link Examples}) the engine asks {@code {"unread":N,"clocks":CLOCKS}}. The answer, between any two
 *       messages, is {@code {"message":"read","clocks":CLOCKS}} with the event in the next line, or {@code
 *       {"message":"unreadable"}}, and then the log ends before the line. {@code {"message":"clocks"}} ends the
 *       lines as the log has them; the answer has the CLOCKS.
 * </ul>
 *
 * <p>Output: {@code {"engine":"ready",...}} once, then for each log an object whose {@code verdict} is
 * "accepted", "rejected" or "error", and for each question an object with its answer. The {@code
 * asked} of a log are the open questions whose letter its verdict depends on; without it all of them may be. The {@code
 * outcomes} of a log are those of the decisions on the way to the last line that was explained: 2k where
 * decision k was true, has another value or was taken, 2k + 1 where it was false. They are those of all
 * explanations of the log; {@code open} has those of some of them.
 */
public final class Engine {
  /** Exit code of an engine whose parent has ended. */
  private static final int NOBODY_LEFT = 3;

  /** How the folder begins that the parent makes for an engine. */
  private static final String FOLDER = "s7check-engine-";

  private static final String MESSAGE = "message";
  private static final String CLOCKS = "clocks";

  private final Contract spec;
  private final PrintStream out;

  private Explanation explanation;
  private int events;
  /** Both threads look at it, see {@link #judging}. */
  private volatile boolean decided;

  private final Sessions sessions;
  private boolean unreadable;
  private final ArrayDeque<JsonObject> followed = new ArrayDeque<>();
  private int follow;
  private JsonElement loose;
  private JsonElement wide;
  private JsonLines lines;
  private Examples examples;
  private Clocks clocks;

  /** Judges lines while this thread reads the next ones; null before the first line that is read here. */
  private Ahead<Read> judging;

  /** An event that was read, and the number of its line. */
  private record Read(int line, RecordValue event) {}

  Engine(Contract spec, PrintStream out) {
    this.spec = spec;
    this.out = out;
    sessions = new Sessions(spec);
  }

  /**
   * @param args the folder of the specification, and the file in which it is kept when it has been parsed
   */
  public static void main(String[] args) throws IOException {
    if (args.length < 1 || args.length > 2) {
      System.err.println("usage: Engine FOLDER-OF-THE-SPECIFICATION [FILE]");
      System.exit(2);
    }
    // However it ends: the parent, which removes the folder too, may have been ended with it.
    Runtime.getRuntime().addShutdownHook(new Thread(() -> removeFolder(new File("").getAbsoluteFile())));
    endWithParent();
    // Standard output belongs to the protocol; TLC's own messages go elsewhere.
    var out = new PrintStream(new FileOutputStream(FileDescriptor.out), false, "UTF-8");
    System.setOut(System.err);
    ToolIO.out = System.err;
    ToolIO.setMode(ToolIO.TOOL);
    Path kept = args.length < 2 ? null : Path.of(args[1]);
    var spec = new Specification(Path.of(args[0]), Contract.MODULE, Contract.TIMES, kept);
    var engine = new Engine(new Contract(spec), out);
    var ready = new JsonObject();
    ready.addProperty("engine", "ready");
    ready.addProperty("tlc", jarOfTlc());
    engine.print(ready);
    spec.keep();
    engine.serve(new FileInputStream(FileDescriptor.in));
  }

  /** Ends with the parent, since an engine at work on an event does not see its input end. */
  private static void endWithParent() {
    ProcessHandle.current().parent().ifPresent(parent -> parent.onExit().thenRun(() -> System.exit(NOBODY_LEFT)));
  }

  /** Removes the folder of temporary files that the parent would have removed. */
  private static void removeFolder(File folder) {
    File[] files = folder.listFiles();
    if (folder.getName().startsWith(FOLDER) && files != null) {
      for (File file : files) {
        file.delete();
      }
      folder.delete();
    }
  }

  /** The file name of the TLC at hand; its version is not kept at one place in all releases. */
  private static String jarOfTlc() {
    var source = TLCGlobals.class.getProtectionDomain().getCodeSource();
    return Path.of(source.getLocation().getPath()).getFileName().toString();
  }

  void serve(InputStream in) throws IOException {
    lines = new JsonLines(in);
    for (Json line = lines.next(); line != null; line = lines.next()) {
      take(line);
    }
    settle();
  }

  private void take(Json line) throws IOException {
    String message = line.first(MESSAGE);
    if (!"lines".equals(message)) {
      settle();
    }
    if (message == null) {
      // The engine passes over the other lines of a log that is decided.
      if (!decided) {
        judge(() -> number(line), () -> observe(spec.event(line), () -> number(line)));
      }
      return;
    }
    switch (message) {
      case "begin" -> judge(() -> null, () -> begin(object(line)));
      case "alternatives" -> print(alternatives());
      case "decisions" -> print(decisions());
      case "verdict" -> {
        if (!decided) {
          print(with("verdict", new JsonPrimitive("open")));
        }
      }
      case "raw" -> raw(object(line));
      case "lines" -> read(object(line));
      case "clocks" -> print(with(CLOCKS, clocks.json()));
      case "finish" -> {
        if (!decided) {
          answer("accepted", null);
        }
      }
      default -> print(sessions.answer(message, object(line)));
    }
  }

  /** Does a part of the judging; where it fails the log ends without verdict. */
  private void judge(Supplier<JsonElement> line, Runnable part) {
    try {
      part.run();
    } catch (NotCovered | StackOverflowError e) {
      var error = new JsonObject();
      if (line.get() != null) {
        error.add("line", line.get());
      }
      error.addProperty("message", String.valueOf(e.getMessage()));
      answer("error", error);
    }
  }

  private void raw(JsonObject message) {
    clocks = new Clocks(message.getAsJsonObject(CLOCKS));
    if (examples == null) {
      var text = new LineText(message.getAsJsonObject("varying"), message.get("own").getAsString());
      examples = new Examples(spec.noEvent(), text);
      judging = new Ahead<>("judging", this::judge);
    }
  }

  /** Waits until all lines that were read are judged. */
  private void settle() {
    if (judging != null) {
      judging.settle();
    }
  }

  private void judge(Read read) {
    if (!decided) {
      var number = new JsonPrimitive(read.line);
      judge(() -> number, () -> observe(read.event, () -> number));
    }
  }

  /** Reads the next lines, which are as the log has them, and has them observed. */
  private void read(JsonObject message) throws IOException {
    int first = message.get("first").getAsInt();
    int count = message.get("count").getAsInt();
    for (int i = 0; i < count; i++) {
      Json line = next();
      if (decided || unreadable || line.isBlank()) {
        continue;
      }
      RecordValue event = examples.read(line, clocks);
      if (event == null) {
        // A log that is decided asks nothing.
        settle();
        if (decided) {
          continue;
        }
        event = asked(first + i, count - i - 1);
      }
      unreadable = event == null;
      if (!unreadable) {
        judging.add(new Read(first + i, event));
      }
    }
    judging.flush();
  }

  /**
   * Asks for the event of a line. What comes before the answer is put back.
   *
   * @param under the lines that are still to come from the message before
   * @return null if the line cannot be read
   */
  private RecordValue asked(int line, int under) throws IOException {
    var question = with("unread", new JsonPrimitive(line));
    question.add(CLOCKS, clocks.json());
    print(question);
    var passed = new ArrayDeque<Json>();
    int raw = under;
    RecordValue event = null;
    for (boolean answered = false; !answered; ) {
      Json next = next();
      String message = raw-- > 0 ? "" : String.valueOf(next.first(MESSAGE));
      answered = message.equals("read") || message.equals("unreadable");
      if (message.equals("read")) {
        clocks.set(object(next).getAsJsonObject(CLOCKS));
        event = spec.event(next());
        examples.learn(event);
      } else if (!answered) {
        raw = message.equals("lines") ? object(next).get("count").getAsInt() : raw;
        passed.add(next.copy());
      }
    }
    lines.again(passed);
    return event;
  }

  /** The next line, which has to come. */
  private Json next() throws IOException {
    Json next = lines.next();
    if (next == null) {
      throw new EOFException();
    }
    return next;
  }

  private static JsonObject object(Json json) {
    return JsonParser.parseString(json.toString()).getAsJsonObject();
  }

  /** The number of an event's line in the log. */
  private static JsonElement number(Json event) {
    return object(event).get("line");
  }

  private void begin(JsonObject json) {
    decided = false;
    events = 0;
    unreadable = false;
    loose = null;
    wide = null;
    followed.clear();
    follow = json.has("follow") ? json.get("follow").getAsInt() : 0;
    spec.forgetAsked();
    explanation = new Explanation(spec, Json.of(json.get("header").toString()));
  }

  private JsonObject alternatives() {
    var answer = new JsonObject();
    answer.add("alternatives", spec.alternatives());
    return answer;
  }

  private static JsonArray numbers(BitSet bits) {
    var numbers = new JsonArray();
    bits.stream().forEach(numbers::add);
    return numbers;
  }

  private JsonObject decisions() {
    var answer = new JsonObject();
    answer.add("decisions", new Gson().toJsonTree(spec.decisions()));
    return answer;
  }

  private static JsonObject with(String name, JsonElement value) {
    var object = new JsonObject();
    object.add(name, value);
    return object;
  }

  private void remember(JsonElement line) {
    var step = new JsonObject();
    step.add("line", line);
    step.add("situation", explanation.situation());
    followed.addLast(step);
    if (followed.size() > follow) {
      followed.removeFirst();
    }
  }

  private void observe(RecordValue event, Supplier<JsonElement> line) {
    Explanation.Refusal refusal = explanation.observe(event);
    if (loose == null && explanation.loosened()) {
      loose = line.get();
    }
    if (wide == null && explanation.widened()) {
      wide = line.get();
    }
    if (refusal == null) {
      events++;
      if (follow > 0) {
        remember(line.get());
      }
      return;
    }
    JsonObject rejected = refusal.asJson();
    rejected.add("line", line.get());
    answer("rejected", rejected);
  }

  private void answer(String verdict, JsonObject details) {
    JsonObject answer = details == null ? new JsonObject() : details;
    answer.addProperty("verdict", verdict);
    answer.addProperty("events", events);
    if (loose != null) {
      answer.add("loose", loose);
    }
    if (wide != null) {
      answer.add("wide", wide);
    }
    if (explanation != null) {
      answer.addProperty("largest", explanation.largest());
      answer.addProperty("followed", explanation.steps());
    }
    if (!followed.isEmpty()) {
      var steps = new JsonArray();
      followed.forEach(steps::add);
      answer.add("steps", steps);
    }
    if (explanation != null) {
      answer.add("outcomes", numbers(explanation.outcomes()));
      answer.add("open", numbers(explanation.openOutcomes()));
      answer.add("classes", new Gson().toJsonTree(explanation.classes()));
      if (explanation.asked() != null) {
        answer.add("asked", new Gson().toJsonTree(explanation.asked()));
      }
    }
    decided = true;
    explanation = null;
    print(answer);
  }

  private void print(JsonObject json) {
    out.println(json);
    out.flush();
  }
}
