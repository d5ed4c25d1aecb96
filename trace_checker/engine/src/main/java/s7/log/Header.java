package s7.log;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;

/** The header, the first line of a log. */
final class Header {
  static final String FORMAT = "s7-interrupt-log/1";

  private static final String PROFILE = "profile";
  private static final String READINGS = "readings";
  private static final String PRIORITY = "priority";
  static final String CPU = "cpu";
  private static final String START = "start";
  private static final String EXECUTION = "execution";
  private static final String NEVER = "none";
  private static final int DEFAULT_LATENCY = 10;

  /** How the names of files with a profile end. */
  private static final String ENDING = ".json";

  /** Normalised start of an interrupt to which STEP 7 gives no date. */
  private static final int NO_START = -1;

  /** As a priority class: the OB is deselected [OBS-06]. */
  private static final long CLASS_OF_DESELECTED = 0;

  private static final String DESELECTED = "deselected";
  private static final String ZONE = "zone";

  /** Minutes by which local time may be behind or ahead of system time. */
  private static final int WEST = -720;

  private static final int EAST = 840;

  private static final String[] KINDS = {"call", "ob", "clock", "mode", "interrupt", "load", "diag", "state"};
  private static final List<String> DEFAULT_KINDS = List.of("call", "ob", "clock", "mode", "interrupt", "load");

  static final Reader MODE = Spellings.choice("STOP", "STARTUP", "RUN");

  private static final Table TIME_OF_DAY =
      new Table(
          "a time-of-day interrupt",
          Map.of(),
          Table.of(
              EXECUTION,
              Spellings.choice(
                  NEVER, "once", "minute", "hourly", "daily", "weekly", "monthly", "yearly", "end_of_month"),
              START,
              (Reader) Spellings::minute,
              "active",
              Spellings.TRUTH,
              DESELECTED,
              Spellings.TRUTH));

  private static final Table TIME_DELAY =
      new Table("a time-delay interrupt", Map.of(), Table.of(DESELECTED, Spellings.TRUTH));

  private final List<String> settable;
  private final List<String> local;
  private final Map<String, TreeSet<Long>> unknown;
  private final Map<String, Table> headers = new HashMap<>();
  private final Map<String, TreeMap<Long, TreeSet<Long>>> classes;

  Header(Words words) {
    settable = words.settable;
    local = words.local;
    unknown = words.unknown;
    classes = words.classes;
    for (String family : words.families) {
      headers.put(family, header(words, classes.get(family)));
    }
  }

  private static Table header(Words words, TreeMap<Long, TreeSet<Long>> classes) {
    return new Table(
            "header",
            Table.of(
                "format",
                Spellings.choice(FORMAT),
                CPU,
                Spellings.choice(words.families),
                "obs",
                Table.list(Spellings.integer(words.obs.first(), words.obs.last())),
                "clock",
                (Reader) Spellings::moment),
            Table.of(
                "mode",
                MODE,
                "latency_ms",
                Spellings.integer(0, Integer.MAX_VALUE),
                ZONE,
                Spellings.integer(WEST, EAST),
                "records",
                Table.list(Spellings.choice(KINDS)),
                "cycle",
                Spellings.TRUTH,
                PRIORITY,
                priorities(classes),
                "step7",
                Table.mapping(
                    "the fields tod and dint",
                    Map.of(
                        "tod",
                        parameters(words.timeOfDayObs, TIME_OF_DAY),
                        "dint",
                        parameters(words.timeDelayObs, TIME_DELAY))),
                READINGS,
                readings(words.letters),
                PROFILE,
                Spellings.choice(words.profiles)));
  }

  private static Reader priorities(Map<Long, TreeSet<Long>> settable) {
    var readers = new LinkedHashMap<String, Reader>();
    settable.forEach((ob, classes) -> readers.put(String.valueOf(ob), priority(classes)));
    return Table.mapping("an OB whose class can be set, " + Quoting.ranges(settable.keySet()) + ",", readers);
  }

  private static Reader priority(TreeSet<Long> classes) {
    long lowest = classes.higher(CLASS_OF_DESELECTED);
    String deselected = classes.contains(CLASS_OF_DESELECTED) ? " or " + CLASS_OF_DESELECTED + " (deselected)" : "";
    String expected = "a class " + lowest + ".." + classes.last() + deselected;
    return value -> {
      if (value instanceof Long level && classes.contains(level)) {
        return value;
      }
      throw new Unusable(expected, Quoting.quote(value));
    };
  }

  private static Reader parameters(TreeSet<Long> obs, Table fields) {
    var readers = new LinkedHashMap<String, Reader>();
    obs.forEach(ob -> readers.put(String.valueOf(ob), value -> parametersOfOne(fields.read(value))));
    return Table.mapping("an OB " + Quoting.ranges(obs), readers);
  }

  private static Reader readings(TreeMap<String, TreeSet<String>> letters) {
    var readers = new LinkedHashMap<String, Reader>();
    letters.forEach((name, those) -> readers.put(name, Spellings.choice(those)));
    return Table.mapping("an ambiguity \"" + letters.firstKey() + "\"..\"" + letters.lastKey() + "\"", readers);
  }

  /** STEP 7's parameters of one interrupt, defaults filled in. */
  private static Object parametersOfOne(Fields given) {
    var normalised = new Fields();
    normalised.put(EXECUTION, or(given, EXECUTION, NEVER));
    normalised.put(START, or(given, START, NO_START));
    normalised.put("active", or(given, "active", false));
    normalised.put(DESELECTED, or(given, DESELECTED, false));
    if (!normalised.get(EXECUTION).equals(NEVER) && !given.has(START)) {
      throw new Unusable("with execution " + Quoting.quote(normalised.get(EXECUTION)), "none", START);
    }
    return normalised;
  }

  private static Object or(Fields given, String name, Object otherwise) {
    return given.has(name) ? given.get(name) : otherwise;
  }

  /**
   * The normalised header of the object in a log's first line, every default filled in. Maps become lists of pairs,
   * {@code step7} a list of records with their {@code ob}.
   *
   * @param file the file beside the log that may hold the letters of the profile; null if there is none
   */
  Fields read(Fields line, ProfileFile file) {
    Fields raw = withProfileFile(line, file);
    if (!raw.has("format") && raw.has(Events.EVENT)) {
      throw new Unusable("the header in the first line", "the event " + Quoting.quote(raw.get(Events.EVENT)));
    }
    Object family = raw.get(CPU);
    Fields given = headers.getOrDefault(family instanceof String name ? name : "", headers.get(settable.get(0))).read(raw);
    if (given.has(PRIORITY) && !settable.contains(given.get(CPU))) {
      throw new Unusable("on " + String.join(" and ", settable) + " only", "on " + given.get(CPU), PRIORITY);
    }
    if (given.has(ZONE) && !local.contains(given.get(CPU))) {
      throw new Unusable("on " + String.join(" and ", local) + " only", "on " + given.get(CPU), ZONE);
    }
    for (Object ob : (List<?>) given.get("obs")) {
      if (unknown.get(given.get(CPU)).contains(ob)) {
        throw new Unusable("an OB that an " + given.get(CPU) + " has", "OB " + ob, "obs");
      }
    }
    var normalised = new Fields();
    normalised.put(CPU, given.get(CPU));
    normalised.put("obs", new ArrayList<>(new TreeSet<>((List<?>) given.get("obs"))));
    normalised.put("clock", given.get("clock"));
    normalised.put("mode", or(given, "mode", "STOP"));
    normalised.put("latency", or(given, "latency_ms", DEFAULT_LATENCY));
    normalised.put(ZONE, or(given, ZONE, 0));
    normalised.put("cycle", or(given, "cycle", false));
    normalised.put(PRIORITY, pairs(given.get(PRIORITY), true));
    normalised.put("step7", step7(given.get("step7")));
    normalised.put(READINGS, pairs(given.get(READINGS), false));
    normalised.put(PROFILE, or(given, PROFILE, ""));
    normalised.put("records", or(given, "records", DEFAULT_KINDS));
    return normalised;
  }

  private static List<Object> pairs(Object map, boolean ofNumbers) {
    var pairs = new ArrayList<Object>();
    if (map instanceof Fields fields) {
      for (int i = 0; i < fields.size(); i++) {
        String name = fields.name(i);
        pairs.add(List.of(ofNumbers ? (Object) Integer.valueOf(name) : name, fields.value(i)));
      }
    }
    return pairs;
  }

  private static List<Object> step7(Object kinds) {
    var records = new ArrayList<Object>();
    if (kinds instanceof Fields step7) {
      for (int n = 0; n < step7.size(); n++) {
        var fields = (Fields) step7.value(n);
        for (int i = 0; i < fields.size(); i++) {
          var record = new Fields().put("ob", Integer.valueOf(fields.name(i)));
          var parameters = (Fields) fields.value(i);
          for (int k = 0; k < parameters.size(); k++) {
            record.put(parameters.name(k), parameters.value(k));
          }
          records.add(record);
        }
      }
    }
    return records;
  }

  /** A header whose profile is a file beside the log: its letters come behind those of {@code readings}. */
  private static Fields withProfileFile(Fields header, ProfileFile file) {
    boolean hasReadings = header.get(READINGS) instanceof Fields;
    if (!(header.get(PROFILE) instanceof String name) || !name.endsWith(ENDING)
        || !hasReadings && header.has(READINGS)) {
      return header;
    }
    if (name.indexOf('/') >= 0 || name.indexOf('\\') >= 0) {
      throw new Unusable("an edition, or a file in the folder of the log", Quoting.quote(name), PROFILE);
    }
    Fields letters = letters(name, file);
    Fields rest = header.without(PROFILE);
    if (hasReadings) {
      var own = (Fields) header.get(READINGS);
      for (int i = 0; i < own.size(); i++) {
        letters.put(own.name(i), own.value(i));
      }
    }
    return rest.put(READINGS, letters);
  }

  private static Fields letters(String name, ProfileFile file) {
    if (file == null || file.missing() != null) {
      String why = file == null ? "no folder" : file.missing();
      throw new Unusable("the file of a profile beside the log", Quoting.quote(name) + ": " + why, PROFILE);
    }
    try {
      return Fields.of(file.text());
    } catch (Unusable wrong) {
      throw wrong.inside(PROFILE);
    }
  }

  /** Take away what the family of the header does not have: OBs, and priority classes that cannot be set. */
  private void fit(Fields normalised) {
    Object family = normalised.get(CPU);
    TreeMap<Long, TreeSet<Long>> classes = this.classes.getOrDefault(family, new TreeMap<>());
    normalised.put(
        PRIORITY,
        ((List<?>) normalised.get(PRIORITY))
            .stream()
                .filter(pair -> settable.contains(family) && isClass((List<?>) pair, classes))
                .toList());
    TreeSet<Long> gone = unknown.getOrDefault(family, new TreeSet<>());
    normalised.put("obs", ((List<?>) normalised.get("obs")).stream().filter(ob -> !gone.contains(ob)).toList());
  }

  private static boolean isClass(List<?> pair, TreeMap<Long, TreeSet<Long>> classes) {
    TreeSet<Long> those = classes.get(((Number) pair.get(0)).longValue());
    return those != null && those.contains(((Number) pair.get(1)).longValue());
  }

  /**
   * A normalised header with other choices.
   *
   * @param chosen {@code cpu}, {@code profile} and {@code readings}, an object, as far as they are other ones; a letter
   *     takes the place of the header's for this ambiguity
   */
  Fields chosen(Fields normalised, Fields chosen) {
    for (String name : new String[] {CPU, PROFILE}) {
      if (chosen.has(name)) {
        normalised.put(name, chosen.get(name));
      }
    }
    if (chosen.has(CPU)) {
      fit(normalised);
    }
    var letters = new Fields();
    for (Object pair : (List<?>) normalised.get(READINGS)) {
      letters.put((String) ((List<?>) pair).get(0), ((List<?>) pair).get(1));
    }
    if (chosen.get(READINGS) instanceof Fields others) {
      for (int i = 0; i < others.size(); i++) {
        letters.put(others.name(i), others.value(i));
      }
    }
    return normalised.put(READINGS, pairs(letters, false));
  }
}
