package s7.trace;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

import s7.log.Fields;

/**
 * The headers beside that of a log: with each other CPU, each other edition of the manual or none, and one other letter
 * at a time. Each has the {@code kind} of its {@code change}, and what is {@code chosen}, as the message {@code begin}
 * has it.
 */
final class OtherHeaders {
  private final List<Fields> found = new ArrayList<>();

  private OtherHeaders() {}

  /**
   * @param header the normalised header
   */
  static List<Fields> of(Fields words, Fields header) {
    var others = new OtherHeaders();
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
        others.add("letter", name + " " + letter, letter, own.get(name));
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
    var chosen = new Fields();
    if ("letter".equals(kind)) {
      chosen.put("readings", new Fields().put(change.substring(0, change.indexOf(' ')), value));
    } else {
      chosen.put(kind, value);
    }
    found.add(new Fields().put("kind", kind).put("change", change).put("chosen", chosen));
  }
}
