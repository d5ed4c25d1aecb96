package tla.spec;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.regex.Pattern;

import tla.tree.Location;
import tla.tree.Module;
import tla.tree.SemanticNode;

/** The text of the specification's modules. */
final class Source {
  /** Such as {@code [AIRT-03]}, and ranges such as {@code [TINT-72] .. [TINT-79]}. */
  private static final Pattern REQUIREMENT =
      Pattern.compile("\\[([A-Z]+[0-9]*-)([0-9]+)\\](?:\\s*\\.\\.\\s*\\[\\1([0-9]+)\\])?");

  private final Map<String, Supplier<String>> texts;
  private final Map<String, List<String>> modules = new HashMap<>();

  Source(Module module) {
    texts = module.texts();
  }

  /** Whether the node stands in a module of the specification, not in one of TLA+'s own. */
  boolean has(SemanticNode node) {
    return texts.containsKey(node.getLocation().source());
  }

  /** The text of a node in one line, without comments. */
  String text(SemanticNode node) {
    Location at = node.getLocation();
    List<String> lines = lines(at.source());
    var text = new StringBuilder();
    for (int i = at.beginLine(); i <= at.endLine() && i <= lines.size(); i++) {
      String line = lines.get(i - 1);
      line = line.substring(0, i == at.endLine() ? Math.min(at.endColumn(), line.length()) : line.length());
      line = i == at.beginLine() ? line.substring(at.beginColumn() - 1) : line;
      text.append(line.replaceAll("\\\\\\*.*|\\(\\*.*?\\*\\)", "")).append(' ');
    }
    return text.toString().strip().replaceAll("\\s+", " ");
  }

  /** Such as {@code Requests:124}. */
  String place(SemanticNode node) {
    return node.getLocation().source() + ":" + node.getLocation().beginLine();
  }

  /** The requirements named in the comment before the definition {@code node}. */
  Set<String> requirementsBefore(SemanticNode node) {
    List<String> lines = lines(node.getLocation().source());
    int last = node.getLocation().beginLine() - 2;
    int first = last;
    while (first >= 0 && lines.get(first).strip().matches("\\(\\*.*\\*\\)|\\\\\\*.*")) {
      first--;
    }
    return requirements(String.join("\n", lines.subList(first + 1, Math.max(first, last) + 1)));
  }

  /** The requirements named in the comments in the lines of {@code node}. */
  Set<String> requirementsIn(SemanticNode node) {
    Location at = node.getLocation();
    List<String> lines = lines(at.source());
    return requirements(
        String.join("\n", lines.subList(at.beginLine() - 1, Math.min(at.endLine(), lines.size()))));
  }

  private static Set<String> requirements(String text) {
    var found = new TreeSet<String>();
    var matcher = REQUIREMENT.matcher(text);
    while (matcher.find()) {
      int first = Integer.parseInt(matcher.group(2));
      int last = matcher.group(3) == null ? first : Integer.parseInt(matcher.group(3));
      for (int number = first; number <= last; number++) {
        found.add(matcher.group(1) + (number < 10 ? "0" : "") + number);
      }
    }
    return found;
  }

  private List<String> lines(String module) {
    return modules.computeIfAbsent(
        module, name -> texts.containsKey(name) ? Arrays.asList(texts.get(name).get().split("\r?\n")) : List.of());
  }
}
