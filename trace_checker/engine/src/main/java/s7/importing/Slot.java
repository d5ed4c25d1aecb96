package s7.importing;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;

import s7.log.Fields;
import s7.log.Unusable;

/** A slot of the ring, with an entry as UDT 100 lays it out (instrumentation/scl/README.md). */
record Slot(byte[] raw, int from) {
  static final int LENGTH = 44;

  private static final int CLOCK = 8;
  private static final int STAMP = 32;

  private static final int SET_CLK = 0;
  private static final int STATE = 51;
  private static final int OB_BEGINS = 200;
  private static final int OB_ENDS = 201;
  private static final int INTERRUPT = 202;

  /** Code of an entry, the number of the SFC -> the event. */
  private static final Map<Integer, String> CALLS =
      Map.ofEntries(
          Map.entry(28, "SET_TINT"),
          Map.entry(29, "CAN_TINT"),
          Map.entry(30, "ACT_TINT"),
          Map.entry(31, "QRY_TINT"),
          Map.entry(32, "SRT_DINT"),
          Map.entry(33, "CAN_DINT"),
          Map.entry(34, "QRY_DINT"),
          Map.entry(39, "DIS_IRT"),
          Map.entry(40, "EN_IRT"),
          Map.entry(41, "DIS_AIRT"),
          Map.entry(42, "EN_AIRT"));

  /** OB that makes the first entry -> the mode; another OB interrupts an unknown mode. */
  private static final Map<Integer, String> MODES_AT_BEGIN = Map.of(1, "RUN", 100, "STARTUP", 102, "STARTUP");

  private static final Map<Integer, String> RESTARTS = Map.of(100, "warm", 101, "hot", 102, "cold");

  /** Event numbers with which OB 1 begins after a warm, a hot and a cold restart. */
  private static final Set<Integer> FIRST_CYCLES = Set.of(0x01, 0x02, 0x04);

  /** What whole slots hold, one behind the other. */
  static List<Slot> all(byte[] raw, int from, int to) {
    var slots = new ArrayList<Slot>();
    for (int at = from; at + LENGTH <= to; at += LENGTH) {
      slots.add(new Slot(raw, at));
    }
    return slots;
  }

  int number() {
    return Octets.doubleWord(raw, from);
  }

  String place() {
    return "entry " + number();
  }

  private int code() {
    return (short) Octets.word(raw, from + 16);
  }

  private int caller() {
    return Octets.one(raw, from + 18);
  }

  private int ob() {
    return (short) Octets.word(raw, from + 20);
  }

  private int info1() {
    return Octets.word(raw, from + 22);
  }

  private int info2() {
    return Octets.doubleWord(raw, from + 24);
  }

  private int ret() {
    return Octets.word(raw, from + 28);
  }

  private int status() {
    return Octets.word(raw, from + 30);
  }

  private int event() {
    return Octets.one(raw, from + 41);
  }

  private boolean done() {
    return raw[from + 43] != 0;
  }

  /** Whether a startup OB begins. */
  boolean beginsRestart() {
    return code() == OB_BEGINS && RESTARTS.containsKey(ob());
  }

  /** The mode if the log begins there while the program runs; null if nobody knows it. */
  String modeAtBegin() {
    return MODES_AT_BEGIN.containsKey(caller()) && beginsRun() ? "STARTUP" : MODES_AT_BEGIN.get(caller());
  }

  private boolean beginsRun() {
    return code() == OB_BEGINS && ob() == 1 && FIRST_CYCLES.contains(event());
  }

  /** Whether the program has set the clock. */
  private boolean setsClock() {
    return code() == SET_CLK && done() && ret() == 0;
  }

  private String wrongDate(int at) {
    return Octets.spaced(raw, from + at, from + at + Bcd.LENGTH);
  }

  /** The CPU clock of the entry. */
  String clock() {
    String clock = Bcd.instant(raw, from + CLOCK);
    if (clock == null) {
      throw new Unusable("a DATE_AND_TIME in BCD", wrongDate(CLOCK)).of(place());
    }
    return clock;
  }

  private String date() {
    String date = Bcd.digits(raw, from + STAMP);
    if (date == null) {
      throw new Unusable("a DATE_AND_TIME in BCD", wrongDate(STAMP)).of(place());
    }
    return date;
  }

  /** Its events, whose time {@code elapsed} takes. One that gives none is counted in {@code recording}. */
  void addTo(Recording recording, Elapsed elapsed) {
    String at = clock();
    long up =
        elapsed.up(Bcd.milliseconds(raw, from + CLOCK), Octets.doubleWord(raw, from + 4), beginsRestart());
    for (Fields event : events(recording)) {
      recording.add(
          place(), new Fields().put("event", event.get("event")).put("at", at).put("up", up).with(event));
    }
    if (setsClock()) {
      if (Bcd.instant(raw, from + STAMP) == null) {
        throw new Unusable("a clock that is set to a DATE_AND_TIME", wrongDate(STAMP)).of(place());
      }
      elapsed.setClock(Bcd.milliseconds(raw, from + STAMP));
    }
  }

  private static Fields named(String event) {
    return new Fields().put("event", event);
  }

  private Fields ofOb(String event) {
    return named(event).put("ob", ob());
  }

  /** The events that the entry tells of, without their times. */
  private List<Fields> events(Recording recording) {
    int code = code();
    if (CALLS.containsKey(code)) {
      return List.of(call(code).put("x_ob", caller()));
    }
    switch (code) {
      case OB_BEGINS -> {
        Fields info = new Fields().put("priority", Octets.one(raw, from + 42));
        info.with(StartInfo.of(ob(), event(), info1(), info2())).put("time", date());
        Fields start = ofOb("start").put("info", info);
        Fields mode = beginsRestart() ? restart() : beginsRun() ? named("run") : null;
        return mode == null ? List.of(start) : List.of(mode, start);
      }
      case OB_ENDS -> {
        return List.of(ofOb("end"));
      }
      case INTERRUPT -> {
        return List.of(ofOb("interrupt"));
      }
      case STATE -> {
        if (done() && ret() == 0) {
          return List.of(ofOb("state").with(state(ob(), status(), info2())).put("x_ob", caller()));
        }
        recording.skip("RDSYSST that did not answer", 1);
      }
      case SET_CLK -> {
        if (setsClock()) {
          return List.of(named("clock").put("to", date()).put("x_ob", caller()));
        }
        recording.skip("SET_CLK that did not set the clock", 1);
      }
      default ->
          throw new Unusable("the number of an SFC or 200 to 202 as its code", String.valueOf(code)).of(place());
    }
    return List.of();
  }

  /** The restart that the begin of a startup OB proves. */
  private Fields restart() {
    return named("restart").put("type", RESTARTS.get(ob()));
  }

  /** A call with what the program passed; RET_VAL and STATUS are not there while it has not come back. */
  private Fields call(int code) {
    Fields call = named(CALLS.get(code));
    if (code == 39 || code == 40) {
      call.put("mode", Octets.asByte(Octets.one(raw, from + 19)));
    }
    if (code < 41) {
      call.put("ob", ob());
    }
    if (code == 28) {
      call.put("sdt", date()).put("period", Octets.asWord(info1()));
    } else if (code == 32) {
      call.put("dtime", info2()).put("sign", Octets.asWord(info1()));
    }
    call.put("ret", done() ? Octets.asWord(ret()) : null);
    return done() && (code == 31 || code == 34) ? call.put("status", Octets.asWord(status())) : call;
  }

  /**
   * What SZL 16#0222 shows of an OB.
   *
   * @param al1 its word of bits
   * @param left the milliseconds left of a delay; null if they are not known
   */
  static Fields state(int ob, int al1, Integer left) {
    var state = new Fields();
    state.put("blocked", bit(al1, 1)).put("loaded", bit(al1, 4)).put("entries_off", bit(al1, 6));
    if (StartInfo.isTimeOfDay(ob) || StartInfo.isTimeDelay(ob)) {
      boolean active = bit(al1, 2);
      state.put("active", active);
      if (active && left != null && StartInfo.isTimeDelay(ob)) {
        state.put("left", left);
      }
    }
    return state;
  }

  private static boolean bit(int word, int number) {
    return (word >> number & 1) == 1;
  }

  /** What is asked of it before its events; times are null where there are no such ones. */
  Fields told() {
    var told = new Fields().put("number", number()).put("code", code()).put("done", done()).put("sets", setsClock());
    told.put("startup", RESTARTS.containsKey(caller())).put("begins", MODES_AT_BEGIN.containsKey(caller()));
    told.put("clock", Bcd.instant(raw, from + CLOCK)).put("to", Bcd.instant(raw, from + STAMP));
    return beginsRestart() ? told.put("restart", restart()) : told;
  }
}
