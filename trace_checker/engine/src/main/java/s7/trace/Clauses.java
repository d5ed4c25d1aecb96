package s7.trace;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import s7.log.Fields;

/** The words of the requirements, of the open questions and of event IDs, which come with the message {@code texts}. */
final class Clauses {
  private final Map<String, Fields> clauses = new HashMap<>();
  private Fields events = new Fields();

  /** Takes the words. */
  void take(Fields message) {
    for (Fields clause : Work.objects(message.list("clauses"))) {
      clauses.put(clause.text("id"), clause);
    }
    events = message.object("events");
  }

  /** What a clause says; empty if there is none, or before the words came. */
  String text(String id) {
    return clauses.containsKey(id) ? clauses.get(id).text("text") : "";
  }

  /** A clause with its origin, such as {@code AIRT-03 Calls are counted (SF06ru, H; docs/...#AIRT-03)}. */
  String line(String id) {
    Fields clause = clauses.getOrDefault(id, new Fields().put("text", "").put("source", "").put("confidence", ""));
    String source = clause.text("source");
    String confidence = clause.text("confidence");
    String origin = source + (source.isEmpty() || confidence.isEmpty() ? "" : ", ") + confidence;
    return id + " " + clause.text("text") + (origin.isEmpty() ? "" : " (" + origin + "; " + clause.text("place") + ")");
  }

  /** A letter, such as {@code AMB-12 b}, with the question and the answer for which it stands. */
  String answered(String choice) {
    String[] parts = choice.split(" ");
    String text = text(parts[0]);
    if (text.isEmpty()) {
      return choice;
    }
    Fields clause = clauses.get(parts[0]);
    Object answer = clause.object("letters").get(parts[1]);
    return choice + ": " + text + " " + (answer == null ? "" : answer) + " (" + clause.text("place") + ")";
  }

  /** What an event ID of four digits means; empty if no source tells. */
  String event(String digits) {
    return events.has(digits) ? events.text(digits) : "";
  }

  /** The sentences of a clause; what stands in parentheses ends none. */
  List<String> sentences(String id) {
    String text = text(id);
    var sentences = new ArrayList<String>();
    int from = 0;
    for (int i = 0; i < text.length(); i++) {
      if (text.charAt(i) == '(') {
        i = Math.max(i, text.indexOf(')', i));
      } else if (i + 1 == text.length() || text.startsWith(". ", i)) {
        sentences.add(text.substring(from, i + 1).trim());
        from = i + 1;
      }
    }
    return sentences;
  }
}
