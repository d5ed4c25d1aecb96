package s7.trace;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

import com.google.gson.JsonObject;
import tla.json.Json;
import tlc2.value.impl.Value;

/**
 * The sessions of an engine, by their names. Each message has one answer:
 *
 * <ul>
 *   <li>{@code open} with {@code header} begins a session, anew if there is one of that name; {@code
 *       close} ends it.
 *   <li>{@code branch} with {@code to}, the name of a session that begins with the same lines.
 *   <li>{@code feed} with {@code event} adds a line: the answer has {@code refusal} if it is not
 *       possible. {@code judge} tells the same and adds nothing.
 *   <li>{@code back} with {@code lines}: so many lines are left.
 *   <li>{@code situations} with {@code most}; {@code before} with {@code event} and {@code most}: just before
 *       that line.
 *   <li>{@code parting} with {@code from}, the name of another session, {@code lines}, {@code only}, {@code obs}, {@code
 *       deepest} and {@code most}: the shortest log that this session allows and the other does not ({@link Parting}).
 *   <li>{@code possible}, with {@code lines} or for all that the specification offers, or for those of its events
 *       {@code only}, with one line of {@code few}; {@code when} or at all times; in {@code most} states or all.
 * </ul>
 *
 * <p>The answer has {@code error} where the specification cannot be evaluated.
 */
final class Sessions {
  private static final String EVENT = "event";
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
    } catch (NotCovered | StackOverflowError e) {
      answer.addProperty("error", String.valueOf(e.getMessage()));
    }
    return answer;
  }

  private void fill(JsonObject answer, String message, JsonObject json) {
    String name = json.get("session").getAsString();
    if ("open".equals(message)) {
      open.put(name, new Session(spec, text(json, "header")));
      return;
    }
    Session session = named(name);
    switch (message) {
      case "close" -> open.remove(name);
      case "branch" -> open.put(json.get("to").getAsString(), session.branch());
      case "feed" -> refusal(answer, session.feed(text(json, EVENT)));
      case "judge" -> refusal(answer, session.judge(text(json, EVENT)));
      case "back" -> session.back(json.get("lines").getAsInt());
      case "situations" -> answer.add("situations", session.situations(json.get(MOST).getAsInt()));
      case "before" -> answer.add("situations", session.before(text(json, EVENT), json.get(MOST).getAsInt()));
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
    var given = new ArrayList<Value>();
    json.getAsJsonArray("lines").forEach(line -> given.add(spec.event(Json.of(line.toString()))));
    var obs = new HashSet<Integer>();
    json.getAsJsonArray("obs").forEach(ob -> obs.add(ob.getAsInt()));
    return session.parting(
        named(json.get("from").getAsString()),
        new Parting.Bounds(
            given, names(json, "only"), obs, json.get("deepest").getAsInt(), json.get(MOST).getAsInt()));
  }

  private static JsonObject possible(Session session, JsonObject json) {
    int share = json.has(MOST) ? json.get(MOST).getAsInt() : Integer.MAX_VALUE;
    return session.possible(
        new Session.Question(
            json.getAsJsonArray("lines"),
            json.getAsJsonObject("when"),
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

  private static Json text(JsonObject json, String field) {
    return Json.of(json.get(field).toString());
  }

  private static void refusal(JsonObject answer, Explanation.Refusal refusal) {
    if (refusal != null) {
      answer.add("refusal", refusal.asJson());
    }
  }
}
