package tla.spec;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;

import tla.tree.ExprNode;
import tla.tree.LetInNode;
import tla.tree.Module;
import tla.tree.OpApplNode;
import tla.tree.OpDefNode;
import tla.tree.SemanticNode;

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

  private final Source source;
  private final List<Module.Marked> found = new ArrayList<>();
  private final Set<SemanticNode> seen = Collections.newSetFromMap(new IdentityHashMap<>());
  private final List<OpDefNode> open = new ArrayList<>();

  private Decisions(Source source) {
    this.source = source;
  }

  /**
   * The decisions of these operators and of all definitions that they use; their nodes are marked in the order of
   * the decisions.
   */
  static Decisions of(Set<String> operators, Module module, Source source) {
    var decisions = new Decisions(source);
    if (module.markedFor().equals(operators)) {
      decisions.found.addAll(module.marked());
    } else {
      decisions.find(operators.stream().sorted().map(module::getOpDef).toList());
      module.mark(operators, decisions.found);
    }
    return decisions;
  }

  /** The number of decisions. */
  int size() {
    return found.size();
  }

  private void find(Iterable<OpDefNode> operators) {
    operators.forEach(this::use);
    while (!open.isEmpty()) {
      OpDefNode operator = open.remove(open.size() - 1);
      boolean acts = isAction(operator.getBody());
      if (!operator.isConstant() || operator.getParams().length > 0) {
        found(acts ? Kind.ACTION : Kind.DEFINITION, operator, operator);
      }
      within(operator.getBody(), operator, acts ? Kind.GUARD : Kind.CONDITION);
    }
  }

  /** The decisions, in the order of their nodes. */
  public List<Decision> described() {
    return found.stream().map(this::described).toList();
  }

  private Decision described(Module.Marked one) {
    var at = one.node().getLocation();
    boolean condition = one.node() != one.definition();
    String text = condition ? source.text(one.node()) : "";
    return new Decision(
        Kind.values()[one.kind()],
        at.source(),
        one.definition().getName(),
        at.beginLine(),
        at.beginColumn(),
        text.length() <= LONGEST ? text : text.substring(0, LONGEST - 3) + "...",
        condition ? source.requirementsIn(one.node()) : source.requirementsBefore(one.definition()));
  }

  private static boolean isAction(SemanticNode node) {
    return node instanceof ExprNode expr && expr.isAction();
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
    String name = apply.getOperator().getName();
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
    return name.startsWith("\\") && node instanceof OpApplNode apply && apply.getOperator().getName().equals(name);
  }

  private void found(Kind kind, OpDefNode definition, SemanticNode node) {
    found.add(new Module.Marked(kind.ordinal(), definition, node));
  }

  private void condition(SemanticNode node, OpDefNode definition, Kind kind) {
    boolean literal = node instanceof OpApplNode apply && LITERALS.contains(apply.getOperator().getName());
    if (!literal && seen.add(node)) {
      found(kind, definition, node);
    }
  }
}
