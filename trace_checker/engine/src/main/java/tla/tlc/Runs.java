package tla.tlc;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import tlc2.TLC;
import tlc2.output.EC;
import util.FileUtil;
import util.SimpleFilenameToStream;

/**
 * Runs TLC once for each line of standard input, in one JVM: a short run is mostly the start of
 * Java and code that is not compiled yet.
 *
 * <p>A line has the folders of modules, then TLC's arguments, with tabs between them. Behind the
 * output of a run stands {@code @!@!@EXIT} with the exit code that TLC by itself would have.
 *
 * <p>TLC keeps much in static fields, such as the places of variables in a state. So the runs of
 * one JVM must be of one model, its changes aside, without liveness.
 */
public final class Runs {
  private Runs() {}

  public static void main(String[] none) throws Exception {
    var lines = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (var line = lines.readLine(); line != null; line = lines.readLine()) {
      var parts = line.split("\t");
      System.setProperty("TLA-Library", parts[0]);
      var code = run(Arrays.copyOfRange(parts, 1, parts.length));
      System.out.println("\n@!@!@EXIT " + code);
      System.out.flush();
    }
    // TLC leaves threads behind that would keep the JVM alive.
    System.exit(0);
  }

  /** What {@code TLC.main} does, without the end of the JVM. */
  private static int run(String[] arguments) throws IOException {
    var tlc = new TLC();
    if (!tlc.handleParameters(arguments)) {
      return 1;
    }
    var folder = FileUtil.parseDirname(tlc.getMainFile());
    tlc.setResolver(
        folder.isEmpty() ? new SimpleFilenameToStream() : new SimpleFilenameToStream(folder));
    return EC.ExitStatus.errorConstantToExitStatus(tlc.process());
  }
}
