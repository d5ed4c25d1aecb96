package s7.importing;

import java.util.Arrays;

import s7.log.Unusable;

/**
 * An entry of the diagnostic buffer.
 *
 * @param number that of the source, 1 the newest
 * @param at the time as a log spells it
 * @param coding the first twelve bytes, those that STEP 7 prints; null where the source gives the event ID only
 */
record Entry(int number, String place, int id, String at, byte[] coding) {
  /** Bytes of an entry: event ID, class, OB, two reserved, additional information, DATE_AND_TIME. */
  static final int LENGTH = 20;

  /** Those of the coding. */
  static final int CODED = 12;

  /** The class of the event ID: 1 to 3 start OBs, 4 changes the mode. */
  int eventClass() {
    return id >> 12;
  }

  /** The entry of a record of SZL 16#xxA0, which begins there. */
  static Entry of(int number, byte[] raw, int from) {
    String place = "entry " + number;
    String at = Bcd.instant(raw, from + CODED);
    if (at == null) {
      throw new Unusable(
              "a DATE_AND_TIME in BCD in the last eight bytes",
              Octets.spaced(raw, from + CODED, from + LENGTH))
          .of(place);
    }
    return new Entry(number, place, Octets.word(raw, from), at, Arrays.copyOfRange(raw, from, from + CODED));
  }
}
