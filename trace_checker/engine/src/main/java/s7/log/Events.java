package s7.log;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** The events: every line of a log but the first. */
final class Events {
  static final String EVENT = "event";
  static final String AT = "at";
  static final String UP = "up";

  /** The milliseconds for which {@code at} stands, where they are more than one. */
  static final String STEP = "step";

  /** Of a line with a step: the {@code at} of the first finer one behind it in this step ({@link Onward}). */
  static final String UNTIL = "until";

  /** The event that ends a log. */
  static final String DONE = "done";

  private static final String OB = "ob";
  static final String RET = "ret";
  private static final String STATUS = "status";
  static final String FAULT = "flt_id";
  private static final String HOT = "hot";
  private static final String SET_LOCAL = "SET_TINTL";
  static final String LOCAL_TIME = "zone";

  /** Milliseconds; no log outlasts the years that the CPU clock can show. */
  private static final long LONGEST_UP = 100L * 366 * 86_400_000;

  private static final Reader SAME = value -> value;
  private static final Reader PASSED_OB = Spellings.integer(Short.MIN_VALUE, Short.MAX_VALUE);
  private static final Reader DURATION = Spellings::duration;
  private static final Reader MOMENT = Spellings::moment;

  private static final Table INFO =
      new Table(
          "info",
          Map.of(),
          Table.of(
              "strt_info", Spellings.BYTE,
              FAULT, Spellings.BYTE,
              "priority", Spellings.BYTE,
              "period", Spellings.WORD,
              "sign", Spellings.WORD,
              "dtime", DURATION,
              "error_info", Spellings.WORD,
              "ev", Spellings.WORD,
              "ev_ob", Spellings.BYTE,
              "time", MOMENT,
              "caught_up", Spellings.TRUTH_NUMBER,
              "second_time", Spellings.TRUTH_NUMBER,
              "event_count", Spellings.WORD,
              "csg_ob", Spellings.integer(0, Short.MAX_VALUE),
              "csg_priority", Spellings.BYTE));

  private final Map<String, Table> tables = new HashMap<>();
  private final Map<String, Map<String, Reader>> required = new LinkedHashMap<>();
  private final Set<Long> faulty;
  private final Map<String, TreeSet<String>> restarts;
  private final List<String> local;
  private final String obs;
  private final long lastOb;

  Events(Words words) {
    faulty = words.faultyObs;
    restarts = words.restarts;
    local = words.local;
    Map<String, Reader> none = Map.of();
    obs = Quoting.ranges(words.obs);
    lastOb = words.obs.last();
    Map<String, Reader> block = Table.of(OB, Spellings.integer(words.obs.first(), words.numbers.last()));
    Map<String, Reader> info = Table.of("info", INFO);
    Map<String, Reader> status = Table.of(STATUS, Spellings.WORD);
    Reader word = Spellings.WORD;
    Reader answer = Spellings.WORD_OR_NULL;
    Reader truth = Spellings.TRUTH_NUMBER;
    Map<String, Reader> ofOb = Table.of(OB, PASSED_OB, RET, answer);
    Map<String, Reader> withMode = Table.of("mode", Spellings.BYTE, OB, PASSED_OB, RET, answer);
    Reader date = Spellings::dateComponents;
    kind("SET_TINT", Table.of(OB, PASSED_OB, "sdt", date, "period", word, RET, answer), none);
    kind(
        SET_LOCAL,
        Table.of(OB, PASSED_OB, "sdt", date, "local", truth, "period", word, "activate", truth, RET, answer),
        none);
    kind("CAN_TINT", ofOb, none);
    kind("ACT_TINT", ofOb, none);
    kind("QRY_TINT", ofOb, status);
    kind("SRT_DINT", Table.of(OB, PASSED_OB, "dtime", DURATION, "sign", word, RET, answer), none);
    kind("CAN_DINT", ofOb, none);
    kind("QRY_DINT", ofOb, status);
    kind("DIS_IRT", withMode, none);
    kind("EN_IRT", withMode, none);
    kind("DIS_AIRT", Table.of(RET, answer), none);
    kind("EN_AIRT", Table.of(RET, answer), none);
    kind("start", block, info);
    kind("end", block, none);
    kind("clock", Table.of("to", MOMENT), none);
    kind(
        LOCAL_TIME,
        Table.of("zone", Header.MINUTES, "reason", Spellings.choice("zone", "daylight")),
        none);
    kind("restart", Table.of("type", Spellings.choice("warm", "cold", HOT)), none);
    kind("run", none, none);
    kind("stop", none, Table.of("cause", word));
    kind("hold", none, none);
    kind("release", none, none);
    kind("interrupt", Table.of(OB, external(words.externalObs, words.numbers.first())), Table.of(FAULT, Spellings.BYTE));
    kind("load", block, none);
    kind("delete", block, none);
    kind(
        "diag",
        Table.of("id", word),
        Table.of(OB, Spellings.BYTE, "priority", Spellings.BYTE, "info", INFO));
    kind(DONE, none, none);
    kind(
        "state",
        block,
        Table.of(
            "active", truth, "blocked", truth, "loaded", truth, "entries_off", truth,
            "left", Spellings.integer(0, Integer.MAX_VALUE)));
  }

  /** The required fields of an event, without those of every event. */
  Map<String, Reader> required(String name) {
    return required.get(name);
  }

  /** The events that are calls. */
  List<String> calls() {
    return required.keySet().stream().filter(name -> required.get(name).containsKey(RET)).toList();
  }

  private static Reader external(Set<Long> obs, long firstNumbered) {
    String expected = "an OB " + Quoting.ranges(obs);
    return value -> {
      if (value instanceof Long ob && (obs.contains(ob) || ob >= firstNumbered)) {
        return value;
      }
      throw new Unusable(expected, Quoting.quote(value));
    };
  }

  /** Enters an event with its required and its optional fields, without those of every event. */
  private void kind(String name, Map<String, Reader> needed, Map<String, Reader> optional) {
    required.put(name, needed);
    var all = new LinkedHashMap<String, Reader>();
    all.put(EVENT, SAME);
    all.put(AT, Spellings::instant);
    all.putAll(needed);
    var others = new LinkedHashMap<String, Reader>();
    others.put(UP, Spellings.integer(0, LONGEST_UP));
    others.putAll(optional);
    tables.put(name, new Table(name, all, others));
  }

  /**
   * The normalised event of a line's object. Points in time are moments but for {@code at}, which stays milliseconds
   * since 1990-01-01T00:00, and {@code sdt}, which is its components. {@code step} is the unit in which {@code at} is
   * written, if that is not a millisecond.
   *
   * @param cpu the log's CPU
   */
  Fields read(Fields raw, Clocks.Cpu cpu) {
    Object name = raw.get(EVENT);
    Table fields = name instanceof String ? tables.get(name) : null;
    if (fields == null) {
      throw noEvent(raw);
    }
    Fields event = fields.read(raw);
    int unit = Spellings.step((String) raw.get(AT));
    if (unit > 1) {
      event.add(STEP, unit);
    }
    if (List.of(SET_LOCAL, LOCAL_TIME).contains(name)) {
      checkLocal(cpu.family());
    }
    if (!event.has(RET) && event.get(OB) instanceof Long ob && ob > lastOb && !cpu.numberedObs().contains(ob)) {
      throw new Unusable("an OB " + obs + " or one of the header's \"classes\"", String.valueOf(ob), OB);
    }
    if (name.equals("interrupt")) {
      checkFault(event);
    } else if (name.equals("restart")) {
      checkHot(event.get("type"), cpu.family());
    } else if (((String) name).startsWith("QRY") && event.get(RET).equals(0) && !event.has(STATUS)) {
      throw new Unusable("where \"ret\" is 0", "none", STATUS);
    }
    return event;
  }

  /** An event of local time is one of a CPU that has it. */
  void checkLocal(String cpu) {
    if (!local.contains(cpu)) {
      throw new Unusable("on " + String.join(" and ", local) + " only", "on " + cpu, EVENT);
    }
  }

  /** A hot restart is one of a CPU that knows it [OBS-57]. */
  private void checkHot(Object type, String cpu) {
    if (HOT.equals(type) && restarts.containsKey(cpu) && !restarts.get(cpu).contains(HOT)) {
      var others = restarts.keySet().stream().filter(name -> restarts.get(name).contains(HOT)).toList();
      throw new Unusable("hot on " + String.join(" and ", others) + " only", "on " + cpu, "type");
    }
  }

  /** An interrupt line of an OB that comes with a fault id, and no other, has it. */
  void checkFault(Fields event) {
    Object ob = event.get(OB);
    boolean needed = faulty.contains(ob);
    if (event.has(FAULT) && !needed) {
      String obs = faulty.stream().map(String::valueOf).collect(Collectors.joining(" and "));
      throw new Unusable("for OB " + obs + " only", "for OB " + ob, FAULT);
    }
    if (needed && !event.has(FAULT)) {
      throw new Unusable("for OB " + ob, "none", FAULT);
    }
  }

  private static Unusable noEvent(Fields raw) {
    if (raw.has(EVENT)) {
      return new Unusable("the name of an event", Quoting.quote(raw.get(EVENT)), EVENT);
    }
    if (raw.has("format")) {
      return new Unusable("an event", "a second header");
    }
    return new Unusable("in every line but the header", "none", EVENT);
  }
}
