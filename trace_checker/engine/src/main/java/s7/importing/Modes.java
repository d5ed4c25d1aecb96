package s7.importing;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

import s7.log.Fields;

/**
 * The operating mode, as far as entries of class 4 tell of it.
 *
 * <p>Byte 3 of such an entry holds the old and the new mode. Where only the event ID is known, some IDs name one or
 * both. What stays ambiguous gives no event and makes the recording of modes incomplete; so does an entry whose old
 * mode is not the new mode of the one before.
 *
 * @param first the mode before the entries; null if they do not tell it
 * @param events the entries' mode events by the index of the entry
 * @param complete whether no change can be missing
 */
record Modes(String first, Map<Integer, Fields> events, boolean complete) {
  static final int CLASS = 4;
  static final int POWER_ON = 0x4300;

  private static final String STOP = "STOP";
  private static final String STARTUP = "STARTUP";
  private static final String RUN = "RUN";
  private static final String HOLD = "HOLD";

  /** Old and new mode; null where it is not told. */
  record Change(String old, String now) {}

  /** Event ID -> old and new mode, as far as the ID alone tells them. */
  private static final Map<Integer, Change> OF_ID = new HashMap<>();

  static {
    OF_ID.put(0x4301, new Change(STOP, STARTUP));
    OF_ID.put(0x4302, new Change(STARTUP, RUN));
    OF_ID.put(0x4305, new Change(null, HOLD));
    OF_ID.put(0x4306, new Change(HOLD, null));
    OF_ID.put(0x430A, new Change(HOLD, STOP));
    for (int id : new int[] {0x4303, 0x4304, 0x4541, 0x454A, 0x4562, 0x4563, 0x4568, 0x456D, 0x4570, 0x457F}) {
      OF_ID.put(id, new Change(null, STOP));
    }
  }

  /** New mode of an entry 4301 -> the kinds of restart it may be; editions disagree about 5. */
  private static final Map<Integer, Set<String>> STARTUPS =
      Map.of(5, Set.of("warm", "cold"), 6, Set.of("warm"), 7, Set.of("hot"));

  /** Request for a restart -> its kind; it follows the entry 4301. */
  private static final Map<Integer, String> REQUESTS =
      Map.of(0x1381, "warm", 0x1382, "warm", 0x1383, "hot", 0x1384, "hot", 0x1385, "cold", 0x1386, "cold");

  private static final Map<Change, String> EVENTS =
      Map.of(new Change(STARTUP, RUN), "run", new Change(RUN, HOLD), "hold", new Change(HOLD, RUN), "release");

  /** The mode that a half-byte stands for; null if none of these. */
  static String ofNibble(int nibble) {
    return switch (nibble) {
      case 1, 2, 3, 4 -> STOP;
      case 5, 6, 7 -> STARTUP;
      case 8 -> RUN;
      case 0xA -> HOLD;
      default -> null;
    };
  }

  /** What entries, oldest first, tell of the mode. */
  static Modes follow(List<Entry> entries) {
    String first = null;
    String mode = null;
    var events = new HashMap<Integer, Fields>();
    boolean complete = true;
    boolean changed = false;
    for (int i = 0; i < entries.size(); i++) {
      Change change = changeOf(entries.get(i));
      if (change == null) {
        // A power failure ends RUN without an entry of its own.
        complete &= entries.get(i).id() != POWER_ON;
        continue;
      }
      if (!changed) {
        first = change.old;
      } else if (mode != null && change.old != null && !mode.equals(change.old)) {
        complete = false;
      }
      changed = true;
      String old = change.old == null ? mode : change.old;
      Fields event = event(new Change(old, change.now), entries.subList(i, entries.size()));
      if (event != null) {
        events.put(i, event);
      } else if (change.now == null || !change.now.equals(old)) {
        complete = false;
      }
      mode = change.now;
    }
    return new Modes(first, events, complete && first != null);
  }

  /** The change of the mode; null if the entry has none. */
  static Change changeOf(Entry entry) {
    Change byId = OF_ID.get(entry.id());
    if (entry.coding() == null || entry.eventClass() != CLASS) {
      return byId;
    }
    int modes = Octets.one(entry.coding(), 3);
    var shown = new Change(ofNibble(modes >> 4), ofNibble(modes & 0xF));
    if (byId == null) {
      // Of other entries of the class only those of a STOP are sure to change the mode.
      return shown.old != null && !shown.old.equals(STOP) && STOP.equals(shown.now) ? shown : null;
    }
    boolean contradicts =
        (byId.old != null && !byId.old.equals(shown.old)) || (byId.now != null && !byId.now.equals(shown.now));
    return contradicts ? new Change(null, null) : shown;
  }

  /** The event of a change; the first of the entries has it. */
  private static Fields event(Change change, List<Entry> entries) {
    if (change.equals(new Change(STOP, STARTUP))) {
      String kind = restart(entries);
      return kind == null ? null : named("restart").put("type", kind);
    }
    if (STOP.equals(change.now)) {
      return STOP.equals(change.old) ? null : named("stop").put("cause", Octets.asWord(entries.get(0).id()));
    }
    String name = EVENTS.get(change);
    return name == null ? null : named(name);
  }

  private static Fields named(String event) {
    return new Fields().put("event", event);
  }

  /** The kind of restart that an entry 4301 begins; null if it is not told. */
  private static String restart(List<Entry> entries) {
    byte[] coding = entries.get(0).coding();
    var kinds = new TreeSet<>(coding == null ? Set.of("warm", "hot", "cold") : STARTUPS.get(coding[3] & 0xF));
    for (Entry entry : entries.subList(1, entries.size())) {
      if (entry.eventClass() == CLASS) {
        break;
      }
      if (REQUESTS.containsKey(entry.id())) {
        kinds.retainAll(Set.of(REQUESTS.get(entry.id())));
      }
    }
    return kinds.size() == 1 ? kinds.first() : null;
  }
}
