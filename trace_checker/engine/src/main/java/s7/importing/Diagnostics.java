package s7.importing;

import java.util.Comparator;
import java.util.List;

import s7.log.Fields;
import s7.log.Unusable;

/**
 * A diagnostic buffer, and its entries as events of a log.
 *
 * @param empty how many of its slots were never written
 */
record Diagnostics(List<Entry> entries, int empty) {
  private static final int LAST_OB = 122;

  /** Priority classes end there; 16#FF stands for none. */
  private static final int LAST_CLASS = 29;

  /** In the place of the priority class: the OB could not be started. */
  private static final int NOT_STARTED = 0xFE;

  /** Its events. The clock must not be set back between two entries: nothing tells when and from which reading. */
  Recording convert(Recording.Span chosen) {
    var recording = new Recording();
    List<Entry> kept = recording.select(entries, Entry::number, chosen);
    kept.sort(Comparator.comparingInt(Entry::number).reversed());
    recording.read += empty;
    recording.skip("never written", empty);
    checkOrder(kept);
    Modes modes = Modes.follow(kept);
    for (int i = 0; i < kept.size(); i++) {
      Entry entry = kept.get(i);
      Fields change = modes.events().get(i);
      if (change != null) {
        // What the entry reports comes first: the change of the mode, then the entry about it.
        recording.add(entry.place(), at(change, entry));
      }
      recording.add(entry.place(), event(entry));
      noteOb(entry, recording);
    }
    recording.header.put("clock", kept.get(0).at());
    if (modes.first() != null && !modes.first().equals("HOLD")) {
      recording.header.put("mode", modes.first());
    }
    boolean withoutGap = kept.get(0).number() - kept.get(kept.size() - 1).number() == kept.size() - 1;
    recording.header.put(
        "records", !withoutGap ? List.of() : modes.complete() ? List.of("mode", "diag") : List.of("diag"));
    if (!withoutGap) {
      recording.remarks.add("numbers are missing between the entries, so the log does not record diag completely");
    }
    return recording;
  }

  private static void checkOrder(List<Entry> entries) {
    for (int i = 1; i < entries.size(); i++) {
      Entry earlier = entries.get(i - 1);
      Entry later = entries.get(i);
      if (later.at().compareTo(earlier.at()) < 0) {
        throw new Unusable(
                "no time before " + earlier.at() + ", that of entry " + earlier.number(),
                later.at() + ": the clock was set back between them; import the entries before and after apart, with "
                    + "--entries " + earlier.number() + "- and --entries 1-" + later.number())
            .of(later.place());
      }
    }
  }

  /** Whether an entry names an OB. */
  private static boolean hasOb(Entry entry) {
    return entry.coding() != null
        && entry.eventClass() != Modes.CLASS
        && entry.coding()[3] >= 1
        && entry.coding()[3] <= LAST_OB;
  }

  private static void noteOb(Entry entry, Recording recording) {
    if (hasOb(entry)) {
      int ob = entry.coding()[3];
      int priority = Octets.one(entry.coding(), 2);
      if (priority == NOT_STARTED) {
        recording.missing.putIfAbsent(ob, entry.place());
      } else if (priority <= LAST_CLASS) {
        recording.started.putIfAbsent(ob, entry.place());
      }
    }
  }

  /** The event of an entry, without what it tells of the mode. */
  static Fields event(Entry entry) {
    Fields event = at(new Fields().put("event", "diag"), entry).put("id", Octets.asWord(entry.id()));
    byte[] coding = entry.coding();
    if (coding == null) {
      return event;
    }
    if (hasOb(entry)) {
      event.put("ob", (int) coding[3]);
      if (Octets.one(coding, 2) <= LAST_CLASS) {
        event.put("priority", (int) coding[2]);
      }
      // Those entries are the start information of an OB whose layout is known.
      if (entry.eventClass() == 1 || entry.eventClass() == 3) {
        Fields info =
            StartInfo.of(coding[3], entry.id() & 0xFF, Octets.word(coding, 6), Octets.doubleWord(coding, 8));
        if (info.size() > 0) {
          event.put("info", info);
        }
      }
    }
    return event.put("x_coding", Octets.spaced(coding, 0, coding.length));
  }

  /** An event with the time of an entry behind its name. */
  static Fields at(Fields event, Entry entry) {
    return new Fields().put("event", event.get("event")).put("at", entry.at()).with(event);
  }
}
