package s7;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/**
 * The core is plain Java, of which {@code TeaVM} makes executables: no files, threads, processes, reflection or parser.
 * The packages {@code tla.tlc}, {@code s7.jvm} and {@code s7.compiled} are around it.
 */
class BoundaryTest {
  private static final Path CLASSES = Path.of("target", "classes");

  private static final List<String> CORE = List.of("tla.tree", "tla.eval", "tla.spec", "s7.log", "s7.importing", "s7.trace");

  /** Packages, and classes of others, that the core may use beside itself. */
  private static final Pattern ALLOWED =
      Pattern.compile(
          "(java\\.util(\\.function|\\.regex|\\.stream)?|java\\.math|java\\.lang\\.runtime|tlc2\\.value\\.impl)\\.[^.]+"
              + "|java\\.io\\.(ByteArrayOutputStream|InputStream|IOException|EOFException)"
              + "|java\\.nio\\.(ByteBuffer|charset\\.(Charset|StandardCharsets))"
              + "|java\\.util\\.zip\\.CRC32|tlc2\\.util\\.FP64|tlc2\\.tool\\.FingerprintException|util\\.UniqueString"
              + "|java\\.lang\\.(?!Thread|Process|Runtime$|Class(Loader|Value)|reflect|ref\\.)[^.]+"
              + "|java\\.lang\\.invoke\\.(StringConcatFactory|LambdaMetafactory|MethodHandles|MethodHandles\\$Lookup"
              + "|MethodHandle|MethodType|CallSite|TypeDescriptor)");

  private static final Pattern FOREIGN = Pattern.compile("String\\.format\\(|\\.formatted\\(|System\\.(?!arraycopy)");

  @Test
  @DisplayName("the core uses nothing that an executable does not have")
  void core() {
    var said = new StringWriter();
    ToolProvider.findFirst("jdeps")
        .orElseThrow()
        .run(new PrintWriter(said), new PrintWriter(said), "-verbose:class", "--ignore-missing-deps", CLASSES.toString());
    var foreign = new TreeSet<String>();
    var seen = new TreeSet<String>();
    for (String line : said.toString().split("\n")) {
      String[] words = line.strip().split("\\s+");
      if (line.startsWith(" ") && words[1].equals("->") && isCore(words[0])) {
        seen.add(packageOf(words[0]));
        if (!isCore(words[2]) && !ALLOWED.matcher(words[2]).matches()) {
          foreign.add(words[0] + " -> " + words[2]);
        }
      }
    }
    assertEquals(Set.of(), foreign);
    assertEquals(Set.of(), missing(seen));
  }

  @Test
  @DisplayName("the core knows no system, and formats no text by patterns, which are much to compile")
  void texts() throws IOException {
    try (var files = Files.walk(Path.of("src", "main", "java"))) {
      var found = new TreeSet<String>();
      for (Path file : files.filter(each -> each.toString().endsWith(".java")).toList()) {
        String text = Files.readString(file);
        if (CORE.stream().anyMatch(each -> text.startsWith("package " + each + ";"))
            && FOREIGN.matcher(text).find()) {
          found.add(file.toString());
        }
      }
      assertEquals(Set.of(), found);
    }
  }

  private static Set<String> missing(Set<String> packages) {
    var missing = new TreeSet<>(CORE);
    missing.removeAll(packages);
    return missing;
  }

  private static boolean isCore(String name) {
    return CORE.contains(packageOf(name));
  }

  private static String packageOf(String name) {
    return name.substring(0, Math.max(0, name.lastIndexOf('.')));
  }
}
