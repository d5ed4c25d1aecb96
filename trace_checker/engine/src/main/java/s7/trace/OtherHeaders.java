package s7.trace;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

import s7.log.Fields;

/**
 * The headers beside that of a log: with each other CPU, each other edition of the manual or none, and one other letter
 * at a time. Each has the {@code kind} of its {@code change}, and what is {@code chosen}, as the message {@code begin}
 * has it. Those of the least {@code distance} bear most on the verdict, and under those that are the {@code same} it
 * cannot be another.
 */
final class OtherHeaders {
  private static final String LETTER = "letter";
  private static final String CHANGE = "change";
  private static final String LINE = "line";

  private final List<Fields> found = new ArrayList<>();
  private final Fields rejected;
  private final Clauses clauses;

  private OtherHeaders(Fields rejected, Clauses clauses) {
    this.rejected = rejected;
    this.clauses = clauses;
  }

  /**
   * @param header the normalised header
   * @param rejected of a rejected log the {@code rules} that decided and the {@code asked} questions, as far as known
   */
  static List<Fields> of(Fields words, Fields header, Fields rejected, Clauses clauses) {
    var others = new OtherHeaders(rejected, clauses);
    for (Object family : words.list("families")) {
      others.add("cpu", "cpu " + family, family, header.get("cpu"));
    }
    others.add("profile", "no profile", "", header.get("profile"));
    for (Object profile : words.list("profiles")) {
      others.add("profile", "profile " + profile, profile, header.get("profile"));
    }
    Map<Object, Object> own = header.text("profile").isEmpty() ? map(words.list("defaults")) : new HashMap<>();
    own.putAll(map(header.list("readings")));
    for (Object pair : words.list("letters")) {
      String name = (String) ((List<?>) pair).get(0);
      for (Object letter : (List<?>) ((List<?>) pair).get(1)) {
        others.add(LETTER, name + " " + letter, letter, own.get(name));
      }
    }
    return others.found;
  }

  private static Map<Object, Object> map(List<?> pairs) {
    var map = new HashMap<>();
    pairs.forEach(pair -> map.put(((List<?>) pair).get(0), ((List<?>) pair).get(1)));
    return map;
  }

  /** Adds a header with a value, unless the log's own has it. */
  private void add(String kind, String change, Object value, Object own) {
    if (value.equals(own)) {
      return;
    }
    String name = change.substring(0, change.indexOf(' '));
    boolean letter = LETTER.equals(kind);
    var chosen = new Fields();
    if (letter) {
      chosen.put("readings", new Fields().put(name, value));
    } else {
      chosen.put(kind, value);
    }
    found.add(
        new Fields()
            .put("kind", kind)
            .put(CHANGE, change)
            .put("chosen", chosen)
            .put("distance", letter ? distance(name) : 2)
            .put("same", letter && rejected.has("asked") && !rejected.list("asked").contains(name)));
  }

  /** 0 if the question itself has decided, 1 if a rule that names it has. */
  private int distance(String question) {
    List<?> rules = rejected.list("rules");
    if (rules.contains(question)) {
      return 0;
    }
    return rules.stream().anyMatch(rule -> clauses.text((String) rule).matches(".*\\b" + question + "\\b.*")) ? 1 : 3;
  }

  /**
   * What a report says of the verdicts under other headers: headings, each with its lines.
   *
   * @param message {@code verdict} and {@code line} of the log; those {@code tried}, each with its {@code kind}, {@code
   *     change}, {@code verdict} and {@code line}; the changes {@code untried}, and the {@code remedy} for that
   */
  static List<List<Object>> told(Fields message, Clauses clauses) {
    List<Fields> tried = Work.objects(message.list("tried"));
    List<Fields> passing = tried.stream().filter(OtherHeaders::passes).toList();
    List<Fields> others = tried.stream().filter(one -> !passes(one)).toList();
    var parts = new ArrayList<List<Object>>();
    if (passes(message)) {
      parts.add(List.of("also accepted by", List.of(passing.size() + " of " + tried.size() + " other readings")));
      parts.add(List.of("rejected by", all(others.stream().map(OtherHeaders::outcome), "none of them")));
    } else {
      var texts = passing.stream().map(one -> reading(one, clauses));
      parts.add(List.of("would pass with", all(texts, "no other reading that was tried")));
      var later = others.stream().filter(one -> line(one) > line(message)).map(OtherHeaders::outcome).toList();
      if (!later.isEmpty()) {
        parts.add(List.of("would get further with", List.of(InWords.few(later))));
      }
    }
    if (!message.list("untried").isEmpty()) {
      List<String> untried = message.list("untried").stream().map(String.class::cast).toList();
      parts.add(List.of("not tried for lack of time", List.of(InWords.few(untried) + message.text("remedy"))));
    }
    return parts;
  }

  private static boolean passes(Fields one) {
    return "accepted".equals(one.text("verdict"));
  }

  private static int line(Fields one) {
    return one.get(LINE) == null ? 0 : one.number(LINE);
  }

  private static List<String> all(Stream<String> texts, String none) {
    List<String> all = texts.toList();
    return all.isEmpty() ? List.of(none) : all;
  }

  /** A reading with the question that it answers. */
  private static String reading(Fields one, Clauses clauses) {
    String change = one.text(CHANGE);
    return LETTER.equals(one.text("kind")) ? clauses.answered(change) : change;
  }

  private static String outcome(Fields one) {
    String verdict = one.text("verdict");
    return one.text(CHANGE) + ("rejected".equals(verdict) ? "" : " " + verdict)
        + (line(one) == 0 ? "" : " at line " + line(one));
  }
}
