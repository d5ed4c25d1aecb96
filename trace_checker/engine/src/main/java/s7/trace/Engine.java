package s7.trace;

import java.io.File;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayDeque;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import tla.json.Json;
import tla.json.JsonLines;
import tla.spec.Specification;
import tlc2.TLCGlobals;
import util.ToolIO;

/**
 * The trace checker's engine: reads normalised logs from standard input, one JSON object a line,
 * and prints a verdict for each log as soon as it is decided.
 *
 * <p>The first field of a line says what it is:
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
 *   <li>An object with another first field is an event of the log.
 * </ul>
 *
 * <p>Output: {@code {"engine":"ready",...}} once, then for each log an object whose {@code verdict} is
 * "accepted", "rejected" or "error", and for each question an object with its answer.
 */
public final class Engine {
  /** Exit code of an engine whose parent has ended. */
  private static final int NOBODY_LEFT = 3;

  /** How the folder begins that the parent makes for an engine. */
  private static final String FOLDER = "s7check-engine-";

  private static final String MESSAGE = "message";

  private final Contract spec;
  private final PrintStream out;

  private Explanation explanation;
  private int events;
  private boolean decided;
  private final Sessions sessions;
  private final ArrayDeque<JsonObject> followed = new ArrayDeque<>();
  private int follow;
  private JsonElement loose;

  Engine(Contract spec, PrintStream out) {
    this.spec = spec;
    this.out = out;
    sessions = new Sessions(spec);
  }

  /**
   * @param args the folder of the specification
   */
  public static void main(String[] args) throws IOException {
    if (args.length != 1) {
      System.err.println("usage: Engine FOLDER-OF-THE-SPECIFICATION");
      System.exit(2);
    }
    endWithParent();
    // Standard output belongs to the protocol; TLC's own messages go elsewhere.
    var out = new PrintStream(new FileOutputStream(FileDescriptor.out), false, "UTF-8");
    System.setOut(System.err);
    ToolIO.out = System.err;
    ToolIO.setMode(ToolIO.TOOL);
    var engine = new Engine(new Contract(new Specification(Path.of(args[0]), Contract.MODULE, Contract.TIMES)), out);
    var ready = new JsonObject();
    ready.addProperty("engine", "ready");
    ready.addProperty("tlc", jarOfTlc());
    engine.print(ready);
    engine.serve(new FileInputStream(FileDescriptor.in));
    // The input also ends if the parent was killed, and then nobody else removes the folder.
    removeFolder(new File("").getAbsoluteFile());
  }

  /** Ends with the parent, since an engine at work on an event does not see its input end. */
  private static void endWithParent() {
    ProcessHandle.current()
        .parent()
        .ifPresent(
            parent ->
                parent
                    .onExit()
                    .thenRun(
                        () -> {
                          removeFolder(new File("").getAbsoluteFile());
                          System.exit(NOBODY_LEFT);
                        }));
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
    var lines = new JsonLines(in);
    for (Json line = lines.next(); line != null; line = lines.next()) {
      try {
        take(line);
      } catch (NotCovered | StackOverflowError e) {
        var error = new JsonObject();
        if (object(line).has("line")) {
          error.add("line", number(line));
        }
        error.addProperty("message", String.valueOf(e.getMessage()));
        answer("error", error);
      }
    }
  }

  private void take(Json line) {
    String message = line.first(MESSAGE);
    if (message == null) {
      // The engine passes over the other lines of a log that is decided.
      if (!decided) {
        observe(line);
      }
      return;
    }
    switch (message) {
      case "begin" -> begin(object(line));
      case "alternatives" -> print(alternatives());
      case "verdict" -> {
        if (!decided) {
          print(open());
        }
      }
      case "finish" -> {
        if (!decided) {
          answer("accepted", null);
        }
      }
      default -> print(sessions.answer(message, object(line)));
    }
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
    loose = null;
    followed.clear();
    follow = json.has("follow") ? json.get("follow").getAsInt() : 0;
    explanation = new Explanation(spec, Json.of(json.get("header").toString()));
  }

  private JsonObject alternatives() {
    var answer = new JsonObject();
    answer.add("alternatives", spec.alternatives());
    return answer;
  }

  private static JsonObject open() {
    var answer = new JsonObject();
    answer.addProperty("verdict", "open");
    return answer;
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

  private void observe(Json event) {
    Explanation.Refusal refusal = explanation.observe(event);
    if (loose == null && explanation.loosened()) {
      loose = number(event);
    }
    if (refusal == null) {
      events++;
      if (follow > 0) {
        remember(number(event));
      }
      return;
    }
    JsonObject rejected = refusal.asJson();
    rejected.add("line", number(event));
    answer("rejected", rejected);
  }

  private void answer(String verdict, JsonObject details) {
    JsonObject answer = details == null ? new JsonObject() : details;
    answer.addProperty("verdict", verdict);
    answer.addProperty("events", events);
    if (loose != null) {
      answer.add("loose", loose);
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
    decided = true;
    explanation = null;
    print(answer);
  }

  private void print(JsonObject json) {
    out.println(json);
    out.flush();
  }
}
