package s7.log;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;

/** The names and numbers that a log may have in certain places, as the specification tells them. */
final class Words {
  final List<String> families;

  /** The families whose priority classes can be set. */
  final List<String> settable;

  /** Family -> the types of restart that it knows. */
  final TreeMap<String, TreeSet<String>> restarts;

  final List<String> profiles;

  /** Ambiguity -> the letters of its readings. */
  final TreeMap<String, TreeSet<String>> letters;

  final TreeSet<Long> obs;
  final TreeSet<Long> timeOfDayObs;
  final TreeSet<Long> timeDelayObs;

  /** OBs that an interrupt line may name. */
  final TreeSet<Long> externalObs;

  /** The OBs of these whose interrupt line carries a fault id. */
  final TreeSet<Long> faultyObs;

  /** Family -> OB -> the priority classes it can be given, where they can be set. */
  final Map<String, TreeMap<Long, TreeSet<Long>>> classes = new TreeMap<>();

  /** Family -> the OBs that none of its CPUs has. */
  final TreeMap<String, TreeSet<Long>> unknown;

  /** The families that have SET_TINTL, and with it local time. */
  final List<String> local;

  /** The families with OBs from 123 on, and with parameters of queues. */
  final List<String> numbered;

  /** The first and the last number of such an OB. */
  final TreeSet<Long> numbers;

  /** Name of an event class -> its first OB and the most OBs that a CPU has of it. */
  final TreeMap<String, List<Long>> eventClasses = new TreeMap<>();

  /** The OBs whose queue has parameters. */
  final TreeSet<Long> queuedObs;

  Words(Fields words) {
    families = list(words.get("families"));
    settable = list(words.get("settable"));
    restarts = map(words.get("restarts"));
    profiles = list(words.get("profiles"));
    letters = map(words.get("choices"));
    obs = new TreeSet<>(Words.<Long>list(words.get("obs")));
    timeOfDayObs = new TreeSet<>(Words.<Long>list(words.get("tod_obs")));
    timeDelayObs = new TreeSet<>(Words.<Long>list(words.get("dint_obs")));
    externalObs = new TreeSet<>(Words.<Long>list(words.get("external")));
    faultyObs = new TreeSet<>(Words.<Long>list(words.get("faulty")));
    for (List<Object> pair : Words.<List<Object>>list(words.get("classes"))) {
      classes.put((String) pair.get(0), map(pair.get(1)));
    }
    unknown = map(words.get("unknown"));
    local = list(words.get("local"));
    numbered = list(words.get("numbered"));
    numbers = new TreeSet<>(Words.<Long>list(words.get("numbers")));
    for (List<Object> row : Words.<List<Object>>list(words.get("events"))) {
      eventClasses.put((String) row.get(0), List.of((Long) row.get(1), (Long) row.get(2)));
    }
    queuedObs = new TreeSet<>(Words.<Long>list(words.get("queued")));
  }

  @SuppressWarnings("unchecked")
  private static <T> List<T> list(Object list) {
    return (List<T>) list;
  }

  private static <K, V> TreeMap<K, TreeSet<V>> map(Object pairs) {
    var map = new TreeMap<K, TreeSet<V>>();
    for (List<Object> pair : Words.<List<Object>>list(pairs)) {
      @SuppressWarnings("unchecked")
      var key = (K) pair.get(0);
      map.put(key, new TreeSet<>(Words.<V>list(pair.get(1))));
    }
    return map;
  }
}
