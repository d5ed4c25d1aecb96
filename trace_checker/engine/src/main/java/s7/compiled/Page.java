package s7.compiled;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

import org.teavm.jso.JSExport;
import s7.trace.Contract;
import s7.trace.Engine;
import s7.trace.Handover;
import tla.spec.Interpreter;
import tla.spec.Specification;
import tla.tree.Kept;
import tla.tree.Module;

/** The engine in a page: messages and bytes in, lines out, with the protocol of the executable. */
public final class Page {
  private static final List<String> ANSWERS = new ArrayList<>();
  private static Engine engine;

  private Page() {}

  /** For the compiler, which begins there. */
  public static void main(String[] args) {}

  /**
   * Begins with the parsed specification.
   *
   * @throws IllegalArgumentException for bytes that are none
   */
  @JSExport
  public static void open(byte[] specification) throws IOException {
    Module module = Kept.read(specification);
    if (module == null) {
      throw new IllegalArgumentException("the parsed specification is damaged");
    }
    engine = new Engine(() -> new Specification(module, Contract.TIMES, Interpreter.NONE), new AtOnce(), ANSWERS::add);
  }

  /**
   * Takes messages, with the bytes that belong to them.
   *
   * @return the answers, each a line
   */
  @JSExport
  public static String ask(byte[] messages) throws IOException {
    ANSWERS.clear();
    engine.serve(new ByteArrayInputStream(messages));
    return String.join("\n", ANSWERS);
  }

  /** Nothing is read ahead. */
  private static final class AtOnce implements Handover {
    @Override
    public void add(Runnable item) {
      item.run();
    }
  }
}
