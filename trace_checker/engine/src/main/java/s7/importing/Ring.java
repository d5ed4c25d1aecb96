package s7.importing;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;

import s7.log.Fields;
import s7.log.Unusable;

/**
 * The ring that the SCL instrumentation writes, a data block.
 *
 * @param capacity the number of slots
 * @param written that of the entries written so far
 */
record Ring(int capacity, int written) {
  private static final int HEADER = 20;
  private static final int MAGIC = 0x5337;
  private static final int LAYOUT = 1;

  static boolean begins(byte[] raw) {
    return raw.length >= 4 && Octets.doubleWord(raw, 0) == (MAGIC << 16 | LAYOUT);
  }

  /** The header of the ring in these bytes, which may be more. */
  static Ring of(byte[] raw) {
    if (raw.length < HEADER) {
      throw new Unusable("a ring of at least " + HEADER + " bytes", raw.length + " bytes");
    }
    int magic = Octets.word(raw, 0);
    int layout = (short) Octets.word(raw, 2);
    int capacity = (short) Octets.word(raw, 4);
    int size = (short) Octets.word(raw, 6);
    if (magic != MAGIC) {
      throw new Unusable("a ring that begins with 16#" + Octets.hex(MAGIC, 4), "16#" + Octets.hex(magic, 4));
    }
    if (layout != LAYOUT) {
      throw new Unusable("a ring of layout " + LAYOUT, "layout " + layout);
    }
    if (size != Slot.LENGTH || capacity < 1) {
      throw new Unusable("slots of " + Slot.LENGTH + " bytes, one at least", capacity + " slots of " + size);
    }
    return new Ring(capacity, Octets.doubleWord(raw, 12));
  }

  /** Bytes of the header and all slots. */
  private int length() {
    return HEADER + capacity * Slot.LENGTH;
  }

  Fields told() {
    return new Fields()
        .put("capacity", capacity)
        .put("size", Slot.LENGTH)
        .put("written", written)
        .put("length", length());
  }

  /** The events of a dump that begins with this header. */
  Recording convert(byte[] raw, Recording.Span chosen) {
    if (raw.length < length()) {
      throw new Unusable(length() + " bytes, for " + capacity + " slots", raw.length + " bytes");
    }
    var recording = new Recording();
    List<Slot> kept =
        recording.select(inOrder(Slot.all(raw, HEADER, length()), recording), Slot::number, chosen);
    int first = begin(kept, recording);
    recording.skip("before the first entry of OB 1 or a startup OB", first);
    var elapsed = new Elapsed();
    kept.subList(first, kept.size()).forEach(slot -> slot.addTo(recording, elapsed));
    recording.header.put("clock", kept.get(first).clock()).put("records", List.of());
    recording.remarks.add(
        "only you know whether each SFC call and each OB goes through the instrumentation: if so, --records call,ob");
    return recording;
  }

  /** The entries without a gap, up to the last entry that was counted when the header was read. */
  private List<Slot> inOrder(List<Slot> slots, Recording recording) {
    var present = new HashMap<Integer, Slot>();
    slots.stream().filter(slot -> slot.number() != 0).forEach(slot -> present.put(slot.number(), slot));
    int first = written;
    while (present.containsKey(first)) {
      first--;
    }
    if (first == written) {
      throw new Unusable(written != 0 ? "entry " + written + ", the newest one" : "an entry", "none");
    }
    if (first > 0) {
      recording.remarks.add(first + " older entries were overwritten in the ring");
    }
    var entries = new ArrayList<Slot>();
    for (int number = first; number != written; ) {
      entries.add(present.get(++number));
    }
    return entries;
  }

  /** The place of the first entry at which a log can begin. */
  private static int begin(List<Slot> entries, Recording recording) {
    for (int i = 0; i < entries.size(); i++) {
      if (entries.get(i).beginsRestart()) {
        recording.header.put("mode", "STOP");
        return i;
      }
      String mode = entries.get(i).modeAtBegin();
      if (mode != null) {
        recording.header.put("mode", mode);
        recording.remarks.add("the log begins while the program runs: what it called before is unknown");
        return i;
      }
    }
    throw new Unusable("an entry of OB 1 or a startup OB to begin with", "entries of other OBs only");
  }
}
