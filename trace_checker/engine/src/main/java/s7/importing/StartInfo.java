package s7.importing;

import java.util.Map;
import java.util.Set;

import s7.log.Fields;

/**
 * The start information of an OB, bytes 1 and 4 to 11, as the fields of {@code info}, by table 7.2 of the requirements.
 * Bytes whose meaning no source tells are left out.
 */
final class StartInfo {
  /** OBs beside 80 to 88 of which byte 1 is a fault id. */
  private static final Set<Integer> WITH_FAULT = Set.of(70, 72, 73, 121, 122);

  /** OB -> its faults of which bytes 6-7 are an ERROR_INFO. */
  private static final Map<Integer, Set<Integer>> ERROR_INFO =
      Map.of(80, Set.of(0x01, 0x02, 0x05, 0x06, 0x07, 0x08, 0x09, 0x0A), 85, Set.of(0xA1, 0xA2));

  /** OB -> its faults of which bytes 8-11 name an event and an OB. */
  private static final Map<Integer, Set<Integer>> CAUSE =
      Map.of(80, Set.of(0x01, 0x02, 0x07, 0x0B), 85, Set.of(0xA1, 0xA2));

  private StartInfo() {}

  static boolean isTimeOfDay(int ob) {
    return ob >= 10 && ob < 18;
  }

  static boolean isTimeDelay(int ob) {
    return ob >= 20 && ob < 24;
  }

  /**
   * The fields of an OB's start information.
   *
   * @param number byte 1
   * @param info1 the word of bytes 6-7
   * @param info2 the double word of bytes 8-11; a TIME is signed
   */
  static Fields of(int ob, int number, int info1, int info2) {
    var fields = new Fields();
    if (CAUSE.containsKey(ob)) {
      fields.put("flt_id", Octets.asByte(number));
      if (ERROR_INFO.get(ob).contains(number)) {
        fields.put("error_info", Octets.asWord(info1));
      }
      if (CAUSE.get(ob).contains(number)) {
        fields.put("ev", Octets.asWord(info2 >> 16)).put("ev_ob", info2 & 0xFF);
      }
    } else if (!WITH_FAULT.contains(ob) && (ob < 80 || ob > 88)) {
      fields.put("strt_info", Octets.asByte(number));
    }
    if (isTimeOfDay(ob)) {
      fields.put("period", Octets.asWord(info1));
    }
    if (isTimeDelay(ob)) {
      fields.put("sign", Octets.asWord(info1)).put("dtime", info2);
    }
    return fields;
  }
}
