package s7.importing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

import s7.log.Unusable;

/** Records of SZL 16#xxA0, the diagnostic buffer as the CPU gives it. */
final class Szl {
  /** Bytes of the header before the records: SZL-ID, index, length of a record, number of records. */
  private static final int IDENTIFIED = 8;

  /** Those without SZL-ID and index. */
  private static final int COUNTED = 4;

  /** Those with the four bytes before them in an answer on the network: return code, transport size, length. */
  private static final int TRANSPORTED = 12;

  /** Return code and transport size of an answer with data. */
  private static final int ANSWERED = 0xFF09;

  /** The list's number, the lower byte of the SZL-ID. */
  private static final int LIST = 0xA0;

  private Szl() {}

  /** Whether the bytes begin with a record that has an entry, with or without a header before it. */
  static boolean hasRecord(byte[] raw) {
    for (int header : new int[] {0, COUNTED, IDENTIFIED, TRANSPORTED}) {
      if (Bcd.instant(raw, header + Entry.CODED) != null) {
        return true;
      }
    }
    return false;
  }

  /** The entries of records; the header of list or answer may come first. */
  static Diagnostics read(byte[] raw) {
    var entries = new ArrayList<Entry>();
    int from = header(raw);
    int empty = 0;
    for (int number = 1; from < raw.length; number++, from += Entry.LENGTH) {
      if (isEmpty(raw, from)) {
        empty++;
      } else {
        entries.add(Entry.of(number, raw, from));
      }
    }
    return new Diagnostics(entries, empty);
  }

  /** Entries of bare records. */
  static List<Entry> entries(byte[] raw) {
    var entries = new ArrayList<Entry>();
    for (int from = 0; from < raw.length; from += Entry.LENGTH) {
      entries.add(Entry.of(1, raw, from));
    }
    return entries;
  }

  /** A slot that was never written holds zeros. */
  private static boolean isEmpty(byte[] raw, int from) {
    for (int at = from; at < from + Entry.LENGTH; at++) {
      if (raw[at] != 0) {
        return false;
      }
    }
    return true;
  }

  /** Where the records begin. */
  private static int header(byte[] raw) {
    int header = raw.length % Entry.LENGTH;
    int transport = TRANSPORTED - IDENTIFIED;
    if (header == TRANSPORTED && Octets.word(raw, 0) == ANSWERED) {
      int announced = Octets.word(raw, 2);
      int present = raw.length - transport;
      if (announced != present) {
        throw new Unusable("a length of " + present + " bytes, as many as follow", String.valueOf(announced))
            .of("transport");
      }
      return transport + header(Arrays.copyOfRange(raw, transport, raw.length));
    }
    if (header == IDENTIFIED && Octets.one(raw, 1) == LIST) {
      checkCounts(raw, COUNTED);
    } else if (header == COUNTED && Octets.word(raw, 0) == Entry.LENGTH) {
      checkCounts(raw, 0);
    } else if (header > 0) {
      throw new Unusable("records of " + Entry.LENGTH + " bytes of SZL 16#00A0", raw.length + " bytes");
    }
    return header;
  }

  private static void checkCounts(byte[] raw, int at) {
    int length = Octets.word(raw, at);
    int number = Octets.word(raw, at + 2);
    int present = raw.length / Entry.LENGTH;
    if (length != Entry.LENGTH) {
      throw new Unusable("records of " + Entry.LENGTH + " bytes", "records of " + length).of("header");
    }
    if (number != present) {
      throw new Unusable(present + " records, as many as follow", "a count of " + number).of("header");
    }
  }
}
