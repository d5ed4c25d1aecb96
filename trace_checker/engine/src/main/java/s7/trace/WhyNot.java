package s7.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import s7.log.Fields;
import tla.spec.Guards;

/**
 * Why a line is not possible, as reports and the page say it. Its sentence has what cannot be, the requirement in its
 * words, and what may be instead.
 */
final class WhyNot {
  private static final Pattern CODE = Pattern.compile("\\b(?:16#)?([0-9A-F]{4})\\b");
  private static final Pattern NAMED_ID = Pattern.compile("\\b(id|cause)=(16#[0-9A-F]{4})\\b");
  private static final int MOST = 6;

  private final Clauses clauses;

  WhyNot(Clauses clauses) {
    this.clauses = clauses;
  }

  /**
   * A refusal with all that is said about it: {@code wanted} are the texts of what was expected. Parts of a report are
   * {@code decision} and {@code before}, headings with their lines, and the lines {@code rules} and {@code formulas}.
   * Where the line came too late the formula would be that of elapsing time.
   *
   * @param line the line as the log has it; empty if that is not known
   */
  Fields told(Explanation.Refusal refusal, byte[] line) {
    List<Fields> situations = InWords.withWords(refusal.situations());
    List<String> wanted =
        Work.objects(refusal.expected()).stream()
            .map(one -> refusal.late() ? InWords.late(one, situations) : one.text("text"))
            .toList();
    var candidates = InWords.telling(refusal.candidates());
    String why = sentence(refusal, line.length == 0 ? null : Fields.of(line), wanted);
    return refusal.asJson()
        .put("message", refusal.message())
        .put("why", why)
        .put("wanted", wanted)
        .put("states", refusal.states())
        .put("situations", situations)
        .put("candidates", candidates.stream().map(WhyNot::json).toList())
        .put("decision", decision(refusal, wanted, why))
        .put("rules", refusal.requirements().stream().map(clauses::line).toList())
        .put("before", before(situations, refusal.states()))
        .put("formulas", refusal.late() ? List.of() : formulas(candidates.stream().map(InWords::formula).toList()));
  }

  private static List<List<Object>> decision(Explanation.Refusal refusal, List<String> wanted, String why) {
    var parts = new ArrayList<List<Object>>();
    String few = wanted.isEmpty() ? "nothing" : InWords.few(wanted);
    parts.add(refusal.late() ? List.of("expected before it", wanted) : List.of("expected", List.of(few)));
    parts.add(List.of("requirements", List.of(String.join(", ", refusal.requirements()))));
    if (!why.isEmpty()) {
      parts.add(List.of("why not", List.of(why)));
    }
    return parts;
  }

  private static List<List<Object>> before(List<Fields> situations, int states) {
    var parts = new ArrayList<List<Object>>();
    for (Fields state : situations) {
      String of = states > 1 ? " " + (parts.size() + 1) + " of " + states : "";
      parts.add(List.of("before the line" + of, state.list("said").stream().map(WhyNot::joined).toList()));
    }
    return parts;
  }

  private static String joined(Object said) {
    return ((List<?>) said).get(0) + ": " + ((List<?>) said).get(1);
  }

  private static List<String> formulas(List<String> all) {
    var shown = new ArrayList<>(all.subList(0, Math.min(MOST, all.size())));
    if (all.size() > MOST) {
      shown.add("and " + (all.size() - MOST) + " more");
    }
    return shown;
  }

  private static Fields json(Guards.Failure failure) {
    return new Fields()
        .put("action", failure.action())
        .put("conjunct", failure.conjunct())
        .put("values", failure.values())
        .put("place", failure.place())
        .put("requirements", failure.requirements());
  }

  /**
   * The sentence; empty without requirements.
   *
   * @param line the line as the log has it; null if that is not known
   * @param owed the texts of what had to come before it
   */
  private String sentence(Explanation.Refusal refusal, Fields line, List<String> owed) {
    if (refusal.requirements().isEmpty() || (line == null && !refusal.late())) {
      return "";
    }
    String rule = refusal.requirements().iterator().next();
    if (refusal.late()) {
      return "Before this line has to come: " + or(owed.stream().map(this::withWords).toList()) + ". "
          + rule(rule, List.of());
    }
    List<Fields> fields = new ArrayList<>();
    for (Object one : refusal.expected()) {
      var allowed = (Fields) one;
      String value = Spelled.allowedValue(allowed);
      boolean wrong = !value.isEmpty() && !value.equals(given(line, allowed.text("field")));
      if (wrong && allowed.text("event").equals(line.text("event"))) {
        fields.add(allowed);
      }
    }
    // Of several wrong fields one is told; the others stand in what was expected.
    String field =
        fields.stream().map(one -> one.text("field")).filter(one -> !given(line, one).isEmpty()).findFirst().orElse("");
    List<String> instead =
        fields.stream().filter(one -> one.text("field").equals(field)).map(Spelled::allowedValue).toList();
    var about = new ArrayList<>(instead);
    about.add(given(line, field));
    return claim(line, field) + " here. " + rule(rule, about) + end(field, or(instead));
  }

  /** What cannot be. */
  private String claim(Fields line, String field) {
    String name = line.text("event");
    String given = given(line, field);
    if (field.equals("ret")) {
      return name + " cannot answer " + given;
    }
    if (field.equals("status")) {
      return name + " cannot give STATUS " + given;
    }
    if (Spelled.isCall(name)) {
      return name + " cannot be called";
    }
    String having = field.isEmpty() ? " cannot come" : " cannot have " + field + " " + given;
    if (name.equals("diag")) {
      return "The entry " + entry(given(line, "id")) + having;
    }
    if (!field.isEmpty()) {
      return name + (given(line, "ob").isEmpty() ? "" : " of OB " + given(line, "ob")) + having;
    }
    boolean none = line.get("cause") instanceof Number number && number.intValue() == 0;
    String cause = none ? "" : given(line, "cause");
    return withoutField(name, line) + (cause.isEmpty() ? "" : " for " + entry(cause));
  }

  private static String withoutField(String name, Fields line) {
    String ob = "OB " + given(line, "ob");
    return switch (name) {
      case "start" -> ob + " cannot start";
      case "end" -> ob + " cannot end";
      case "run" -> "The CPU cannot go to RUN";
      case "stop" -> "The CPU cannot stop";
      case "hold" -> "HOLD cannot begin";
      case "release" -> "HOLD cannot end";
      case "restart" -> "A " + given(line, "type") + " restart cannot begin";
      case "interrupt" -> "A start event for " + ob + " cannot come";
      case "clock" -> "The clock cannot be set";
      case "load" -> ob + " cannot be loaded";
      case "delete" -> ob + " cannot be deleted";
      default -> name + " cannot come";
    };
  }

  /** What is instead. */
  private static String end(String field, String instead) {
    return switch (field) {
      case "" -> "";
      case "ret" -> " It answers " + instead + ".";
      case "status" -> " It gives " + instead + ".";
      default -> " It has " + instead + ".";
    };
  }

  /** Such as {@code 16#4568 (STOP: OB 80 missing)}. */
  private String entry(String number) {
    Matcher found = CODE.matcher(number);
    String text = found.find() ? clauses.event(found.group(1)) : "";
    return text.isEmpty() ? number : number + " (" + text + ")";
  }

  /** What had to come, with the words of an event ID that it names. */
  private String withWords(String said) {
    Matcher named = NAMED_ID.matcher(said);
    return named.find()
        ? said.substring(0, named.start(2)) + entry(named.group(2)) + said.substring(named.end(2))
        : said;
  }

  /** The value of a field of the line or of its start information as a report spells it; empty if it has none. */
  private static String given(Fields line, String field) {
    Object value = line.get(field);
    if (!line.has(field) && line.get("info") instanceof Fields info) {
      value = info.get(field);
    }
    if (value instanceof Boolean truth) {
      return Spelled.value(field, truth ? 1 : 0);
    }
    return value instanceof Number number
        ? Spelled.value(field, number.intValue())
        : value == null ? "" : String.valueOf(value).replaceAll("^[WB]#(?=16#)", "");
  }

  /**
   * The sentence of a requirement that has one of the codes, the first of them that any has; else its first one. 0000
   * stands in many rules, also as a PERIOD: it counts last.
   */
  private String rule(String name, List<String> about) {
    List<String> all = clauses.sentences(name);
    var codes = new ArrayList<String>();
    about.forEach(text -> codes.addAll(codes(text)));
    codes.sort((one, other) -> Boolean.compare(one.equals("0000"), other.equals("0000")));
    String first = all.isEmpty() ? "" : all.get(0);
    for (String code : codes) {
      for (String sentence : all) {
        if (codes(sentence).contains(code)) {
          return cited(sentence, name);
        }
      }
    }
    return first.endsWith("?") ? "The sources leave open: " + clauses.question(name) + "." : cited(first, name);
  }

  private static List<String> codes(String text) {
    var codes = new ArrayList<String>();
    Matcher found = CODE.matcher(text);
    while (found.find()) {
      codes.add(found.group(1));
    }
    return codes;
  }

  private static String cited(String text, String name) {
    return (text.endsWith(".") ? text.substring(0, text.length() - 1) : text) + " (" + name + ").";
  }

  private static String or(List<String> texts) {
    if (texts.size() > MOST) {
      return "one of " + texts.size() + " values";
    }
    int last = texts.size() - 1;
    return last < 1 ? String.join("", texts) : String.join(", ", texts.subList(0, last)) + " or " + texts.get(last);
  }
}
