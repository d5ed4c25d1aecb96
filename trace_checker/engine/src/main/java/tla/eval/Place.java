package tla.eval;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;

import tla.tree.ExprOrOpArgNode;
import tla.tree.LetInNode;
import tla.tree.OpApplNode;
import tla.tree.OpDefNode;
import tla.tree.SemanticNode;
import tlc2.value.impl.Value;

/**
 * A place inside an operator, in a state: all names there have values. It takes definitions apart for
 * a report, where speed does not matter.
 */
public final class Place {
  private final Evaluator evaluator;
  private final State state;
  private final Scope scope;
  private final Object[] known;

  Place(Evaluator evaluator, State state, Scope scope, Object[] known) {
    this.evaluator = evaluator;
    this.state = state;
    this.scope = scope;
    this.known = known;
  }

  /** The value of an expression; null if it has none, or if it refers to the next state. */
  public Value value(SemanticNode node) {
    BitSet asked = evaluator.machine.asked.collection();
    try {
      if (evaluator.compiler.primes(node)) {
        return null;
      }
      Expr expr = evaluator.compiler.compile(node, scope);
      evaluator.machine.load(state);
      return expr.eval(frame());
    } catch (RuntimeException e) {
      evaluator.machine.asked.drop(asked);
      return null;
    }
  }

  /** Inside a LET. */
  public Place let(LetInNode let) {
    return at(evaluator.compiler.let(let, scope, new ArrayList<>()));
  }

  /** Inside the body of an operator that is applied here. */
  public Place inside(OpDefNode operator, ExprOrOpArgNode[] arguments) {
    return at(evaluator.compiler.inlined(operator, arguments, scope, new ArrayList<>()));
  }

  /** Inside a quantifier, once for each choice of its variables. */
  public List<Place> each(OpApplNode quantifier) {
    var bounds = new ArrayList<Quantifiers.Bound>();
    Scope inner = new Quantifiers(evaluator.compiler).bind(quantifier, scope, bounds);
    var places = new ArrayList<Place>();
    evaluator.machine.load(state);
    Quantifiers.each(
        bounds.toArray(Quantifiers.Bound[]::new),
        0,
        frame(),
        frame -> {
          places.add(new Place(evaluator, state, inner, frame.clone()));
          return true;
        });
    return places;
  }

  private Place at(Scope inner) {
    return new Place(evaluator, state, inner, known);
  }

  /** A frame with the bound variables; lazy definitions have no values yet. */
  private Object[] frame() {
    return Arrays.copyOf(known, scope.slots.count());
  }
}
