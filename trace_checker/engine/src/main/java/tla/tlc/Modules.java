package tla.tlc;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Collectors;

import tla.spec.Specification;
import tla.tree.Kept;
import tla.tree.Module;
import tla2sany.drivers.FrontEndException;
import tla2sany.drivers.SANY;
import tla2sany.modanalyzer.SpecObj;
import tla2sany.semantic.ModuleNode;
import util.FilenameToStream;
import util.SimpleFilenameToStream;

/** A specification in a folder, whose modules may stand in folders of it. */
public final class Modules {
  private static final String SUFFIX = ".tla";

  private final Map<String, Path> files;
  private final String root;
  private final FilenameToStream resolver;

  /**
   * @param root the module that extends the others; a configuration of the same name names its initial predicate
   */
  public Modules(Path folder, String root) {
    try (var paths = Files.walk(folder.toAbsolutePath())) {
      files =
          paths
              .filter(path -> path.toString().endsWith(SUFFIX))
              .collect(Collectors.toMap(path -> path.getFileName().toString().replace(SUFFIX, ""), path -> path));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    if (!files.containsKey(root)) {
      throw new IllegalArgumentException("there is no module " + root + " in " + folder);
    }
    this.root = root;
    resolver =
        new SimpleFilenameToStream(
            files.values().stream().map(path -> path.getParent().toString()).distinct().toArray(String[]::new));
  }

  /**
   * The specification, parsed.
   *
   * @throws IllegalArgumentException if the modules cannot be parsed
   */
  public Specification specification(Set<String> times) {
    return specification(parsed(), times);
  }

  /**
   * The specification.
   *
   * @param module its modules, as {@link #parsed} or {@link #kept} gives them
   * @param times names of variables and fields that hold times, as {@link tla.eval.Evaluator} has them
   */
  public Specification specification(Module module, Set<String> times) {
    return new Specification(module, times, new Tlc(files.get(root).getParent(), root, resolver));
  }

  /** The modules in a file that {@link #keep} has written; null if there is no such file. */
  public static Module kept(Path file) {
    try {
      return Kept.read(Files.readAllBytes(file));
    } catch (IOException e) {
      return null;
    }
  }

  /** Writes the modules for {@link #kept}, whole or not at all. */
  public static void keep(Module module, Path file) throws IOException {
    Path made = Files.createTempFile(file.getParent(), "making-", ".tree");
    try {
      Files.write(made, Kept.bytes(module));
      Files.move(made, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } finally {
      Files.deleteIfExists(made);
    }
  }

  /**
   * The modules, parsed.
   *
   * @throws IllegalArgumentException if they cannot be parsed
   */
  public Module parsed() {
    var spec = new SpecObj(files.get(root).resolveSibling(root).toString(), resolver);
    var said = new ByteArrayOutputStream();
    try {
      SANY.frontEndMain(spec, root, new PrintStream(said, true, StandardCharsets.UTF_8));
    } catch (FrontEndException e) {
      throw new IllegalArgumentException("Parsing or semantic analysis failed: " + said, e);
    }
    ModuleNode parsed = spec.getExternalModuleTable().getRootModule();
    if (parsed == null || spec.getParseErrors().isFailure() || spec.getSemanticErrors().isFailure()) {
      throw new IllegalArgumentException("Parsing or semantic analysis failed: " + said);
    }
    var texts = new HashMap<String, Supplier<String>>();
    files.forEach((name, file) -> texts.put(name, () -> text(file)));
    return FromSany.of(parsed, texts);
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return "";
    }
  }
}
