package tla;

import java.io.OutputStream;
import java.io.PrintStream;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.Set;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import tla.json.Json;
import tla.spec.Specification;
import util.ToolIO;

/** The specification of the tests, and JSON for it. */
public final class Tiny {
  private Tiny() {}

  /** Loads the specification; once in each JVM, which is once in each test class. */
  public static Specification load() {
    ToolIO.out = new PrintStream(OutputStream.nullOutputStream());
    try {
      var module = Path.of(Tiny.class.getResource("/tiny/Explain.tla").toURI());
      return new Specification(module.getParent(), "Explain", Set.of("time", "at"));
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  /** A text of JSON written with single quotes. */
  public static Json text(String text) {
    return Json.of(text.replace('\'', '"'));
  }

  /** Parses an object written with single quotes. */
  public static JsonObject json(String text) {
    return JsonParser.parseString(text.replace('\'', '"')).getAsJsonObject();
  }
}
