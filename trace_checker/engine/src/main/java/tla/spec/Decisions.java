package tla.spec;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;

import tla2sany.semantic.LetInNode;
import tla2sany.semantic.LevelConstants;
import tla2sany.semantic.LevelNode;
import tla2sany.semantic.OpApplNode;
import tla2sany.semantic.OpDefNode;
import tla2sany.semantic.SemanticNode;

/**
 * The places at which operators decide: the definitions that they use, but for constants, and the
 * conditions in the definitions that they use. A condition is a part of a conjunction or disjunction
 * that is no action, or the condition of an IF or of an arm of a CASE.
 */
public final class Decisions {
  private static final int LONGEST = 120;
  private static final Set<String> LITERALS = Set.of("TRUE", "FALSE");

  /** What a decision is. */
  public enum Kind {
    /** A definition that is an action: taken or not. */
    ACTION,
    /** A definition with a value. */
    DEFINITION,
    /** A condition in a definition that is an action. */
    GUARD,
    /** A condition in a definition with a value. */
    CONDITION
  }

  /**
   * A decision.
   *
   * @param definition the definition that it is, or in which it stands
   * @param column its first column, which tells it apart from others in its line
   * @param requirements the requirements named in the lines of a condition, or before the definition
   */
  public record Decision(
      Kind kind,
      String module,
      String definition,
      int line,
      int column,
      String text,
      Set<String> requirements) {}

  /** A decision before anybody asks for its text. */
  private record Found(Kind kind, OpDefNode definition, SemanticNode node) {}

  private final Source source;
  private final List<Found> found = new ArrayList<>();
  private final Set<SemanticNode> seen = Collections.newSetFromMap(new IdentityHashMap<>());
  private final List<OpDefNode> open = new ArrayList<>();

  Decisions(Source source) {
    this.source = source;
  }

  /** Finds the decisions of these operators and of all definitions that they use. */
  void of(Iterable<OpDefNode> operators) {
    operators.forEach(this::use);
    while (!open.isEmpty()) {
      OpDefNode operator = open.remove(open.size() - 1);
      boolean acts = isAction(operator.getBody());
      if (operator.getLevel() > LevelConstants.ConstantLevel || operator.getParams().length > 0) {
        found.add(new Found(acts ? Kind.ACTION : Kind.DEFINITION, operator, operator));
      }
      within(operator.getBody(), operator, acts ? Kind.GUARD : Kind.CONDITION);
    }
  }

  /** The nodes of the decisions. */
  List<SemanticNode> nodes() {
    return found.stream().map(Found::node).toList();
  }

  /** The decisions, in the order of their nodes. */
  public List<Decision> described() {
    return found.stream().map(this::described).toList();
  }

  private Decision described(Found one) {
    var at = one.node.getLocation();
    boolean condition = one.node != one.definition;
    String text = condition ? source.text(one.node) : "";
    return new Decision(
        one.kind,
        at.source(),
        one.definition.getName().toString(),
        at.beginLine(),
        at.beginColumn(),
        text.length() <= LONGEST ? text : text.substring(0, LONGEST - 3) + "...",
        condition ? source.requirementsIn(one.node) : source.requirementsBefore(one.definition));
  }

  private static boolean isAction(SemanticNode node) {
    return node instanceof LevelNode level && level.getLevel() >= LevelConstants.ActionLevel;
  }

  private void use(OpDefNode operator) {
    if (operator.getBody() != null && source.has(operator) && seen.add(operator)) {
      open.add(operator);
    }
  }

  private void within(SemanticNode node, OpDefNode definition, Kind kind) {
    if (node instanceof LetInNode let) {
      for (OpDefNode each : let.getLets()) {
        within(each.getBody(), definition, kind);
      }
      within(let.getBody(), definition, kind);
    }
    if (!(node instanceof OpApplNode apply)) {
      return;
    }
    String name = apply.getOperator().getName().toString();
    SemanticNode[] args = apply.getArgs();
    switch (name) {
      case "$ConjList", "\\land", "$DisjList", "\\lor" -> {
        for (SemanticNode part : args) {
          if (!isAction(part) && !isNamed(part, name)) {
            condition(part, definition, kind);
          }
        }
      }
      case "$IfThenElse" -> condition(args[0], definition, kind);
      case "$Case" -> {
        for (SemanticNode arm : args) {
          SemanticNode condition = ((OpApplNode) arm).getArgs()[0];
          if (condition != null) {
            condition(condition, definition, kind);
          }
        }
      }
      default -> {
        if (apply.getOperator() instanceof OpDefNode operator) {
          use(operator);
        }
      }
    }
    for (SemanticNode arg : args) {
      if (arg != null) {
        within(arg, definition, kind);
      }
    }
    if (apply.getBdedQuantBounds() != null) {
      for (SemanticNode bound : apply.getBdedQuantBounds()) {
        within(bound, definition, kind);
      }
    }
  }

  /** Whether a part of a chain of operators is the rest of the chain. */
  private static boolean isNamed(SemanticNode node, String name) {
    return name.startsWith("\\") && node instanceof OpApplNode apply && apply.getOperator().getName().toString().equals(name);
  }

  private void condition(SemanticNode node, OpDefNode definition, Kind kind) {
    boolean literal = node instanceof OpApplNode apply && LITERALS.contains(apply.getOperator().getName().toString());
    if (!literal && seen.add(node)) {
      found.add(new Found(kind, definition, node));
    }
  }
}
