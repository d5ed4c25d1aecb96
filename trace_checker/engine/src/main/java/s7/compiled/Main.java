package s7.compiled;

import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;

import org.teavm.interop.Address;
import org.teavm.interop.Import;
import org.teavm.interop.c.Include;
import s7.log.Fields;
import s7.trace.Contract;
import s7.trace.Engine;
import s7.trace.Handover;
import tla.spec.Interpreter;
import tla.spec.Specification;
import tla.tree.Kept;
import tla.tree.Module;

/** The engine as an executable: the specification is parsed already, and nothing of TLC is there but its values. */
public final class Main {
  private Main() {}

  /**
   * @param args the file of the parsed specification
   */
  public static void main(String[] args) throws IOException {
    useLargePages();
    Module module = args.length == 1 ? Kept.read(file(args[0])) : null;
    if (module == null) {
      throw new IllegalArgumentException("usage: s7-trace-engine FILE-OF-THE-PARSED-SPECIFICATION");
    }
    var engine =
        new Engine(
            () -> new Specification(module, Contract.TIMES, Interpreter.NONE), new Tidy(), answer -> print(answer));
    print(new Fields().put("engine", "ready").toString());
    engine.serve(new StandardInput());
  }

  private static byte[] file(String name) throws IOException {
    try (var in = new FileInputStream(name)) {
      return in.readAllBytes();
    }
  }

  private static void print(String line) {
    byte[] bytes = (line + "\n").getBytes(StandardCharsets.UTF_8);
    write(Address.ofData(bytes), bytes.length);
  }

  /** Reads into a buffer what is there; -1 at the end. */
  @Include(value = "streams.h", isSystem = false)
  @Import(name = "s7_read")
  private static native int read(Address to, int most);

  @Include(value = "streams.h", isSystem = false)
  @Import(name = "s7_write")
  private static native void write(Address from, int count);

  @Include(value = "streams.h", isSystem = false)
  @Import(name = "s7_large_pages")
  private static native void useLargePages();

  @Import(name = "teavm_gc_collect")
  private static native void collect();

  @Import(name = "teavm_gc_collectFull")
  private static native void collectAll();

  /** Collects garbage between items: by itself the collector waits until the heap, whose size is fixed, is full. */
  private static final class Tidy implements Handover {
    /** Bytes after which the garbage of late is collected, and after whose survival all of it is. */
    private static final long SOME = 64 << 20;

    private static final long MUCH = 32 << 20;

    private final long heap = Runtime.getRuntime().totalMemory();
    private long used = used();
    private long needed = used;

    @Override
    public void add(Runnable item) {
      item.run();
      if (used() - used > SOME) {
        collect();
        used = used();
        if (used > 2 * needed + MUCH) {
          collectAll();
          used = used();
          needed = used;
        }
      }
    }

    private long used() {
      return heap - Runtime.getRuntime().freeMemory();
    }
  }

  private static final class StandardInput extends InputStream {
    private final byte[] one = new byte[1];

    @Override
    public int read() {
      return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
    }

    @Override
    public int read(byte[] bytes, int from, int most) {
      return Main.read(Address.ofData(bytes).add(from), most);
    }
  }
}
