import at.forsyte.apalache.tla.Tool;
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;

/** Runs Apalache once for each line of standard input, its arguments with tabs between them; says each exit code. */
public final class Runs {
  public static void main(String[] none) throws Exception {
    var lines = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (var line = lines.readLine(); line != null; line = lines.readLine()) {
      int code = Tool.run(line.split("\t"));
      System.out.println("\n@!@!@EXIT " + code);
    }
    System.exit(0);
  }
}
