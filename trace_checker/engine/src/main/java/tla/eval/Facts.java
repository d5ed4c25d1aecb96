package tla.eval;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

import tla.tree.AtNode;
import tla.tree.FormalParamNode;
import tla.tree.LetInNode;
import tla.tree.OpApplNode;
import tla.tree.OpArgNode;
import tla.tree.OpDeclNode;
import tla.tree.OpDefNode;
import tla.tree.SemanticNode;
import tla.tree.SymbolNode;

/** The things that an expression depends on, through all operators that it uses. */
final class Facts {
  /** The variables of the specification, by their number. */
  final BitSet variables = new BitSet();

  /** Parameters and bound variables from outside, each once and few; for an {@code @}, the part of its EXCEPT. */
  private final List<Object> free = new ArrayList<>(0);

  /** Whether it refers to the next state. */
  boolean primes;

  /** Whether it has a marked expression ({@link Marks}). */
  boolean marked;

  /** Whether it applies the operator that is watched ({@link Asked}). */
  boolean asks;

  /** The number of its nodes, with the operators that it uses written out. */
  int size = 1;

  private final Collector collector;

  private Facts(Collector collector) {
    this.collector = collector;
  }

  boolean closed() {
    return free.isEmpty() && !primes;
  }

  boolean constant() {
    return closed() && variables.isEmpty();
  }

  private void needs(Object outside) {
    if (!free.contains(outside)) {
      free.add(outside);
    }
  }

  private void add(Facts other) {
    variables.or(other.variables);
    other.free.forEach(this::needs);
    primes |= other.primes;
    marked |= other.marked;
    asks |= other.asks;
    size = Math.min(size + other.size, 1 << 20);
  }

  /** Collects the facts of a specification's expressions, each once. */
  static final class Collector {
    private final Map<OpDeclNode, Integer> variables;
    private final Asked asked;
    private final Set<OpDefNode> underWay = new HashSet<>();

    Collector(Map<OpDeclNode, Integer> variables, Asked asked) {
      this.variables = variables;
      this.asked = asked;
    }

    Facts of(SemanticNode node) {
      Facts facts = known(node);
      if (facts == null) {
        facts = collect(node);
        node.facts = facts;
      }
      return facts;
    }

    /** What this collector has found of a node; null for nothing, whatever another one has. */
    private Facts known(SemanticNode node) {
      return node.facts instanceof Facts facts && facts.collector == this ? facts : null;
    }

    private Facts collect(SemanticNode node) {
      var facts = new Facts(this);
      facts.marked = node.mark != SemanticNode.UNMARKED;
      if (node instanceof OpApplNode apply) {
        application(facts, apply);
      } else if (node instanceof LetInNode let) {
        facts.add(of(let.getBody()));
      } else if (node instanceof AtNode at) {
        facts.needs(at.getExceptComponentRef());
      } else if (node instanceof OpArgNode argument) {
        symbol(facts, argument.getOp());
      }
      return facts;
    }

    private void application(Facts facts, OpApplNode node) {
      String name = node.getOperator().getName();
      if (name.equals("ENABLED")) {
        facts.add(of(node.getArgs()[0]));
        facts.primes = false;
        return;
      }
      for (SemanticNode argument : node.getArgs()) {
        if (argument != null) {
          facts.add(of(argument));
        }
      }
      facts.free.remove(node);
      if (node.getBdedQuantSymbolLists() != null) {
        for (FormalParamNode[] bound : node.getBdedQuantSymbolLists()) {
          for (FormalParamNode each : bound) {
            facts.free.remove(each);
          }
        }
        for (SemanticNode bound : node.getBdedQuantBounds()) {
          facts.add(of(bound));
        }
      }
      facts.primes |= name.equals("'") || name.equals("UNCHANGED");
      symbol(facts, node.getOperator());
    }

    private void symbol(Facts facts, SymbolNode symbol) {
      if (symbol instanceof OpDeclNode declared && variables.containsKey(declared)) {
        facts.variables.set(variables.get(declared));
      } else if (symbol instanceof FormalParamNode) {
        facts.needs(symbol);
      } else if (symbol instanceof OpDefNode definition && definition.isDefined()) {
        facts.marked |= definition.mark != SemanticNode.UNMARKED;
        facts.asks |= asked.isWatched(definition);
        facts.add(of(definition));
      }
    }

    /** The facts of an operator's body, without its parameters. */
    private Facts of(OpDefNode definition) {
      Facts facts = known(definition);
      if (facts == null) {
        if (!underWay.add(definition)) {
          throw new Unsupported("recursive operator " + definition.getName());
        }
        facts = new Facts(this);
        facts.add(of(definition.getBody()));
        for (FormalParamNode parameter : definition.getParams()) {
          facts.free.remove(parameter);
        }
        definition.facts = facts;
        underWay.remove(definition);
      }
      return facts;
    }
  }
}
