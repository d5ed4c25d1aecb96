package s7.trace;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

import s7.log.Fields;
import tlc2.value.impl.Value;

/**
 * All that is shown of a log after a line: the situations of the CPU, what may come next, and what somebody might wait
 * for and does not come, with its reason.
 */
final class Look {
  /** Explanations of a log of which the situations are shown. */
  private static final int MOST_SITUATIONS = 8;

  /** Explanations that are looked at for each line that may come; a log that leaves much open has thousands. */
  private static final int SHARE = 16;

  /** Steps of the CPU that somebody might wait for. */
  private static final Set<String> STEPS = Set.of("start", "end", "run", "stop");

  private final Session session;

  Look(Session session) {
    this.session = session;
  }

  /**
   * All but what may not come.
   *
   * @param withOperands calls of which one line is enough
   * @param at the CPU clock at the next line, as a log spells it; null for the first time at which something may come
   * @param only the only events of the lines that may come; all if there is none. {@code events} has the others, too
   */
  Fields answer(Set<String> withOperands, String at, Set<String> only) {
    Collection<Fields> situations = session.situations(MOST_SITUATIONS);
    Fields ahead = session.possible(new Session.Question(List.of(), null, SHARE, Set.of(), Set.of()));
    var times = Work.objects(ahead.list("times"));
    String chosen = at == null ? Spelled.moment(times.get(0).get("at")) : at;
    Fields possible = session.possible(new Session.Question(null, when(chosen), SHARE, only, withOperands));
    return new Fields()
        .put("message", Judging.EXPLAINED)
        .put("clock", session.clock())
        .put("at", chosen)
        .put("situations", situations.stream().map(InWords::situation).toList())
        .put("states", possible.get("states"))
        .put("whole", possible.get("whole"))
        .put("endless", ahead.get("endless"))
        .put("times", times.stream().map(Look::time).toList())
        .put("events", possible.get("events"))
        .put("possible", lines(possible));
  }

  /**
   * The {@code lines} that may come at a time: those of the events {@code only}, of some of which one is enough, or
   * these with their answers; and whether these are the {@code whole} of them.
   */
  Fields lines(String at, List<byte[]> lines, Set<String> only, Set<String> few) {
    List<Value> asked = lines == null ? null : session.timeless(lines);
    Fields possible = session.possible(new Session.Question(asked, when(at), SHARE, only, few));
    return new Fields().put("lines", lines(possible)).put("whole", possible.get("whole"));
  }

  /** A line at that time. */
  private static byte[] when(String at) {
    return text(new Fields().put("event", "hold").put("at", at));
  }

  private static byte[] text(Fields line) {
    return line.toString().getBytes(StandardCharsets.UTF_8);
  }

  private static Fields time(Fields time) {
    return new Fields()
        .put("at", Spelled.moment(time.get("at")))
        .put("due", Work.objects((Collection<?>) time.get("due")).stream().map(one -> one.text("text")).toList())
        .put("requirements", time.get("requirements"));
  }

  private static List<Fields> lines(Fields possible) {
    var lines = new ArrayList<Fields>();
    for (Fields line : Work.objects(possible.list("lines"))) {
      Fields event = line.object("event");
      lines.add(
          new Fields()
              .put("event", event)
              .put("text", Spelled.text(event))
              .put("requirements", line.get("requirements")));
    }
    return lines;
  }

  /**
   * The steps of the CPU that somebody might wait for and that may not come at the time, each with its reason; null
   * where not all explanations are looked at.
   */
  List<Fields> impossible(String at, WhyNot why) {
    Collection<Fields> situations = session.situations(MOST_SITUATIONS);
    Fields possible = session.possible(new Session.Question(null, when(at), SHARE, STEPS, Set.of()));
    if (!Boolean.TRUE.equals(possible.get("whole"))) {
      return null;
    }
    var offered = new HashSet<String>();
    for (Fields line : Work.objects(possible.list("lines"))) {
      offered.add(Spelled.text(line.object("event").without("info")));
    }
    var reasons = new ArrayList<Fields>();
    for (Fields event : lookedFor(situations)) {
      String text = Spelled.text(event);
      if (offered.contains(text) || offered.stream().anyMatch(one -> one.startsWith(text + " "))) {
        continue;
      }
      Fields line = new Fields().put("at", at).with(event);
      Explanation.Refusal refusal = session.judge(text(line));
      if (refusal != null) {
        reasons.add(why.told(refusal, text(line)).put("event", event).put("text", text));
      }
    }
    return reasons;
  }

  /** The starts of all loaded OBs, the ends of running OBs, RUN and STOP. */
  private static List<Fields> lookedFor(Collection<Fields> situations) {
    var starts = new TreeSet<Integer>(Set.of(1));
    var ends = new TreeSet<Integer>();
    for (Fields state : situations) {
      state.list("loaded").forEach(ob -> starts.add(Spelled.number(ob)));
      Work.objects(state.list("running")).forEach(frame -> ends.add(frame.number("ob")));
    }
    var events = new ArrayList<Fields>();
    starts.forEach(ob -> events.add(new Fields().put("event", "start").put("ob", ob)));
    ends.forEach(ob -> events.add(new Fields().put("event", "end").put("ob", ob)));
    events.add(new Fields().put("event", "run"));
    events.add(new Fields().put("event", "stop"));
    return events;
  }
}
