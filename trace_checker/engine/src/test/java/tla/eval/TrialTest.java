package tla.eval;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.IntStream;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class TrialTest {
  private static final int INPUTS = 90_000;

  /** How many of many inputs are looked for where one of so many is known. */
  private static long looksFor(Trial trial, int oneOf) {
    return IntStream.range(0, INPUTS)
        .filter(
            i -> {
              boolean on = trial.isOn();
              if (on) {
                trial.found(i % oneOf == 0);
              }
              return on;
            })
        .count();
  }

  @Test
  @DisplayName("Where few inputs come again, it looks for a few of them and goes on trying")
  void few() {
    long looks = looksFor(new Trial(), 10);
    assertTrue(looks > INPUTS / 10 && looks < INPUTS / 5, () -> "it looked for " + looks);
  }

  @Test
  @DisplayName("Where many come again, it looks for all, also after a time with few")
  void many() {
    var trial = new Trial();
    assertEquals(INPUTS, looksFor(trial, 2));
    looksFor(trial, 10);
    looksFor(trial, 2);
    assertEquals(INPUTS, looksFor(trial, 2));
  }
}
