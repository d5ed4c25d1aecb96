package s7.trace;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

import s7.log.Fields;
import s7.log.Unusable;

/**
 * The sessions of an engine, by their names. Header and lines are texts as a log has them. Each message has one answer:
 *
 * <ul>
 *   <li>{@code open} with {@code header}, and {@code file} as {@link Engine} has it, begins a session, anew if there is
 *       one of that name; {@code close} ends it.
 *   <li>{@code questions} with {@code header} and {@code lines}: by which open questions the explanations of that log
 *       differ ({@link OpenQuestions}).
 *   <li>{@code branch} with {@code to}, the name of a session that begins with the same lines.
 *   <li>{@code feed} with {@code line} adds a line: the answer has {@code refusal} if it is not possible. {@code judge}
 *       tells the same and adds nothing.
 *   <li>{@code add} with {@code lines} adds them up to the first that is not possible, whose {@code refusal} is in words;
 *       the answer has the number of {@code lines} that the session has then.
 *   <li>{@code look} with {@code after}, so many lines, and {@code at}: what is shown after them ({@link Look}), of
 *       what may come all or the events {@code only}; {@code impossible} what may not come then; {@code lines} what may
 *       come, of the events {@code only}, with {@code few} one of each call with operands, or of these {@code lines};
 *       {@code why} the {@code refusal} of the {@code line}; {@code states} the situations after the lines from {@code after} to {@code to}.
 *   <li>{@code back} with {@code lines}: so many lines are left.
 *   <li>{@code situations} with {@code most}; {@code before} with {@code line} and {@code most}: just before that line.
 *   <li>{@code parting} with {@code from}, the name of another session, {@code lines}, {@code only}, {@code obs}, {@code
 *       deepest} and {@code most}: the shortest log that this session allows and the other does not ({@link Parting}).
 *   <li>{@code possible}, with {@code lines} or for all that the specification offers, or for those of its events
 *       {@code only}; at the time of the line {@code when} or at all times; in {@code most}
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
  private static final String AFTER = "after";

  private final Contract spec;
  private final Map<String, Session> open = new HashMap<>();
  private final WhyNot why;

  Sessions(Contract spec, WhyNot why) {
    this.spec = spec;
    this.why = why;
  }

  /**
   * @throws IllegalArgumentException if there is no such message or session
   */
  Fields answer(String message, Fields json) {
    var answer = new Fields();
    try {
      fill(answer, message, json);
    } catch (Unusable wrong) {
      answer.put("unusable", wrong.asJson());
    } catch (NotCovered | StackOverflowError e) {
      answer.put("error", NotCovered.said(e));
    }
    return answer;
  }

  private void fill(Fields answer, String message, Fields json) {
    String name = json.text("session");
    if ("questions".equals(message)) {
      answer.put("questions", questions(json));
      return;
    }
    if ("open".equals(message)) {
      Fields header = spec.format().header(text(json, "header"), Engine.file(json));
      Fields chosen = json.has("chosen") ? spec.format().chosen(header, json.object("chosen")) : header;
      var session = new Session(spec, chosen);
      open.put(name, session);
      answer.put(CLOCK, session.clock());
      return;
    }
    Session session = named(name);
    switch (message) {
      case "close" -> open.remove(name);
      case "branch" -> open.put(json.text("to"), session.branch());
      case "feed" -> {
        refusal(answer, session.feed(text(json, LINE)), text(json, LINE));
        answer.put(CLOCK, session.clock());
      }
      case "judge" -> refusal(answer, session.judge(text(json, LINE)), text(json, LINE));
      case "back" -> {
        session.back(json.number("lines"));
        answer.put(CLOCK, session.clock());
      }
      case "add" -> add(answer, session, json);
      case "look" -> answer.put("look", look(session, json).answer(withOperands(), json.text("at"), names(json, "only")));
      case "impossible" -> answer.put("impossible", look(session, json).impossible(json.text("at"), why));
      case "lines" -> answer.with(lines(look(session, json), json));
      case "why" -> refusal(answer, until(session, json).judge(text(json, LINE)), text(json, LINE));
      case "states" -> answer.put("states", session.states(json.number(AFTER), json.number("to")));
      case "situations" -> answer.put("situations", InWords.withWords(session.situations(json.number(MOST))));
      case "before" -> answer.put("situations", session.before(text(json, LINE), json.number(MOST)));
      case "parting" -> answer.put("parting", parting(session, json));
      case "possible" -> answer.put("possible", possible(session, json));
      default -> throw new IllegalArgumentException("an unknown message: " + message);
    }
  }

  /** Calls of which one line is enough: the others are asked for. */
  private Set<String> withOperands() {
    return spec.format().callsWithOperands();
  }

  private List<Fields> questions(Fields json) {
    Fields header = spec.format().header(text(json, "header"), Engine.file(json));
    Fields given = Fields.of(text(json, "header"));
    Fields named = given.has("readings") ? given.object("readings") : new Fields();
    return new OpenQuestions(spec, header, texts(json, "lines")).differing(named);
  }

  private static Look look(Session session, Fields json) {
    return new Look(until(session, json));
  }

  /** The session as it was after so many lines. */
  private static Session until(Session session, Fields json) {
    return session.until(json.number(AFTER));
  }

  private void add(Fields answer, Session session, Fields json) {
    try {
      for (byte[] line : texts(json, "lines")) {
        Explanation.Refusal refusal = session.feed(line);
        if (refusal != null) {
          refusal(answer, refusal, line);
          instead(answer.object("refusal"), line, session.clock());
          break;
        }
      }
    } finally {
      answer.put("lines", session.lines()).put(CLOCK, session.clock());
    }
  }

  private Fields lines(Look look, Fields json) {
    List<byte[]> lines = json.has("lines") ? texts(json, "lines") : null;
    Set<String> few = json.has("few") ? withOperands() : Set.of();
    return look.lines(json.text("at"), lines, names(json, "only"), few);
  }

  private void refusal(Fields answer, Explanation.Refusal refusal, byte[] line) {
    if (refusal != null) {
      answer.put("refusal", why.told(refusal, line));
    }
  }

  /** Adds the lines that each expected event puts in the place of the line. */
  private static void instead(Fields refusal, byte[] line, String at) {
    boolean late = Boolean.TRUE.equals(refusal.get("late"));
    List<Fields> expected = Work.objects((Collection<?>) refusal.get("expected"));
    refusal.put("instead", expected.stream().map(one -> Spelled.inPlace(one, late, line, at)).toList());
  }

  private Session named(String name) {
    Session session = open.get(name);
    if (session == null) {
      throw new IllegalArgumentException("no session " + name);
    }
    return session;
  }

  private Fields parting(Session session, Fields json) {
    var obs = new HashSet<Integer>();
    json.list("obs").forEach(ob -> obs.add(((Number) ob).intValue()));
    return session.parting(
        named(json.text("from")),
        new Parting.Bounds(
            session.timeless(texts(json, "lines")), names(json, "only"), obs, json.number("deepest"), json.number(MOST)));
  }

  private static Fields possible(Session session, Fields json) {
    int share = json.has(MOST) ? json.number(MOST) : Integer.MAX_VALUE;
    return session.possible(
        new Session.Question(
            json.has("lines") ? session.timeless(texts(json, "lines")) : null,
            json.has("when") ? text(json, "when") : null,
            share,
            names(json, "only"),
            Set.of()));
  }

  private static Set<String> names(Fields json, String field) {
    var names = new HashSet<String>();
    json.list(field).forEach(name -> names.add((String) name));
    return names;
  }

  private static byte[] text(Fields json, String field) {
    return bytes(json.get(field));
  }

  private static List<byte[]> texts(Fields json, String field) {
    var texts = new ArrayList<byte[]>();
    json.list(field).forEach(text -> texts.add(bytes(text)));
    return texts;
  }

  private static byte[] bytes(Object text) {
    return ((String) text).getBytes(StandardCharsets.UTF_8);
  }
}
