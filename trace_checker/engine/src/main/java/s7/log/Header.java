package s7.log;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
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
  private static final String LOCAL = "local";
  private static final String CLASSES = "classes";
  private static final String CYCLIC = "cyclic";
  private static final String QUEUE = "queue";
  private static final String EVENTS = "events";
  private static final String THRESHOLD = "threshold";
  private static final String OVERFLOW = "overflow";
  private static final int LONGEST_QUEUE = 12;

  /** Minutes by which local time may be behind or ahead of system time. */
  private static final int WEST = -720;

  private static final int EAST = 840;

  static final Reader MINUTES = Spellings.integer(WEST, EAST);

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
              Spellings.TRUTH,
              LOCAL,
              Spellings.TRUTH));

  private static final Table QUEUE_OF_ONE =
      new Table(
          "a queue",
          Table.of(EVENTS, Spellings.integer(1, LONGEST_QUEUE)),
          Table.of(THRESHOLD, Spellings.integer(1, LONGEST_QUEUE), OVERFLOW, Spellings.TRUTH_NUMBER));

  private static final Table TIME_DELAY =
      new Table("a time-delay interrupt", Map.of(), Table.of(DESELECTED, Spellings.TRUTH));

  private final Words words;
  private final List<String> settable;
  private final List<String> local;
  private final Map<String, TreeSet<Long>> unknown;
  private final Map<String, Table> headers = new HashMap<>();
  private final Map<String, TreeMap<Long, TreeSet<Long>>> classes;

  Header(Words words) {
    this.words = words;
    settable = words.settable;
    local = words.local;
    unknown = words.unknown;
    classes = words.classes;
    for (String family : words.families) {
      headers.put(family, header(words, classes.get(family), Map.of()));
    }
  }

  /**
   * @param settable OB -> the priority classes it can be given
   * @param numbered the OBs from 123 on -> their event class
   */
  private static Table header(Words words, Map<Long, TreeSet<Long>> settable, Map<Long, String> numbered) {
    var classes = new TreeMap<>(settable);
    var timeOfDay = new TreeSet<>(words.timeOfDayObs);
    var queued = new TreeSet<>(words.queuedObs);
    numbered.forEach(
        (ob, name) -> {
          long first = words.eventClasses.get(name).get(0);
          if (settable.containsKey(first)) {
            classes.put(ob, settable.get(first));
          }
          if (words.timeOfDayObs.contains(first)) {
            timeOfDay.add(ob);
          }
          if (words.queuedObs.contains(first)) {
            queued.add(ob);
          }
        });
    return new Table(
            "header",
            Table.of(
                "format",
                Spellings.choice(FORMAT),
                CPU,
                Spellings.choice(words.families),
                "obs",
                Table.list(obs(words, numbered.keySet())),
                "clock",
                (Reader) Spellings::moment),
            Table.of(
                "mode",
                MODE,
                "latency_ms",
                Spellings.integer(0, Integer.MAX_VALUE),
                ZONE,
                MINUTES,
                "records",
                Table.list(Spellings.choice(KINDS)),
                "cycle",
                Spellings.TRUTH,
                CLASSES,
                (Reader) value -> value,
                QUEUE,
                queues(queued),
                PRIORITY,
                priorities(classes),
                "step7",
                Table.mapping(
                    "the fields tod and dint",
                    Map.of(
                        "tod",
                        parameters(timeOfDay, TIME_OF_DAY),
                        "dint",
                        parameters(words.timeDelayObs, TIME_DELAY))),
                READINGS,
                readings(words.letters),
                PROFILE,
                Spellings.choice(words.profiles)));
  }

  private static Reader obs(Words words, Set<Long> numbered) {
    Reader usual = Spellings.integer(words.obs.first(), words.obs.last());
    return value -> numbered.contains(value) ? value : usual.read(value);
  }

  private static Reader queues(TreeSet<Long> obs) {
    var readers = new LinkedHashMap<String, Reader>();
    obs.forEach(ob -> readers.put(String.valueOf(ob), value -> queue(QUEUE_OF_ONE.read(value))));
    return Table.mapping("an OB " + Quoting.ranges(obs), readers);
  }

  /** The queue of one OB; threshold 0: none, overflow -1: not known. */
  private static Object queue(Fields given) {
    long events = (Long) given.get(EVENTS);
    if (given.has(THRESHOLD) && (Long) given.get(THRESHOLD) > events) {
      throw new Unusable("1.." + events + ", as many as wait", String.valueOf(given.get(THRESHOLD)), THRESHOLD);
    }
    return new Fields()
        .put(EVENTS, events)
        .put(THRESHOLD, or(given, THRESHOLD, 0))
        .put(OVERFLOW, or(given, OVERFLOW, -1));
  }

  /** The OBs from 123 on of a header's line, each with its event class. */
  private TreeMap<Long, String> numbered(Fields line) {
    var numbered = new TreeMap<Long, String>();
    if (!(line.get(CLASSES) instanceof Fields given)) {
      if (line.has(CLASSES)) {
        throw new Unusable("an object", Quoting.quote(line.get(CLASSES)), CLASSES);
      }
      return numbered;
    }
    Reader name = Spellings.choice(words.eventClasses.keySet());
    for (int i = 0; i < given.size(); i++) {
      if (!given.name(i).startsWith(Table.OWN)) {
        try {
          numbered.put(number(given.name(i)), (String) name.read(given.value(i)));
        } catch (Unusable wrong) {
          throw wrong.inside(given.name(i)).inside(CLASSES);
        }
      }
    }
    words.eventClasses.forEach(
        (each, bounds) -> {
          long count = numbered.values().stream().filter(each::equals).count();
          if (count > bounds.get(1)) {
            throw new Unusable("at most " + bounds.get(1) + " OBs " + Quoting.quote(each), count + "", CLASSES);
          }
        });
    return numbered;
  }

  private long number(String name) {
    long first = words.numbers.first();
    long last = words.numbers.last();
    if (name.matches("[1-9][0-9]{2,4}") && Long.parseLong(name) >= first && Long.parseLong(name) <= last) {
      return Long.parseLong(name);
    }
    throw new Unusable("an OB " + first + ".." + last, "another name");
  }

  /** An OB whose default class no field of the header tells has one of its own. */
  private void requireClasses(Map<Long, String> numbered, Fields given) {
    numbered.forEach(
        (ob, name) -> {
          if (name.equals(CYCLIC) && !(given.get(PRIORITY) instanceof Fields set && set.has(String.valueOf(ob)))) {
            throw new Unusable("for the cyclic OB " + ob + ", whose interval is not known", "none", PRIORITY);
          }
        });
  }

  private static void only(List<String> families, Fields given, String field, boolean isThere) {
    if (isThere && !families.contains(given.get(CPU))) {
      throw new Unusable("on " + String.join(" and ", families) + " only", "on " + given.get(CPU), field);
    }
  }

  private static boolean isLocal(Fields given) {
    return given.get("step7") instanceof Fields kinds && step7(kinds).stream()
        .anyMatch(one -> Boolean.TRUE.equals(((Fields) one).get(LOCAL)));
  }

  /** What the lines of a log depend on, of its normalised header. */
  static Clocks.Cpu cpu(Fields header) {
    var numbered = new TreeSet<Object>();
    for (Object pair : (List<?>) header.get(CLASSES)) {
      numbered.add(((Number) ((List<?>) pair).get(0)).longValue());
    }
    return new Clocks.Cpu((String) header.get(CPU), numbered);
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
    normalised.put(LOCAL, or(given, LOCAL, false));
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
    TreeMap<Long, String> numbered = numbered(raw);
    Object family = raw.get(CPU);
    String known = family instanceof String name && headers.containsKey(name) ? name : settable.get(0);
    Table table =
        numbered.isEmpty() || !words.numbered.contains(known)
            ? headers.get(known)
            : header(words, classes.get(known), numbered);
    Fields given = table.read(raw);
    only(settable, given, PRIORITY, given.has(PRIORITY));
    only(local, given, ZONE, given.has(ZONE));
    only(local, given, "step7", isLocal(given));
    only(words.numbered, given, CLASSES, given.has(CLASSES));
    only(words.numbered, given, QUEUE, given.has(QUEUE));
    requireClasses(numbered, given);
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
    normalised.put(CLASSES, numbered.entrySet().stream()
        .map(each -> List.of((Object) each.getKey(), words.eventClasses.get(each.getValue()).get(0))).toList());
    normalised.put(QUEUE, records(given.get(QUEUE), new ArrayList<>()));
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
        records(step7.value(n), records);
      }
    }
    return records;
  }

  /** Adds a record for each OB of a map, with its {@code ob}. */
  private static List<Object> records(Object map, List<Object> records) {
    if (map instanceof Fields fields) {
      for (int i = 0; i < fields.size(); i++) {
        var record = new Fields().put("ob", Integer.valueOf(fields.name(i)));
        var parameters = (Fields) fields.value(i);
        for (int k = 0; k < parameters.size(); k++) {
          record.put(parameters.name(k), parameters.value(k));
        }
        records.add(record);
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
    TreeSet<Long> gone = new TreeSet<>(unknown.getOrDefault(family, new TreeSet<>()));
    if (!words.numbered.contains(family)) {
      ((List<?>) normalised.get(CLASSES)).forEach(pair -> gone.add((Long) ((List<?>) pair).get(0)));
      normalised.put(CLASSES, List.of()).put(QUEUE, List.of());
    }
    normalised.put("obs", ((List<?>) normalised.get("obs")).stream().filter(ob -> !gone.contains(ob)).toList());
  }

  private boolean isClass(List<?> pair, TreeMap<Long, TreeSet<Long>> classes) {
    long ob = ((Number) pair.get(0)).longValue();
    TreeSet<Long> those = classes.get(ob);
    return ob >= words.numbers.first() || those != null && those.contains(((Number) pair.get(1)).longValue());
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
