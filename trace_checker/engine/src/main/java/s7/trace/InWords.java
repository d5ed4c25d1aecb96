package s7.trace;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

import s7.log.Fields;
import tla.spec.Guards;

/** Situations, and parts of refusals, in words for people. */
final class InWords {
  private static final int NO_CAUSE = -1;
  private static final int MOST = 12;

  /** In words; which codes there are, and when each comes round, the specification says. */
  private static final Map<Integer, String> PERIODS =
      Map.of(
          0x0000, "once", 0x0201, "every minute", 0x0401, "hourly", 0x1001, "daily", 0x1201, "weekly",
          0x1202, "weekly", 0x1401, "monthly", 0x1801, "yearly", 0x2001, "at the end of the month");

  private InWords() {}

  /** The situations, each with what is {@code said} about it. */
  static List<Fields> withWords(Collection<?> situations) {
    List<Fields> all = Work.objects(situations);
    all.forEach(one -> one.put("said", situation(one)));
    return all;
  }

  /** The statements about a situation, each with its topic; empty ones are left out, but for the running OBs. */
  static List<List<String>> situation(Fields state) {
    var said = new ArrayList<List<String>>();
    said.add(List.of("mode", state.text("mode") + ", clock " + moment(state.get("clock"))));
    said.add(List.of("running", running(state.list("running"))));
    if (state.number("delay") > 0) {
      said.add(List.of("delayed", state.number("delay") + " DIS_AIRT not taken back"));
    }
    for (Fields request : Work.objects(state.list("pending"))) {
      said.add(List.of("pending", pending(request, state)));
    }
    for (Fields tod : Work.objects(state.list("tod"))) {
      said.add(List.of("set", timeOfDay(tod)));
    }
    for (Fields job : Work.objects(state.list("dint"))) {
      said.add(List.of("started", delay(job)));
    }
    ranges(said, "blocked", state.list("blocked"), " by DIS_IRT");
    ranges(said, "no entries", state.list("silenced"), " by DIS_IRT");
    int stop = state.number("stop");
    if (stop != NO_CAUSE) {
      said.add(List.of("STOP", "must come" + (stop == 0 ? "" : " for " + Spelled.hex(stop, 4))));
    }
    String back = broughtBack(state.object("kept"));
    if (!back.isEmpty()) {
      said.add(List.of("hot restart", "brings back " + back));
    }
    said.add(List.of("loaded", "OB " + ranges(state.list("loaded"))));
    return said;
  }

  private static String broughtBack(Fields kept) {
    var said = new ArrayList<String>();
    if (!kept.list("running").isEmpty()) {
      said.add(running(kept.list("running")));
    }
    if (kept.number("delay") > 0) {
      said.add(kept.number("delay") + " DIS_AIRT not taken back");
    }
    for (var how : List.of("pending", "dint")) {
      if (!kept.list(how).isEmpty()) {
        said.add("OB " + ranges(kept.list(how)) + (how.equals("dint") ? " started" : " pending"));
      }
    }
    return String.join("; ", said);
  }

  private static String moment(Object at) {
    String text = Spelled.moment(at);
    return ((Fields) at).number("ms") == 0 ? text.substring(0, 16) : text;
  }

  private static String running(List<?> frames) {
    if (frames.isEmpty()) {
      return "nothing";
    }
    var texts = new ArrayList<String>();
    for (Fields frame : Work.objects(frames)) {
      texts.add(0, "OB " + frame.number("ob") + " (class " + frame.number("class") + ")");
    }
    String below = String.join(", ", texts.subList(1, texts.size()));
    return texts.get(0) + (below.isEmpty() ? "" : ", interrupting " + below);
  }

  private static String pending(Fields request, Fields state) {
    int number = request.number("class");
    var text = new StringBuilder("OB " + request.number("ob") + " (class " + number + ") since ");
    text.append(moment(request.get("since")));
    if (request.number("fault") > 0) {
      text.append(", fault ").append(Spelled.hex(request.number("fault"), 2));
    }
    if (request.number("cause") != 0) {
      text.append(" because of OB ").append(request.number("cause"));
    }
    if (!request.list("late").isEmpty()) {
      text.append(", for OB ").append(ranges(request.list("late")));
    }
    if (truth(request, "open")) {
      text.append(", which may also come to nothing");
    }
    if (truth(request, "missing")) {
      text.append(", not loaded");
    }
    if (truth(request, "ready")) {
      text.append(", may start");
      for (Object pair : state.list("waited")) {
        if (Spelled.number(((List<?>) pair).get(0)) == number) {
          text.append(" for ").append(((List<?>) pair).get(1)).append(" ms, latency ");
          text.append(state.number("latency")).append(" ms");
        }
      }
    }
    return text.toString();
  }

  private static boolean truth(Fields object, String name) {
    return Boolean.TRUE.equals(object.get(name));
  }

  private static String timeOfDay(Fields tod) {
    String period =
        PERIODS.getOrDefault(tod.number("period"), "PERIOD " + Spelled.hex(tod.number("period"), 4));
    return "OB " + tod.number("ob") + " " + period + " from " + moment(tod.get("start"))
        + (truth(tod, "active") ? ", active" : ", not active")
        + (truth(tod, "armed") ? ", next point " + moment(tod.get("next")) : "");
  }

  private static String delay(Fields job) {
    return job.number("left") < 0
        ? "OB " + job.number("ob") + ", its delay over and lost"
        : "OB " + job.number("ob") + " after " + job.number("dtime") + " ms, " + job.number("left") + " ms left, SIGN "
            + Spelled.hex(job.number("sign"), 4);
  }

  private static void ranges(List<List<String>> said, String topic, List<?> obs, String by) {
    if (!obs.isEmpty()) {
      said.add(List.of(topic, "OB " + ranges(obs) + by));
    }
  }

  /** Texts in one, and how many more there are. */
  static String few(List<String> texts) {
    int more = texts.size() - MOST;
    String few = String.join(", ", texts.subList(0, Math.min(MOST, texts.size())));
    return more > 0 ? few + " and " + more + " more" : few;
  }

  /** Such as {@code 1, 10-17, 80}. */
  static String ranges(Collection<?> numbers) {
    var parts = new TreeMap<Integer, Integer>();
    for (int number : numbers.stream().map(Spelled::number).collect(Collectors.toCollection(TreeSet::new))) {
      boolean next = !parts.isEmpty() && parts.lastEntry().getValue() == number - 1;
      parts.put(next ? parts.lastKey() : (Integer) number, number);
    }
    return parts.entrySet().stream()
        .map(part -> part.getKey() + (part.getKey().equals(part.getValue()) ? "" : "-" + part.getValue()))
        .collect(Collectors.joining(", "));
  }

  /** What had to come before the line; the moment is that of a start event that could have started its OB. */
  static String late(Fields allowed, List<Fields> situations) {
    String since = "";
    for (Fields state : situations) {
      for (Fields request : Work.objects(state.list("pending"))) {
        for (Object pair : state.list("waited")) {
          int number = Spelled.number(((List<?>) pair).get(0));
          if (since.isEmpty()
              && request.number("ob") == Spelled.given(allowed, "ob")
              && truth(request, "ready")
              && request.number("class") == number) {
            long waited = ((Number) ((List<?>) pair).get(1)).longValue();
            since = " of " + s7.log.Days.iso(Spelled.milliseconds(state.get("clock")) - waited);
          }
        }
      }
    }
    return Spelled.allowed(allowed) + ", within " + situations.get(0).number("latency") + " ms" + since;
  }

  /** The actions of which there is something to say: they are about this event, and had something to act on. */
  static Collection<Guards.Failure> telling(Collection<Guards.Failure> all) {
    var ofThisEvent = all.stream().filter(one -> !one.conjunct().startsWith("e.event ")).toList();
    var telling =
        ofThisEvent.stream()
            .filter(one -> !"the set is empty".equals(one.values()) && !"FALSE".equals(one.conjunct()))
            .toList();
    return !telling.isEmpty() ? telling : !ofThisEvent.isEmpty() ? ofThisEvent : all;
  }

  /** A sentence, the condition that is false, the values of its operands, the requirements and the place. */
  static String formula(Guards.Failure one) {
    var names = new ArrayList<>(one.requirements());
    names.add(one.place());
    return one.action() + " does not explain the line, since a condition is false: " + one.conjunct()
        + (one.values().isEmpty() ? "" : "; here " + one.values()) + " [" + String.join(", ", names) + "]";
  }
}
