package s7.log;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/** Numbers and names that the format allows: OBs, priority classes that can be set, families, letters of readings. */
final class Tables {
  /** The smallest and the largest number that an OB of the CPU can have. */
  static final int FIRST_OB = 1;

  static final int LAST_OB = 122;

  static final List<Integer> TIME_OF_DAY_OBS = range(10, 17);

  /** OBs that an interrupt line may name. */
  static final Set<Integer> EXTERNAL_OBS =
      union(range(30, 38), range(40, 47), List.of(55, 56, 57, 60, 70, 72), range(80, 87));

  /** The OBs of these whose interrupt line carries a fault id. */
  static final Set<Integer> OBS_WITH_FAULT = Set.of(80, 85);

  /** Families of CPUs that a header may name. */
  static final String[] FAMILIES = {"S7-300", "S7-400", "CPU 318"};

  /** Those whose priority classes can be set [OBS-05]. */
  static final Set<String> FAMILIES_WITH_PRIORITIES = Set.of("S7-400", "CPU 318");

  /** Editions of the manual whose readings a header may ask for together. */
  static final String[] PROFILES = {"1997", "2006", "2010"};

  /** As a priority class: the OB is deselected [OBS-06]. */
  static final int DESELECTED = 0;

  /** OB -> the least and the largest class it can be given [OBS-05]. */
  static final Map<Integer, int[]> SETTABLE_PRIORITIES = settable();

  private static final Set<Integer> THREE_READINGS =
      Set.of(
          1, 3, 4, 5, 6, 14, 15, 19, 28, 34, 38, 39, 45, 47, 48, 49, 50, 52, 53, 54, 55, 57, 60, 61, 67, 68, 70, 79);
  private static final Set<Integer> FOUR_READINGS = Set.of(11, 13, 18, 56, 71, 77);
  private static final int AMBIGUITIES = 79;

  /** Ambiguity -> the letters of its readings. */
  static final Map<String, String[]> READINGS = readings();

  private Tables() {}

  private static List<Integer> range(int first, int last) {
    var numbers = new ArrayList<Integer>();
    for (int number = first; number <= last; number++) {
      numbers.add(number);
    }
    return numbers;
  }

  @SafeVarargs
  private static Set<Integer> union(List<Integer>... parts) {
    var all = new TreeSet<Integer>();
    for (List<Integer> part : parts) {
      all.addAll(part);
    }
    return all;
  }

  private static Map<Integer, int[]> settable() {
    var classes = new LinkedHashMap<Integer, int[]>();
    union(range(10, 17), range(20, 23), range(30, 38), range(40, 47)).forEach(ob -> classes.put(ob, new int[] {2, 23}));
    List.of(70, 72).forEach(ob -> classes.put(ob, new int[] {2, 28}));
    List.of(81, 82, 83, 84, 86, 87).forEach(ob -> classes.put(ob, new int[] {2, 26}));
    classes.put(85, new int[] {24, 26});
    return classes;
  }

  private static Map<String, String[]> readings() {
    var readings = new LinkedHashMap<String, String[]>();
    for (int number = 1; number <= AMBIGUITIES; number++) {
      String letters = FOUR_READINGS.contains(number) ? "abcd" : THREE_READINGS.contains(number) ? "abc" : "ab";
      readings.put("AMB-" + (number < 10 ? "0" : "") + number, letters.split(""));
    }
    return readings;
  }
}
