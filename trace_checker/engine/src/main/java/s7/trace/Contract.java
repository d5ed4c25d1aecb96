package s7.trace;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

import s7.log.Fields;
import s7.log.Format;
import tla.eval.State;
import tla.eval.Way;
import tla.spec.Decisions;
import tla.spec.Guards;
import tla.spec.Specification;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.SetEnumValue;
import tlc2.value.impl.StringValue;
import tlc2.value.impl.Value;
import util.UniqueString;

/**
 * The engine's contract with the specification: the module, the operators and the fields that it
 * needs, each under its name there. No other class names them, and a test compares them with the
 * modules.
 *
 * <p>A state is a CPU that explains the log so far, an event is a line of the log, a record like
 * NoEvent.
 */
public final class Contract {
  /** The module that has all operators, with a configuration of the same name. */
  public static final String MODULE = "Explain";

  /** An operator and the number of its parameters. */
  enum Operator {
    INIT("Init", 0),
    NO_HEADER("NoHeader", 0),
    NO_EVENT("NoEvent", 0),
    WORDS("Words", 0),
    ALTERNATIVES("Alternatives", 0),
    NOT_COVERED("NotCovered", 1),
    BEGIN("Begin", 1),
    ARRIVED("Arrived", 1),
    ELAPSE("Elapse", 1),
    STIRS("Stirs", 1),
    SILENT("Silent", 1),
    OBSERVE("Observe", 1),
    PARTIAL("Partial", 0),
    LOOSE("Loose", 0),
    LOOSEN("Loosen", 0),
    LAST_RESORT("LastResort", 0),
    CROWD("Crowd", 0),
    MEETING_PLACE("MeetingPlace", 0),
    WAITS("Waits", 0),
    MEET("Meet", 1),
    DISTINCT("Distinct", 0),
    DISTINCT_AFTER_LINE("DistinctAfterLine", 0),
    DISTANCE("Distance", 1),
    LATE_DISTANCE("LateDistance", 1),
    SITUATION("Situation", 0),
    EXPECTED("Expected", 1),
    DECIDING("Deciding", 2),
    TOO_LATE("TooLate", 1),
    LATE_REQUIREMENTS("LateRequirements", 2),
    NEXT_LINES("NextLines", 0),
    WITH_ANSWERS("WithAnswers", 1),
    LIKEWISE("Likewise", 1),
    DATED("Dated", 2),
    TIME_OF("TimeOf", 1),
    PRESENT("Present", 0),
    END_OF_TIME("EndOfTime", 0),
    LAST_IN_TIME("LastInTime", 0),
    TOO_LATE_NOW("TooLateNow", 0),
    WHY_POSSIBLE("WhyPossible", 2),
    GENERALITY("Generality", 1);

    final String tla;
    final int arity;

    Operator(String tla, int arity) {
      this.tla = tla;
      this.arity = arity;
    }
  }

  /** The operator that gives the letter of an open question, its last argument. */
  static final String READING = "ReadingOf";

  /** Variables and fields whose integers are times; the engine is slower where one is missing. */
  public static final Set<String> TIMES =
      Set.of("min", "ms", "left", "next", "age", "from", "to", "waiting");

  /** The fields of an event that tell kinds of line apart. */
  static final List<String> KIND = List.of("event", "ob", "mode");

  /** The fields of an event with the clock at the line, and the time elapsed. */
  static final String AT = "at";

  static final String UP = "up";

  /** The fields of an event that say when it comes. */
  static final String[] OF_TIME = {AT, UP, "counter", "step", "until"};

  /** The fields of a point in time. */
  static final String MINUTES = "min";

  static final String MILLISECONDS = "ms";

  /** The field by which a report names a record that an action is applied to. */
  static final String OB = "ob";

  /** The most steps of time, and the most states before the event, that {@link #alone} is for. */
  private static final int MOST_ALONE = 8;

  /** The event by which an OB starts. */
  private static final UniqueString START = UniqueString.uniqueStringOf("start");

  /** The two ways in which a line can have no explanation. */
  enum Failing {
    /** An event had to come before the line. */
    TOO_LATE(
        Operator.ELAPSE, Operator.LATE_DISTANCE, Operator.TOO_LATE, Operator.LATE_REQUIREMENTS),
    /** The line itself is not possible. */
    UNEXPLAINED(Operator.OBSERVE, Operator.DISTANCE, Operator.EXPECTED, Operator.DECIDING);

    private final Operator action;
    private final Operator distance;
    private final Operator expected;
    private final Operator deciding;

    Failing(Operator action, Operator distance, Operator expected, Operator deciding) {
      this.action = action;
      this.distance = distance;
      this.expected = expected;
      this.deciding = deciding;
    }
  }

  /** The operators that explain a log. */
  private static final List<Operator> EXPLAINING =
      List.of(
          Operator.BEGIN,
          Operator.ELAPSE,
          Operator.SILENT,
          Operator.OBSERVE,
          Operator.LOOSEN,
          Operator.LAST_RESORT);

  private final Specification spec;
  private final List<Decisions.Decision> decisions;
  private final State blank;
  private final RecordValue noEvent;
  private final Records records;
  private final int kindPlace;
  private final Way alone;
  private Format format;
  private final Map<String, Integer> generality = new HashMap<>();

  /** As the other one, with states that tell nothing of decisions. */
  Contract(Specification spec) {
    this(spec, false);
  }

  /**
   * @param tells whether states tell the outcomes of decisions, which is slower
   * @throws IllegalStateException if the specification has no NoEvent
   */
  Contract(Specification spec, boolean tells) {
    this.spec = spec;
    spec.watch(READING);
    var explaining = EXPLAINING.stream().map(each -> each.tla).collect(Collectors.toSet());
    decisions = tells ? spec.tellDecisions(explaining).described() : List.of();
    blank = spec.initialState(Operator.INIT.tla);
    noEvent = (RecordValue) value(Operator.NO_EVENT, blank);
    records = new Records(noEvent);
    kindPlace = Values.place(noEvent, KIND.get(0));
    alone = spec.remembered(this::goAlone);
  }

  /** The record for no event at all. */
  RecordValue noEvent() {
    return noEvent;
  }

  /** The record for a normalised header. */
  Value header(Fields header) {
    return Values.like(value(Operator.NO_HEADER, blank), header);
  }

  /** The record for an event as the reader of logs gives it. */
  RecordValue event(Fields event) {
    return records.of(event);
  }

  /** The name of an event. */
  Object name(RecordValue event) {
    return Values.field(event, KIND.get(0));
  }

  /** The words of a log, as {@link #format} has them, with what else the specification tells of them. */
  Fields alternatives() {
    return words().with(Values.object(value(Operator.ALTERNATIVES, blank)));
  }

  private Fields words() {
    return Values.object(value(Operator.WORDS, blank));
  }

  /** How a log is read. */
  Format format() {
    if (format == null) {
      format = new Format(words());
    }
    return format;
  }

  /**
   * The decisions of the operators that explain a log, if states tell of them. The outcomes of a state ({@link
   * State#commonOutcomes}) count by their places in this list.
   */
  List<Decisions.Decision> decisions() {
    return decisions;
  }

  /** The parts of a header that the specification does not have. */
  List<?> notCovered(Value header) {
    return array(Operator.NOT_COVERED, blank, header);
  }

  /** The states in which a log with this header may begin. */
  List<State> begin(Value header) {
    return successors(Operator.BEGIN, blank, header);
  }

  /** Whether the log leaves kinds of event out. */
  boolean partial(State state) {
    return spec.holds(Operator.PARTIAL.tla, state);
  }

  /** Whether definite facts alone count. */
  boolean loose(State state) {
    return spec.holds(Operator.LOOSE.tla, state);
  }

  /** Whether time has elapsed to the event. */
  boolean arrived(State state, Value event) {
    return spec.holds(Operator.ARRIVED.tla, state, event);
  }

  /** One step of time towards the event. */
  List<State> elapse(State state, Value event) {
    return successors(Operator.ELAPSE, state, event);
  }

  /** Whether a silent step may be possible: a cheap question before {@link #silent}. */
  boolean stirs(State state, Value event) {
    return spec.holds(Operator.STIRS.tla, state, event);
  }

  /** One step that the log does not show, just before the event. */
  List<State> silent(State state, Value event) {
    return successors(Operator.SILENT, state, event);
  }

  /** The states after the event; none if it is not possible in this state. */
  List<State> observe(State state, Value event) {
    return successors(Operator.OBSERVE, state, event);
  }

  /**
   * The states after the event, where a single state gets to it in few steps; else none. It is the
   * usual case, and faster than step by step.
   */
  List<State> alone(State state, Value event) {
    return alone.from(state, event);
  }

  private List<State> goAlone(State from, Value event) {
    State state = from;
    for (int steps = 0; !arrived(state, event); steps++) {
      List<State> next = elapse(state, event);
      if (next.size() != 1 || steps == MOST_ALONE) {
        return List.of();
      }
      state = next.get(0);
    }
    var ready = new ArrayList<>(List.of(state));
    var seen = new HashSet<Long>();
    for (int i = 0; i < ready.size(); i++) {
      if (!stirs(ready.get(i), event)) {
        continue;
      }
      for (State next : silent(ready.get(i), event)) {
        if (seen.isEmpty()) {
          seen.add(key(state));
        }
        if (seen.add(key(next))) {
          ready.add(next);
        }
      }
      if (ready.size() > MOST_ALONE) {
        return List.of();
      }
    }
    var after = new ArrayList<State>();
    for (State each : ready) {
      after.addAll(observe(each, event));
    }
    return after;
  }

  /** The state with its definite facts alone; none where everything has to be followed. */
  List<State> loosen(State state) {
    return successors(Operator.LOOSEN, state);
  }

  /** As {@link #loosen}, also where nobody can follow everything. */
  List<State> lastResort(State state) {
    return successors(Operator.LAST_RESORT, state);
  }

  /** The state with less in it, which allows at least as much; none if there is nothing to gain. */
  List<State> crowd(State state) {
    return successors(Operator.CROWD, state);
  }

  /** A number that is the same for states that can {@link #meet}. */
  long meetingPlace(State state) {
    return spec.key(Operator.MEETING_PLACE.tla, state);
  }

  /** One state that allows at least what each of these allows; none where that cannot be said. */
  List<State> meet(List<State> states) {
    var waits = new Value[states.size()];
    for (int i = 0; i < waits.length; i++) {
      waits[i] = value(Operator.WAITS, states.get(i));
    }
    return successors(Operator.MEET, states.get(0), new SetEnumValue(waits, false));
  }

  /** A number that is the same for states that explain the rest of every log alike. */
  long key(State state) {
    return spec.key(Operator.DISTINCT.tla, state);
  }

  /** As {@link #key}, for a state between two lines. */
  long keyAfterLine(State state) {
    return spec.key(Operator.DISTINCT_AFTER_LINE.tla, state);
  }

  /** How far a state is from one in which the event would be possible. */
  int distance(Failing failing, State state, Value event) {
    return ((IntValue) value(failing.distance, state, event)).val;
  }

  /** The state as a report shows it. */
  Fields situation(State state) {
    return Values.object(spec.aside(() -> value(Operator.SITUATION, state)));
  }

  /** Begins a log for {@link #asked}. */
  void forgetAsked() {
    spec.forgetAsked();
  }

  /**
   * The open questions whose letter anything depended on since then, but for situations; null if it may
   * have depended on others.
   */
  Set<String> asked() {
    return spec.asked();
  }

  /** The number of the OB that the event starts; null for another event. */
  Object startedOb(RecordValue event) {
    return ((StringValue) event.values[kindPlace]).val == START ? Values.field(event, OB) : null;
  }

  /** The priority class that runs. */
  int runningClass(State state) {
    List<?> running = situation(state).list("running");
    return ((Fields) running.get(running.size() - 1)).number("class");
  }

  /** The events that were possible in the place of the failing one, or had to come before it. */
  List<Fields> expected(Failing failing, State state, Value event) {
    List<Fields> expected = Work.objects(array(failing.expected, state, event));
    expected.forEach(one -> one.put("text", Spelled.allowed(one)));
    return expected;
  }

  /**
   * The requirements that decide that the event fails.
   *
   * @param past the lines before it, as {@link Past} keeps them
   */
  List<?> deciding(Failing failing, State state, Value event, Value past) {
    return array(failing.deciding, state, event, past);
  }

  /** The actions that are not enabled, each with its first false conjunct. */
  Set<Guards.Failure> failures(Failing failing, State state, Value event) {
    return spec.failures(failing.action.tla, Contract::label, Spelled::numbers, state, event);
  }

  /** Lines without a time that come into question after this state. */
  List<Value> nextLines(State state) {
    return Values.elements(value(Operator.NEXT_LINES, state));
  }

  /** The line with each value that the CPU may give with it in this state. */
  List<Value> withAnswers(State state, Value event) {
    return Values.elements(value(Operator.WITH_ANSWERS, state, event));
  }

  /** A line before which the same silent steps are possible, in this state, as before {@code event}. */
  Value likewise(State state, Value event) {
    return value(Operator.LIKEWISE, state, event);
  }

  /** The same in all of these states; the line itself if they do not agree. */
  Value likewise(List<State> states, Value event) {
    Value kind = null;
    for (State state : states) {
      Value here = likewise(state, event);
      if (kind != null && !kind.equals(here)) {
        return event;
      }
      kind = here;
    }
    return kind;
  }

  /** The line at a time, which {@link #present} and the operators below it give. */
  RecordValue dated(Value event, Value time) {
    return (RecordValue) value(Operator.DATED, blank, event, time).toRcd();
  }

  /** A line of no kind at a time. */
  RecordValue instant(Value time) {
    return dated(noEvent, time);
  }

  /** Both clocks of the line. */
  Value timeOf(Value event) {
    return value(Operator.TIME_OF, blank, event);
  }

  /** Both clocks of the state. */
  Value present(State state) {
    return value(Operator.PRESENT, state);
  }

  /** The last time that a log can have. */
  Value endOfTime(State state) {
    return value(Operator.END_OF_TIME, state);
  }

  /** The last time at which nothing is late that the state waits for. */
  Value lastInTime(State state) {
    return value(Operator.LAST_IN_TIME, state);
  }

  /** A time at which everything is late that the state waits for. */
  Value tooLateNow(State state) {
    return value(Operator.TOO_LATE_NOW, state);
  }

  /** The requirements by which the line is possible in this state. */
  List<?> whyPossible(State state, Value event, Value past) {
    return array(Operator.WHY_POSSIBLE, state, event, past);
  }

  /** An empty set of requirements, in the order in which they are cited: those that decide most come first. */
  TreeSet<String> requirements() {
    return new TreeSet<>(Comparator.comparingInt(this::generality).thenComparing(Comparator.naturalOrder()));
  }

  private int generality(String requirement) {
    return generality.computeIfAbsent(
        requirement,
        id -> ((IntValue) value(Operator.GENERALITY, blank, new StringValue(id))).val);
  }

  /** The event as an object, without the fields that it does not give. */
  Fields given(Value event) {
    return Values.given((RecordValue) event.toRcd(), noEvent);
  }

  /** Such as {@code OB 40}; null for a record that no OB belongs to. */
  private static String label(RecordValue record) {
    return Values.field(record, OB) instanceof Integer ob ? "OB " + ob : null;
  }

  private Value value(Operator operator, State state, Value... arguments) {
    return spec.value(operator.tla, state, arguments);
  }

  private List<State> successors(Operator operator, State state, Value... arguments) {
    return spec.successors(operator.tla, state, arguments);
  }

  private List<?> array(Operator operator, State state, Value... arguments) {
    return (List<?>) Values.toJson(value(operator, state, arguments));
  }
}
