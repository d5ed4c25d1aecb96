package tla.spec;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;

import tla2sany.semantic.ExprOrOpArgNode;
import tla2sany.semantic.LetInNode;
import tla2sany.semantic.LevelNode;
import tla2sany.semantic.OpApplNode;
import tla2sany.semantic.OpDefNode;
import tla2sany.semantic.SemanticNode;
import tla2sany.semantic.SymbolNode;
import tlc2.tool.EvalControl;
import tlc2.tool.IContextEnumerator;
import tlc2.tool.TLCState;
import tlc2.tool.impl.FastTool;
import tlc2.util.Context;
import tlc2.value.IValue;
import tlc2.value.impl.BoolValue;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.StringValue;
import tlc2.value.impl.Value;

/**
 * Finds why an action is not enabled: the first false conjunct on every way through its definition.
 *
 * <p>It walks the action's own syntax tree with TLC's evaluator, so nothing is said twice, neither
 * here nor in the specification. It tells built-in operators apart by their names, which all
 * versions of SANY share.
 */
public final class Guards {
  /** Ways through one action that are followed. */
  private static final int MOST = 12;

  private static final int LONGEST = 240;
  private static final int LONGEST_VALUE = 60;
  private static final int ACTION_LEVEL = 2;

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

  private final FastTool tool;
  private final Source source;
  private final Function<RecordValue, String> label;
  private final TLCState state;
  private final TLCState none;

  Guards(FastTool tool, Source source, Function<RecordValue, String> label, TLCState state) {
    this.tool = tool;
    this.source = source;
    this.label = label;
    this.state = state;
    this.none = state.createEmpty();
  }

  /** The failures of an operator; none if it is enabled, or if TLC cannot tell. */
  Set<Failure> of(OpDefNode operator, Context context) {
    var found = walk(operator.getBody(), context, new Frame(operator, operator.getName().toString(), null));
    return new LinkedHashSet<>(found.subList(0, Math.min(found.size(), MOST)));
  }

  /** Empty if the node is not false, or if TLC cannot tell. */
  private List<Failure> walk(SemanticNode node, Context context, Frame frame) {
    if (node instanceof LetInNode let) {
      return walk(let.getBody(), context, frame);
    }
    boolean action = ((LevelNode) node).getLevel() >= ACTION_LEVEL;
    if (!action && !isFalse(node, context)) {
      return List.of();
    }
    if (!(node instanceof OpApplNode apply)) {
      return action ? List.of() : leaf(node, context, frame);
    }
    ExprOrOpArgNode[] args = apply.getArgs();
    switch (apply.getOperator().getName().toString()) {
      case "$ConjList", "\\land":
        for (ExprOrOpArgNode conjunct : args) {
          List<Failure> failures = walk(conjunct, context, frame);
          if (!failures.isEmpty()) {
            return failures;
          }
        }
        return List.of();
      case "$DisjList", "\\lor":
        return action || hasConjuncts(args)
            ? either(args, context, frame, action)
            : leaf(node, context, frame);
      case "=>":
        return walk(args[1], context, frame);
      case "$IfThenElse":
        return walk(isFalse(args[0], context) ? args[2] : args[1], context, frame);
      case "$Case":
        return ofCase(args, context, frame);
      case "$BoundedExists":
        return action ? exists(apply, context, frame) : leaf(node, context, frame);
      default:
        return ofOperator(apply, context, frame, action);
    }
  }

  private static boolean hasConjuncts(SemanticNode[] disjuncts) {
    for (SemanticNode each : disjuncts) {
      if (each instanceof OpApplNode apply
          && apply.getOperator().getName().toString().matches("\\$ConjList|\\\\land")) {
        return true;
      }
    }
    return false;
  }

  private List<Failure> either(SemanticNode[] args, Context context, Frame frame, boolean action) {
    List<Failure> all = new ArrayList<>();
    for (SemanticNode disjunct : args) {
      List<Failure> failures = walk(disjunct, context, frame);
      if (failures.isEmpty()) {
        return List.of();
      }
      all.addAll(failures);
    }
    // A condition with alternatives: the first is the ordinary one.
    return action ? all : all.subList(0, 1);
  }

  private List<Failure> ofCase(SemanticNode[] args, Context context, Frame frame) {
    for (SemanticNode each : args) {
      ExprOrOpArgNode[] pair = ((OpApplNode) each).getArgs();
      if (pair[0] == null || !isFalse(pair[0], context)) {
        return walk(pair[1], context, frame);
      }
    }
    return List.of();
  }

  private List<Failure> exists(OpApplNode apply, Context context, Frame frame) {
    List<Failure> all = new ArrayList<>();
    boolean any = false;
    IContextEnumerator each = tool.contexts(apply, context, state, none, EvalControl.Clear);
    for (Context bound = each.nextElement(); bound != null; bound = each.nextElement()) {
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
    String variable = apply.getBdedQuantSymbolLists()[0][0].getName().toString();
    return List.of(failure(bound, variable + " \\in " + source.text(bound), "the set is empty", frame));
  }

  private List<Failure> ofOperator(OpApplNode apply, Context context, Frame frame, boolean action) {
    SymbolNode symbol = apply.getOperator();
    if (!(symbol instanceof OpDefNode operator) || operator.getBody() == null || !source.has(operator)) {
      return action ? List.of() : leaf(apply, context, frame);
    }
    Context inside = tool.getOpContext(operator, apply.getArgs(), context, true);
    boolean isAction = ((LevelNode) operator.getBody()).getLevel() >= ACTION_LEVEL;
    String name = isAction ? named(operator, apply.getArgs(), context) : frame.action;
    List<Failure> failures = walk(operator.getBody(), inside, new Frame(operator, name, frame));
    return failures.isEmpty() && !action ? leaf(apply, context, frame) : failures;
  }

  private List<Failure> leaf(SemanticNode node, Context context, Frame frame) {
    return List.of(failure(node, source.text(node), values(node, context), frame));
  }

  private Failure failure(SemanticNode node, String text, String values, Frame frame) {
    Set<String> ids = new TreeSet<>(source.requirementsIn(node));
    for (Frame at = frame; at != null && ids.isEmpty(); at = at.outer) {
      ids.addAll(source.requirementsBefore(at.operator));
    }
    return new Failure(frame.action, cut(text, LONGEST), cut(values, LONGEST), source.place(node), ids);
  }

  /** An action with the arguments that a line of text can hold. */
  private String named(OpDefNode operator, ExprOrOpArgNode[] args, Context context) {
    var shown = new ArrayList<String>();
    for (ExprOrOpArgNode arg : args) {
      Value value = valueOf(arg, context);
      if (value instanceof IntValue || value instanceof StringValue) {
        shown.add(value.toString());
      } else if (value != null && value.toRcd() instanceof RecordValue record) {
        String name = label.apply(record);
        if (name != null) {
          shown.add(name);
        }
      }
    }
    return operator.getName() + (shown.isEmpty() ? "" : "(" + String.join(", ", shown) + ")");
  }

  /** The operands of a comparison, but for literals. */
  private String values(SemanticNode node, Context context) {
    if (!(node instanceof OpApplNode apply)) {
      return "";
    }
    var shown = new ArrayList<String>();
    for (ExprOrOpArgNode arg : apply.getArgs()) {
      if (!(arg instanceof OpApplNode)) {
        continue;
      }
      Value value = valueOf(arg, context);
      String text = value == null ? "" : value.toString();
      if (!text.isEmpty() && text.length() <= LONGEST_VALUE && !text.equals(source.text(arg))) {
        shown.add(source.text(arg) + " = " + text);
      }
    }
    return String.join(", ", shown);
  }

  private Value valueOf(SemanticNode node, Context context) {
    if (node instanceof LevelNode level && level.getLevel() >= ACTION_LEVEL) {
      return null;
    }
    try {
      IValue value = tool.eval(node, context, state, none, EvalControl.Clear);
      return (Value) value;
    } catch (RuntimeException e) {
      return null;
    }
  }

  private boolean isFalse(SemanticNode node, Context context) {
    return valueOf(node, context) instanceof BoolValue truth && !truth.val;
  }

  private static String cut(String text, int longest) {
    return text.length() <= longest ? text : text.substring(0, longest - 3) + "...";
  }
}
