package s7.trace;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import s7.log.Unusable;

/**
 * The sessions of an engine, by their names. Header and lines are texts as a log has them. Each message has one answer:
 *
 * <ul>
 *   <li>{@code open} with {@code header}, and {@code file} as {@link Engine} has it, begins a session, anew if there is
 *       one of that name; {@code close} ends it.
 *   <li>{@code branch} with {@code to}, the name of a session that begins with the same lines.
 *   <li>{@code feed} with {@code line} adds a line: the answer has {@code refusal} if it is not possible. {@code judge}
 *       tells the same and adds nothing.
 *   <li>{@code back} with {@code lines}: so many lines are left.
 *   <li>{@code situations} with {@code most}; {@code before} with {@code line} and {@code most}: just before that line.
 *   <li>{@code parting} with {@code from}, the name of another session, {@code lines}, {@code only}, {@code obs}, {@code
 *       deepest} and {@code most}: the shortest log that this session allows and the other does not ({@link Parting}).
 *   <li>{@code possible}, with {@code lines} or for all that the specification offers, or for those of its events
 *       {@code only}, with one line of {@code few}; at the time of the line {@code when} or at all times; in {@code most}
 *       states or all.
 * </ul>
 *
 * <p>The answer has the {@code clock} after the last line where that may have changed, what is {@code unusable}, and
 * {@code error} where the specification cannot be evaluated.
 */
final class Sessions {
  private static final String LINE = "line";
  private static final String CLOCK = "clock";
  private static final String MOST = "most";

  private final Contract spec;
  private final Map<String, Session> open = new HashMap<>();

  Sessions(Contract spec) {
    this.spec = spec;
  }

  /**
   * @throws IllegalArgumentException if there is no such message or session
   */
  JsonObject answer(String message, JsonObject json) {
    var answer = new JsonObject();
    try {
      fill(answer, message, json);
    } catch (Unusable wrong) {
      answer.add("unusable", Engine.json(wrong.asJson()));
    } catch (NotCovered | StackOverflowError e) {
      answer.addProperty("error", String.valueOf(e.getMessage()));
    }
    return answer;
  }

  private void fill(JsonObject answer, String message, JsonObject json) {
    String name = json.get("session").getAsString();
    if ("open".equals(message)) {
      var session = new Session(spec, spec.format().header(text(json, "header"), Engine.file(json)));
      open.put(name, session);
      answer.addProperty(CLOCK, session.clock());
      return;
    }
    Session session = named(name);
    switch (message) {
      case "close" -> open.remove(name);
      case "branch" -> open.put(json.get("to").getAsString(), session.branch());
      case "feed" -> {
        refusal(answer, session.feed(text(json, LINE)));
        answer.addProperty(CLOCK, session.clock());
      }
      case "judge" -> refusal(answer, session.judge(text(json, LINE)));
      case "back" -> {
        session.back(json.get("lines").getAsInt());
        answer.addProperty(CLOCK, session.clock());
      }
      case "situations" -> answer.add("situations", session.situations(json.get(MOST).getAsInt()));
      case "before" -> answer.add("situations", session.before(text(json, LINE), json.get(MOST).getAsInt()));
      case "parting" -> answer.add("parting", parting(session, json));
      case "possible" -> answer.add("possible", possible(session, json));
      default -> throw new IllegalArgumentException("an unknown message: " + message);
    }
  }

  private Session named(String name) {
    Session session = open.get(name);
    if (session == null) {
      throw new IllegalArgumentException("no session " + name);
    }
    return session;
  }

  private JsonObject parting(Session session, JsonObject json) {
    var obs = new HashSet<Integer>();
    json.getAsJsonArray("obs").forEach(ob -> obs.add(ob.getAsInt()));
    return session.parting(
        named(json.get("from").getAsString()),
        new Parting.Bounds(
            session.timeless(texts(json, "lines")), names(json, "only"), obs, json.get("deepest").getAsInt(), json.get(MOST).getAsInt()));
  }

  private static JsonObject possible(Session session, JsonObject json) {
    int share = json.has(MOST) ? json.get(MOST).getAsInt() : Integer.MAX_VALUE;
    return session.possible(
        new Session.Question(
            json.has("lines") ? session.timeless(texts(json, "lines")) : null,
            json.has("when") ? text(json, "when") : null,
            share,
            names(json, "only"),
            names(json, "few")));
  }

  private static Set<String> names(JsonObject json, String field) {
    var names = new HashSet<String>();
    if (json.has(field)) {
      json.getAsJsonArray(field).forEach(name -> names.add(name.getAsString()));
    }
    return names;
  }

  private static byte[] text(JsonObject json, String field) {
    return bytes(json.get(field));
  }

  private static List<byte[]> texts(JsonObject json, String field) {
    var texts = new ArrayList<byte[]>();
    json.getAsJsonArray(field).forEach(text -> texts.add(bytes(text)));
    return texts;
  }

  private static byte[] bytes(JsonElement text) {
    return text.getAsString().getBytes(StandardCharsets.UTF_8);
  }

  private static void refusal(JsonObject answer, Explanation.Refusal refusal) {
    if (refusal != null) {
      answer.add("refusal", refusal.asJson());
    }
  }
}
