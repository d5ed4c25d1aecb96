package tla.spec;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;

import tla.eval.Evaluator;
import tla.eval.State;
import tla.eval.Way;
import tla.tree.FromSany;
import tla.tree.Kept;
import tla.tree.Module;
import tla.tree.OpDefNode;
import tla2sany.drivers.FrontEndException;
import tla2sany.drivers.SANY;
import tla2sany.modanalyzer.SpecObj;
import tla2sany.semantic.ModuleNode;
import tlc2.value.impl.BoolValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;
import util.FilenameToStream;
import util.SimpleFilenameToStream;

/**
 * The operators of a TLA+ module. TLC's parser reads it, {@link Evaluator} evaluates it, and {@link
 * Interpreter}, set up when it is first needed, evaluates the operators that the evaluator leaves to
 * it. With {@code -Dtla.compare=true} both evaluate every operator, and the first difference is an
 * error.
 *
 * <p>Every method throws an IllegalStateException for an operator that the module does not have, and
 * another RuntimeException where TLC cannot evaluate it.
 */
public final class Specification {
  private static final boolean COMPARE = Boolean.getBoolean("tla.compare");

  private final Path file;
  private final String module;
  private final FilenameToStream resolver;
  private final Path kept;
  private final boolean wasKept;
  private final Module root;
  private final Source source;
  private final Evaluator evaluator;
  private final Map<String, OpDefNode> operators = new HashMap<>();
  private Interpreter interpreter;

  /**
   * Parses {@code module}; a configuration of the same name names its initial predicate.
   *
   * @param folder the folder of the modules, which may stand in folders of it
   * @param times names of variables and fields that hold times; see {@link Evaluator}
   * @throws IllegalArgumentException if the modules cannot be parsed
   */
  public Specification(Path folder, String module, Set<String> times) {
    this(folder, module, times, null);
  }

  /**
   * As the other constructor; nothing is parsed if there is a file of these modules.
   *
   * @param kept the file that {@link #keep} writes; it has to have another name for other texts
   */
  public Specification(Path folder, String module, Set<String> times, Path kept) {
    source = new Source(folder.toAbsolutePath());
    file = source.file(module);
    if (file == null) {
      throw new IllegalArgumentException("there is no module " + module + " in " + folder);
    }
    this.module = module;
    this.kept = kept;
    resolver = new SimpleFilenameToStream(source.folders());
    Module known = kept == null ? null : Kept.read(kept);
    wasKept = known != null;
    root = wasKept ? known : FromSany.of(parsed());
    evaluator = new Evaluator(times, root.getVariableDecls());
  }

  private ModuleNode parsed() {
    var spec = new SpecObj(file.resolveSibling(module).toString(), resolver);
    var said = new ByteArrayOutputStream();
    try {
      SANY.frontEndMain(spec, module, new PrintStream(said, true, StandardCharsets.UTF_8));
    } catch (FrontEndException e) {
      throw new IllegalArgumentException("Parsing or semantic analysis failed: " + said, e);
    }
    ModuleNode parsed = spec.getExternalModuleTable().getRootModule();
    if (parsed == null || spec.getParseErrors().isFailure() || spec.getSemanticErrors().isFailure()) {
      throw new IllegalArgumentException("Parsing or semantic analysis failed: " + said);
    }
    return parsed;
  }

  /** Writes the parsed modules for the next time, unless they come from there. */
  public void keep() {
    if (kept != null && !wasKept) {
      try {
        Kept.write(root, kept);
      } catch (IOException e) {
        // Then they are parsed again.
      }
    }
  }

  /** The only state that satisfies the initial predicate {@code name}. */
  public State initialState(String name) {
    return chosen(evaluator.initial(operator(name)), () -> tlc().initial(), new State(), name).get(0);
  }

  /** The successors of {@code state} under the action {@code name}, applied to {@code arguments}. */
  public List<State> successors(String name, State state, Value... arguments) {
    List<State> found = evaluator.successors(operator(name), state, arguments);
    if (found != null && !COMPARE) {
      return found;
    }
    return chosen(found, () -> tlc().successors(name, state, arguments), state, name);
  }

  /** The value of a state function or state predicate. */
  public Value value(String name, State state, Value... arguments) {
    Value found = evaluator.value(operator(name), state, arguments);
    if (found != null && !COMPARE) {
      return found;
    }
    evaluator.missed();
    Value byTlc = tlc().value(name, state, arguments);
    differs(name, found == null, found == null || found.equals(byTlc));
    return byTlc;
  }

  private List<State> chosen(
      List<State> found, Supplier<List<State>> interpreted, State before, String name) {
    if (found != null && !COMPARE) {
      return found;
    }
    evaluator.missed();
    List<State> byTlc = interpreted.get();
    byTlc.forEach(state -> state.follow(before));
    differs(name, found == null, found == null || asSet(found).equals(asSet(byTlc)));
    return byTlc;
  }

  private static void differs(String name, boolean left, boolean same) {
    if (COMPARE && left) {
      System.err.println("left to TLC: " + name);
    }
    if (!same) {
      throw new IllegalStateException("the evaluator and TLC differ in " + name);
    }
  }

  private Set<Value> asSet(List<State> states) {
    var values = new HashSet<Value>();
    int count = root.getVariableDecls().length;
    for (State state : states) {
      var all = new Value[count];
      for (int i = 0; i < count; i++) {
        all[i] = state.value(i);
      }
      values.add(new TupleValue(all));
    }
    return values;
  }

  private Interpreter tlc() {
    if (interpreter == null) {
      interpreter = new Interpreter(file.getParent(), module, resolver);
    }
    return interpreter;
  }

  /** A way through operators of this specification, which goes it faster from its second time on. */
  public Way remembered(Way way) {
    return COMPARE ? way : evaluator.remembered(way);
  }

  /** The value of a state predicate. */
  public boolean holds(String name, State state, Value... arguments) {
    return ((BoolValue) value(name, state, arguments)).val;
  }

  /**
   * The reasons why the action {@code name} is not enabled, as far as its definition shows them.
   *
   * @param label the short text by which a failure names a record that an action is applied to, or
   *     null for none
   */
  public Set<Guards.Failure> failures(
      String name, Function<RecordValue, String> label, State state, Value... arguments) {
    OpDefNode operator = operator(name);
    return new Guards(evaluator, source, label)
        .of(operator, evaluator.place(operator, state, arguments));
  }

  /**
   * A number that is the same for states in which the state function {@code name} has the same value
   * and, as good as certainly, another for others.
   */
  public long key(String name, State state) {
    return evaluator.key(operator(name), state);
  }

  /**
   * Has each state tell which outcomes the decisions of these operators had on the way to it; before the
   * first evaluation.
   *
   * @return the decisions, in the order of the numbers that {@link Evaluator#mark} gives them
   */
  public Decisions tellDecisions(Set<String> names) {
    Decisions decisions = Decisions.of(names, root, source);
    evaluator.mark(decisions.size());
    return decisions;
  }

  /**
   * Watches with which strings, its last arguments, an operator is applied, before the first evaluation. A
   * module without it is not watched.
   */
  public void watch(String name) {
    if (arity(name) > 0) {
      evaluator.watch(operator(name));
    }
  }

  /** Begins a new collection of such strings. */
  public void forgetAsked() {
    evaluator.forgetAsked();
  }

  /** The strings since then; null if there may be others. */
  public Set<String> asked() {
    return evaluator.asked();
  }

  /** A value for which nothing counts as asked. */
  public <T> T aside(Supplier<T> value) {
    return evaluator.aside(value);
  }

  /** The number of parameters of an operator; -1 if the module does not have it. */
  public int arity(String name) {
    OpDefNode found = root.getOpDef(name);
    return found == null ? -1 : found.getArity();
  }

  private OpDefNode operator(String name) {
    OpDefNode known = operators.get(name);
    if (known == null) {
      known = root.getOpDef(name);
      if (known == null) {
        throw new IllegalStateException("the specification has no operator " + name);
      }
      operators.put(name, known);
    }
    return known;
  }
}
