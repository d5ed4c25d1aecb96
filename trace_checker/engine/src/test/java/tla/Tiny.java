package tla;

import java.io.OutputStream;
import java.io.PrintStream;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Set;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import s7.log.Fields;
import tla.spec.Specification;
import tla.tlc.Modules;
import util.ToolIO;

/** The specification of the tests, and JSON for it. */
public final class Tiny {
  private Tiny() {}

  /** Loads the specification; once in each JVM, which is once in each test class. */
  public static Specification load() {
    return modules().specification(Set.of("time", "at"));
  }

  /** The modules of the specification. */
  public static Modules modules() {
    ToolIO.out = new PrintStream(OutputStream.nullOutputStream());
    try {
      var module = Path.of(Tiny.class.getResource("/tiny/Explain.tla").toURI());
      return new Modules(module.getParent(), "Explain");
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  /** An object written with single quotes. */
  public static Fields text(String text) {
    return Fields.of(text.replace('\'', '"').getBytes(StandardCharsets.UTF_8));
  }

  /** An object written with single quotes, as another library has it. */
  public static JsonObject json(String text) {
    return JsonParser.parseString(text.replace('\'', '"')).getAsJsonObject();
  }

  /** An object as it is printed. */
  public static JsonObject json(Fields object) {
    return JsonParser.parseString(object.toString()).getAsJsonObject();
  }
}
