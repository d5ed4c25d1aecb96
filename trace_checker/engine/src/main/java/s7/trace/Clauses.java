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
    return text(id, "text");
  }

  private String text(String id, String field) {
    String text = clauses.containsKey(id) ? clauses.get(id).text(field) : null;
    return text == null ? "" : text;
  }

  /** A clause with its origin, such as {@code AIRT-03 Calls are counted (SF06ru, H; docs/...#AIRT-03)}. */
  String line(String id) {
    var origin = new ArrayList<>(List.of(text(id, "source"), text(id, "confidence")));
    origin.removeIf(String::isEmpty);
    String from = String.join(", ", origin);
    return id + " " + text(id) + (from.isEmpty() ? "" : " (" + from + "; " + text(id, "place") + ")");
  }

  /** A letter, such as {@code AMB-12 b}, with the question and the answer for which it stands. */
  String answered(String choice) {
    String id = choice.substring(0, choice.indexOf(' '));
    if (text(id).isEmpty()) {
      return choice;
    }
    String answer = clauses.get(id).object("letters").text(choice.substring(id.length() + 1));
    return choice + ": " + text(id) + " " + (answer == null ? "" : answer) + " (" + text(id, "place") + ")";
  }

  /** A question and all answers to it, such as {@code Is it late? (AMB-13) a: yes; b: no}. */
  String question(String id) {
    var answers = new ArrayList<String>();
    Fields letters = clauses.get(id).object("letters");
    for (int i = 0; i < letters.size(); i++) {
      answers.add(letters.name(i) + ": " + letters.value(i));
    }
    return text(id) + " (" + id + ") " + String.join("; ", answers);
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
