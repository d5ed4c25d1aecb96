package s7.jvm;

import java.io.File;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;

import s7.log.Fields;
import s7.trace.Contract;
import s7.trace.Engine;
import tla.tlc.Modules;
import tla.tree.Module;
import tlc2.TLCGlobals;
import util.ToolIO;

/** The engine on a JVM: it parses the specification, has all of TLC, and reads a log while it judges. */
public final class Main {
  /** Exit code of an engine whose parent has ended. */
  private static final int NOBODY_LEFT = 3;

  /** How the folder begins that the parent makes for an engine. */
  private static final String FOLDER = "s7check-engine-";

  private Main() {}

  /**
   * @param args the folder of the specification, and the file in which it is kept when it has been parsed, whose name
   *     has to be another one for other texts
   */
  public static void main(String[] args) throws IOException {
    if (args.length < 1 || args.length > 2) {
      System.err.println("usage: Main FOLDER-OF-THE-SPECIFICATION [FILE]");
      System.exit(2);
    }
    // However it ends: the parent, which removes the folder too, may have been ended with it.
    Runtime.getRuntime().addShutdownHook(new Thread(() -> removeFolder(new File("").getAbsoluteFile())));
    endWithParent();
    // Standard output belongs to the protocol; TLC's own messages go elsewhere.
    var out = new PrintStream(new FileOutputStream(FileDescriptor.out), false, "UTF-8");
    System.setOut(System.err);
    ToolIO.out = System.err;
    ToolIO.setMode(ToolIO.TOOL);
    var modules = new Modules(Path.of(args[0]), Contract.MODULE);
    Path file = args.length < 2 ? null : Path.of(args[1]);
    Module kept = file == null ? null : Modules.kept(file);
    Module module = kept == null ? modules.parsed() : kept;
    var engine =
        new Engine(
            () -> modules.specification(module, Contract.TIMES),
            new Ahead("judging"),
            answer -> {
              out.println(answer);
              out.flush();
            });
    out.println(new Fields().put("engine", "ready").put("tlc", jarOfTlc()));
    out.flush();
    if (file != null && kept == null) {
      keep(module, file);
    }
    engine.serve(new FileInputStream(FileDescriptor.in));
  }

  private static void keep(Module module, Path file) {
    try {
      Modules.keep(module, file);
    } catch (IOException e) {
      // Then it is parsed again.
    }
  }

  /** Ends with the parent, since an engine at work on an event does not see its input end. */
  private static void endWithParent() {
    ProcessHandle.current().parent().ifPresent(parent -> parent.onExit().thenRun(() -> System.exit(NOBODY_LEFT)));
  }

  /** Removes the folder of temporary files that the parent would have removed. */
  private static void removeFolder(File folder) {
    File[] files = folder.listFiles();
    if (folder.getName().startsWith(FOLDER) && files != null) {
      for (File file : files) {
        file.delete();
      }
      folder.delete();
    }
  }

  /** The file name of the TLC at hand; its version is not kept at one place in all releases. */
  private static String jarOfTlc() {
    var source = TLCGlobals.class.getProtectionDomain().getCodeSource();
    return Path.of(source.getLocation().getPath()).getFileName().toString();
  }
}
