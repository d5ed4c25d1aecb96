package s7.trace;

import java.io.File;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

import com.google.gson.Gson;
import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import s7.log.Fields;
import s7.log.LogReader;
import s7.log.ProfileFile;
import s7.log.Unusable;
import tla.json.Json;
import tla.json.JsonLines;
import tla.spec.Specification;
import tlc2.TLCGlobals;
import tlc2.value.impl.RecordValue;
import util.ToolIO;

/**
 * The trace checker's engine: reads logs from standard input and prints a verdict for each as soon as it is decided.
 *
 * <p>A message is a JSON object on a line, whose first field is its kind:
 *
 * <ul>
 *   <li>{@code {"message":"begin"}} begins a log. {@code "chosen":{"cpu":...,"profile":...,"readings":{...}}} takes the
 *       place of its header's own choices. With {@code "follow":N} the answer has the situations after the last N events.
 *       {@code "file"} is what a header needs that names a file as its profile ({@link #file}).
 *   <li>{@code {"message":"bytes","count":N}} is in front of N bytes of the log, in UTF-8 without a byte order mark.
 *   <li>{@code {"message":"verdict"}} asks whether the log is decided. If it is not, the answer is {@code
 *       {"verdict":"open"}}; if it is, its verdict has been printed.
 *   <li>{@code {"message":"finish"}} ends it; with {@code "broken":true} amid a line, which does not count.
 *   <li>{@code {"message":"read","count":N}} asks, between two logs, how the log is read of which N bytes follow,
 *       with {@code file} and {@code chosen} as above: the answer has its {@code header} and its {@code events}, and what is {@code unusable}.
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
  /** Exit code of an engine whose parent has ended. */
  private static final int NOBODY_LEFT = 3;

  /** How the folder begins that the parent makes for an engine. */
  private static final String FOLDER = "s7check-engine-";

  private static final String MESSAGE = "message";

  private final Contract spec;
  private final PrintStream out;
  private final Sessions sessions;
  private final Judging judging;

  /** Judges events while this thread reads the next lines. */
  private final Ahead<Read> ahead;

  private JsonLines lines;
  private LogReader reader;

  /** Whether a line of the log could not be read. */
  private boolean unusable;

  /** An event that was read, and the number of its line. */
  private record Read(int line, RecordValue event) {}

  Engine(Contract spec, PrintStream out) {
    this.spec = spec;
    this.out = out;
    sessions = new Sessions(spec);
    judging = new Judging(spec, this::print);
    ahead = new Ahead<>("judging", read -> judging.observe(read.line, read.event));
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
      JsonObject message = JsonParser.parseString(line.toString()).getAsJsonObject();
      take(message.get(MESSAGE).getAsString(), message);
    }
    ahead.settle();
  }

  private void take(String kind, JsonObject message) throws IOException {
    if (!"bytes".equals(kind)) {
      ahead.settle();
    }
    switch (kind) {
      case "begin" -> begin(message);
      case "bytes" -> {
        lines.pass(count(message), (bytes, from, to) -> attempt(() -> reader.take(bytes, from, to)));
        ahead.flush();
      }
      case "verdict" -> {
        if (!judging.decided()) {
          print(with("verdict", new JsonPrimitive("open")));
        }
      }
      case "finish" -> {
        if (!message.has("broken")) {
          attempt(reader::end);
          ahead.settle();
        }
        judging.finish();
      }
      case "read" -> print(read(message));
      case "alternatives" -> print(with("alternatives", spec.alternatives()));
      case "decisions" -> print(with("decisions", new Gson().toJsonTree(spec.decisions())));
      default -> print(sessions.answer(kind, message));
    }
  }

  private static int count(JsonObject message) {
    return message.get("count").getAsInt();
  }

  private void begin(JsonObject message) {
    judging.begin(message.has("follow") ? message.get("follow").getAsInt() : 0);
    unusable = false;
    reader =
        new LogReader(
            spec.format(),
            new LogReader.Taker() {
              @Override
              public void header(Fields header) {
                judging.header(Json.of(chosen(header, message).toString()));
              }

              @Override
              public void event(int line, Fields event) {
                ahead.add(new Read(line, spec.event(event)));
              }
            },
            file(message));
  }

  /** Reads a part of the log, unless it is decided: the rest means nothing then. */
  private void attempt(Runnable part) {
    Unusable wrong = unusable || judging.decided() ? null : refused(part);
    if (wrong != null) {
      unusable = true;
      ahead.settle();
      judging.unusable(json(wrong.asJson()));
    }
  }

  /** How a log is read. */
  private JsonObject read(JsonObject message) throws IOException {
    var answer = new JsonObject();
    var events = new JsonArray();
    var reading =
        new LogReader(
            spec.format(),
            new LogReader.Taker() {
              @Override
              public void header(Fields header) {
                answer.add("header", json(chosen(header, message)));
              }

              @Override
              public void event(int line, Fields event) {
                JsonObject read = json(event);
                read.addProperty("line", line);
                events.add(read);
              }
            },
            file(message));
    Unusable[] first = {null};
    lines.pass(
        count(message),
        (bytes, from, to) -> {
          if (first[0] == null) {
            first[0] = refused(() -> reading.take(bytes, from, to));
          }
        });
    Unusable wrong = first[0] == null ? refused(reading::end) : first[0];
    answer.add("events", events);
    if (wrong != null) {
      answer.add("unusable", json(wrong.asJson()));
    }
    return answer;
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
  static ProfileFile file(JsonObject message) {
    if (!message.has("file")) {
      return null;
    }
    JsonObject file = message.getAsJsonObject("file");
    return file.has("text")
        ? new ProfileFile(file.get("text").getAsString().getBytes(StandardCharsets.ISO_8859_1), null)
        : new ProfileFile(null, file.get("missing").getAsString());
  }

  /** A header with the choices of a message. */
  private Fields chosen(Fields header, JsonObject message) {
    return message.has("chosen")
        ? spec.format().chosen(header, Fields.of(message.get("chosen").toString().getBytes(StandardCharsets.UTF_8)))
        : header;
  }

  static JsonObject json(Fields fields) {
    return JsonParser.parseString(fields.toString()).getAsJsonObject();
  }

  private static JsonObject with(String name, JsonElement value) {
    var object = new JsonObject();
    object.add(name, value);
    return object;
  }

  private void print(JsonObject json) {
    out.println(json);
    out.flush();
  }
}
