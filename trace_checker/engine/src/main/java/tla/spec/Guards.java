package tla.spec;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

import tla.eval.Evaluator;
import tla.eval.Place;
import tla.tree.ExprOrOpArgNode;
import tla.tree.LetInNode;
import tla.tree.OpApplNode;
import tla.tree.OpDefNode;
import tla.tree.SemanticNode;
import tla.tree.SymbolNode;
import tlc2.value.impl.BoolValue;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.StringValue;
import tlc2.value.impl.Value;

/**
 * Finds why an action is not enabled: the first false conjunct on every way through its definition.
 *
 * <p>It walks the action's own syntax tree with the evaluator, so nothing is said twice, neither
 * here nor in the specification. It tells built-in operators apart by their names, which all
 * versions of SANY share.
 */
public final class Guards {
  /** Ways through one action that are followed. */
  private static final int MOST = 12;

  private static final int LONGEST = 240;
  private static final int LONGEST_VALUE = 60;
  private static final Pattern NUMBER = Pattern.compile("-?\\b[0-9]+\\b");

  /**
   * An action that fails.
   *
   * @param action the operator that comes nearest, with the values of its arguments
   * @param conjunct its first false conjunct, in the words of the specification
   * @param values the operands of the conjunct with their values
   * @param place the module and line of the conjunct
   * @param requirements the requirements that the specification names there
   */
  public record Failure(
      String action, String conjunct, String values, String place, Set<String> requirements) {}

  /** An operator on the way: its definition and the action whose part it is. */
  private record Frame(OpDefNode operator, String action, Frame outer) {}

  private final Evaluator evaluator;
  private final Source source;
  private final Function<RecordValue, String> label;
  private final Function<String, IntFunction<String>> numbers;

  Guards(
      Evaluator evaluator,
      Source source,
      Function<RecordValue, String> label,
      Function<String, IntFunction<String>> numbers) {
    this.evaluator = evaluator;
    this.source = source;
    this.label = label;
    this.numbers = numbers;
  }

  /** The failures of an operator; none if it is enabled, or if the evaluator cannot tell. */
  Set<Failure> of(OpDefNode operator, Place place) {
    var found = walk(operator.getBody(), place, new Frame(operator, operator.getName(), null));
    return new LinkedHashSet<>(found.subList(0, Math.min(found.size(), MOST)));
  }

  /** Empty if the node is not false, or if the evaluator cannot tell. */
  private List<Failure> walk(SemanticNode node, Place place, Frame frame) {
    if (node instanceof LetInNode let) {
      return walk(let.getBody(), place.let(let), frame);
    }
    boolean action = evaluator.isAction(node);
    if (!action && !isFalse(node, place)) {
      return List.of();
    }
    if (!(node instanceof OpApplNode apply)) {
      return action ? List.of() : leaf(node, place, frame);
    }
    ExprOrOpArgNode[] args = apply.getArgs();
    switch (apply.getOperator().getName()) {
      case "$ConjList", "\\land":
        for (ExprOrOpArgNode conjunct : args) {
          List<Failure> failures = walk(conjunct, place, frame);
          if (!failures.isEmpty()) {
            return failures;
          }
        }
        return List.of();
      case "$DisjList", "\\lor":
        return action || hasConjuncts(args)
            ? either(args, place, frame, action)
            : leaf(node, place, frame);
      case "=>":
        return walk(args[1], place, frame);
      case "$IfThenElse":
        return walk(isFalse(args[0], place) ? args[2] : args[1], place, frame);
      case "$Case":
        return ofCase(args, place, frame);
      case "$BoundedExists":
        return action ? exists(apply, place, frame) : leaf(node, place, frame);
      default:
        return ofOperator(apply, place, frame, action);
    }
  }

  private static boolean hasConjuncts(SemanticNode[] disjuncts) {
    for (SemanticNode each : disjuncts) {
      if (each instanceof OpApplNode apply
          && apply.getOperator().getName().matches("\\$ConjList|\\\\land")) {
        return true;
      }
    }
    return false;
  }

  private List<Failure> either(SemanticNode[] args, Place place, Frame frame, boolean action) {
    List<Failure> all = new ArrayList<>();
    for (SemanticNode disjunct : args) {
      List<Failure> failures = walk(disjunct, place, frame);
      if (failures.isEmpty()) {
        return List.of();
      }
      all.addAll(failures);
    }
    // A condition with alternatives: the first is the ordinary one.
    return action ? all : all.subList(0, 1);
  }

  private List<Failure> ofCase(SemanticNode[] args, Place place, Frame frame) {
    for (SemanticNode each : args) {
      ExprOrOpArgNode[] pair = ((OpApplNode) each).getArgs();
      if (pair[0] == null || !isFalse(pair[0], place)) {
        return walk(pair[1], place, frame);
      }
    }
    return List.of();
  }

  private List<Failure> exists(OpApplNode apply, Place place, Frame frame) {
    List<Failure> all = new ArrayList<>();
    boolean any = false;
    for (Place bound : place.each(apply)) {
      any = true;
      List<Failure> failures = walk(apply.getArgs()[0], bound, frame);
      if (failures.isEmpty()) {
        return List.of();
      }
      if (all.size() < MOST) {
        all.addAll(failures);
      }
    }
    if (any) {
      return all;
    }
    SemanticNode bound = apply.getBdedQuantBounds()[0];
    String variable = apply.getBdedQuantSymbolLists()[0][0].getName();
    return List.of(failure(bound, variable + " \\in " + source.text(bound), "the set is empty", frame));
  }

  private List<Failure> ofOperator(OpApplNode apply, Place place, Frame frame, boolean action) {
    SymbolNode symbol = apply.getOperator();
    if (!(symbol instanceof OpDefNode operator) || operator.getBody() == null || !source.has(operator)) {
      return action ? List.of() : leaf(apply, place, frame);
    }
    Place inside = place.inside(operator, apply.getArgs());
    boolean isAction = evaluator.isAction(operator.getBody());
    String name = isAction ? named(operator, apply.getArgs(), place) : frame.action;
    List<Failure> failures = walk(operator.getBody(), inside, new Frame(operator, name, frame));
    return failures.isEmpty() && !action ? leaf(apply, place, frame) : failures;
  }

  private List<Failure> leaf(SemanticNode node, Place place, Frame frame) {
    return List.of(failure(node, source.text(node), values(node, place), frame));
  }

  private Failure failure(SemanticNode node, String text, String values, Frame frame) {
    Set<String> ids = new TreeSet<>(source.requirementsIn(node));
    for (Frame at = frame; at != null && ids.isEmpty(); at = at.outer) {
      ids.addAll(source.requirementsBefore(at.operator));
    }
    return new Failure(frame.action, cut(text, LONGEST), cut(values, LONGEST), source.place(node), ids);
  }

  /** An action with the arguments that a line of text can hold. */
  private String named(OpDefNode operator, ExprOrOpArgNode[] args, Place place) {
    var shown = new ArrayList<String>();
    for (int i = 0; i < args.length; i++) {
      Value value = valueOf(args[i], place);
      if (value instanceof IntValue || value instanceof StringValue) {
        shown.add(spelled(value.toString(), numbers.apply(operator.getParams()[i].getName())));
      } else if (value != null && value.toRcd() instanceof RecordValue record) {
        String name = label.apply(record);
        if (name != null) {
          shown.add(name);
        }
      }
    }
    return operator.getName() + (shown.isEmpty() ? "" : "(" + String.join(", ", shown) + ")");
  }

  /** The operands of a comparison, but for literals; all numbers are spelled as those of one operand are. */
  private String values(SemanticNode node, Place place) {
    if (!(node instanceof OpApplNode apply)) {
      return "";
    }
    var shown = new ArrayList<String>();
    IntFunction<String> spelling = null;
    for (ExprOrOpArgNode arg : apply.getArgs()) {
      spelling = spelling == null ? numbers.apply(source.text(arg)) : spelling;
    }
    for (ExprOrOpArgNode arg : apply.getArgs()) {
      if (!(arg instanceof OpApplNode)) {
        continue;
      }
      Value value = valueOf(arg, place);
      String text = value == null ? "" : value.toString();
      if (!text.isEmpty() && text.length() <= LONGEST_VALUE && !text.equals(source.text(arg))) {
        shown.add(source.text(arg) + " = " + spelled(text, spelling));
      }
    }
    return String.join(", ", shown);
  }

  /** A value's text with its numbers in this spelling; negative ones stand for none and stay, null leaves all. */
  private static String spelled(String value, IntFunction<String> spelling) {
    var text = new StringBuilder();
    int from = 0;
    for (Matcher found = NUMBER.matcher(value); spelling != null && found.find(); from = found.end()) {
      int number = Integer.parseInt(found.group());
      text.append(value, from, found.start()).append(number < 0 ? found.group() : spelling.apply(number));
    }
    return text.append(value.substring(from)).toString();
  }

  private Value valueOf(SemanticNode node, Place place) {
    return place.value(node);
  }

  private boolean isFalse(SemanticNode node, Place place) {
    return valueOf(node, place) instanceof BoolValue truth && !truth.val;
  }

  private static String cut(String text, int longest) {
    return text.length() <= longest ? text : text.substring(0, longest - 3) + "...";
  }
}
