package s7.trace;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;

import s7.log.Fields;

/**
 * The open questions by which the explanations of a log differ: a letter of each leaves some of them, and another letter
 * others. The specification answers: the log is followed under each letter of each question that it has met.
 */
final class OpenQuestions {
  /** Situations that are compared. */
  private static final int MOST = 64;

  /** Lines of a log that is followed under each letter. */
  private static final int LONGEST = 200;

  private static final String READINGS = "readings";

  private final Contract spec;
  private final Fields header;
  private final List<byte[]> lines;

  /**
   * @param header the normalised header
   */
  OpenQuestions(Contract spec, Fields header, List<byte[]> lines) {
    this.spec = spec;
    this.header = header;
    this.lines = lines;
  }

  /**
   * Each with its {@code name}, and in {@code explanations} the numbers that each of its letters leaves.
   *
   * @param named the questions that the header answers by itself
   */
  List<Fields> differing(Fields named) {
    var found = new ArrayList<Fields>();
    if (lines.size() > LONGEST) {
      return found;
    }
    spec.forgetAsked();
    List<String> ours = situations(header);
    Set<String> asked = spec.asked();
    if (ours.size() < 2) {
      return found;
    }
    for (Object choice : spec.alternatives().list("choices")) {
      List<?> pair = (List<?>) choice;
      String name = (String) pair.get(0);
      if (!named.has(name) && (asked == null || asked.contains(name))) {
        Fields numbers = parted(ours, name, (Collection<?>) pair.get(1));
        if (numbers != null) {
          found.add(new Fields().put("name", name).put("explanations", numbers));
        }
      }
    }
    return found;
  }

  /** The numbers that the letters of a question leave; null if they do not tell the explanations apart. */
  private Fields parted(List<String> ours, String name, Collection<?> letters) {
    var parts = new TreeMap<String, List<Integer>>();
    for (Object letter : letters) {
      var choice = new Fields().put(READINGS, new Fields().put(name, letter));
      var left = new HashSet<>(situations(spec.format().chosen(header, choice)));
      if (!left.isEmpty() && left.size() < ours.size() && ours.containsAll(left)) {
        parts.put((String) letter, left.stream().map(one -> ours.indexOf(one) + 1).sorted().toList());
      }
    }
    Set<Integer> all = parts.values().stream().flatMap(List::stream).collect(Collectors.toSet());
    if (all.size() < ours.size() || new HashSet<>(parts.values()).size() < 2) {
      return null;
    }
    var numbers = new Fields();
    parts.forEach(numbers::put);
    return numbers;
  }

  /** The situations after the lines; none if they are not possible. */
  private List<String> situations(Fields under) {
    var session = new Session(spec, under);
    for (byte[] line : lines) {
      if (session.feed(line) != null) {
        return List.of();
      }
    }
    return session.situations(MOST).stream().map(Fields::toString).toList();
  }
}
