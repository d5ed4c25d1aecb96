package s7.log;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.regex.Pattern;

/**
 * Programs of the kit, {@code s7-interrupt-program/1}, and what a CPU offers to them. They are read to themselves with
 * one spelling for each value: words, bytes and TIMEs are integers, dates {@code 2026-11-21T06:00:00.000}.
 */
final class Programs {
  private static final String FORMAT = "s7-interrupt-program/1";
  private static final String ANY_FORMAT = "s7-interrupt-program/";

  /** How a program, or a list of programs, begins whose format comes first. */
  private static final Pattern BEGUN =
      Pattern.compile("[\\s\\[]*\\{[^{]*\"format\"\\s*:\\s*\"" + ANY_FORMAT);

  /** Fields of a log's header that a program gives; the others are the implementation's own. */
  static final List<String> OF_HEADER =
      List.of("cpu", "obs", "clock", "mode", "cycle", "priority", "step7", "zone", "classes", "queue");

  /** Milliseconds: the years that the CPU clock can show. */
  private static final long LONGEST = 100L * 366 * 86_400_000;

  private static final Reader SAME = value -> value;
  private static final Reader ELAPSED = Spellings.integer(0, LONGEST);
  private static final Reader SPAN = Spellings.integer(1, LONGEST);
  private static final Reader REQUIREMENTS =
      Table.list(matching("[A-Z]{1,5}[0-9]{0,2}-[0-9]{2,3}", "a requirement such as \"AIRT-03\""));
  private static final Reader TEXT =
      value -> {
        if (value instanceof String text && !text.isBlank() && text.indexOf('\n') < 0) {
          return value;
        }
        throw new Unusable("a text of one line", Quoting.quote(value));
      };
  private static final Reader PASSED_DATE = value -> Days.spelled(Spellings.parts(value));
  private static final Reader DATE = value -> Days.iso(Spellings.instant(value));
  private static final Reader END =
      value -> {
        if (Boolean.TRUE.equals(value)) {
          return value;
        }
        throw new Unusable("true", Quoting.quote(value));
      };

  private final Header header;
  private final Events events;
  private final Map<String, Reader> outside = new LinkedHashMap<>();
  private final Map<String, Reader> own = new LinkedHashMap<>();
  private final Map<String, Reader> calls = new LinkedHashMap<>();
  private final Reader waiting = whole(new Table("step wait", Table.of("wait", ELAPSED), Map.of()));
  private final Reader ending = whole(new Table("step end", Table.of("end", END), Map.of()));
  private final Reader body;
  private final Reader program;
  private final Table offer;

  /** OBs behind it have the event class that the header gives them. */
  private final long lastOb;

  Programs(Words words, Header header, Events events) {
    this.header = header;
    this.events = events;
    Map<String, Reader> none = Map.of();
    lastOb = words.obs.last();
    Reader ob = Spellings.integer(words.obs.first(), words.numbers.last());
    event("clock", none, Table.of("to", DATE, "by", Spellings.integer(-LONGEST, LONGEST)));
    event(Events.LOCAL_TIME, events.required(Events.LOCAL_TIME), none);
    event("interrupt", events.required("interrupt"), Table.of(Events.FAULT, Spellings.BYTE));
    for (String name : new String[] {"load", "delete", "restart"}) {
      event(name, events.required(name), none);
    }
    for (String name : new String[] {"stop", "hold", "release"}) {
      event(name, none, none);
    }
    event("state", Table.of("ob", ob), none);
    own.keySet().retainAll(List.of("clock", Events.LOCAL_TIME, "state"));
    for (String name : events.calls()) {
      var operands = Table.of("call", SAME);
      operands.putAll(events.required(name));
      operands.remove(Events.RET);
      operands.replace("sdt", PASSED_DATE);
      operands.replace("local", Spellings.TRUTH);
      operands.replace("activate", Spellings.TRUTH);
      calls.put(name, whole(new Table("call of " + name, operands, none)));
    }
    body =
        whole(
            new Table(
                "body",
                Table.of("ob", ob, "steps", each(this::step)),
                Table.of("run", Spellings.integer(1, Integer.MAX_VALUE))));
    Reader reaches = new Table("reaches", Table.of("requirements", REQUIREMENTS, "guards", Table.list(TEXT)), none);
    program =
        whole(
            new Table(
                "program",
                Table.of(
                    "format", Spellings.choice(FORMAT),
                    "name", matching("[A-Za-z0-9][A-Za-z0-9._-]{0,99}", "a name of letters, digits, '.', '_' and '-'"),
                    "about", TEXT,
                    "requirements", REQUIREMENTS,
                    "header", (Reader) this::header,
                    "duration", SPAN,
                    "bodies", (Reader) this::bodies),
                Table.of(
                    "reaches", reaches,
                    "catches", TEXT,
                    "seed", Spellings.integer(0, Long.MAX_VALUE),
                    "outside", each(value -> event(value, outside)))));
    offer =
        new Table(
            "offer",
            none,
            Table.of(
                "cpu", Table.list(Spellings.choice(words.families)),
                "obs", Table.list(ob),
                "calls", Table.list(Spellings.choice(calls.keySet())),
                "outside", Table.list(Spellings.choice(outside.keySet())),
                "modes", Table.list(Header.MODE),
                "deselected", Spellings.TRUTH,
                "cycle", Spellings.TRUTH,
                "diag", Spellings.TRUTH,
                "loaded", Table.list(ob),
                "longest", Spellings.integer(1, 1L << 53)));
  }

  /** Enters an event with its required and its optional fields: as one from outside, and as a step. */
  private void event(String name, Map<String, Reader> required, Map<String, Reader> optional) {
    var fields = Table.of("event", SAME);
    fields.putAll(required);
    own.put(name, whole(new Table("step " + name, fields, optional)));
    var timed = Table.of("after", ELAPSED);
    timed.putAll(fields);
    var repeated = Table.of("every", SPAN);
    repeated.putAll(optional);
    outside.put(name, whole(new Table("outside event " + name, timed, repeated)));
  }

  /** The programs of a text: one, or one a line; none in any other text. A damaged one counts: its reader refuses it. */
  static List<Fields> in(String text) {
    var found = new ArrayList<Fields>();
    if (!text.contains(ANY_FORMAT)) {
      return found;
    }
    List<String> lines = Arrays.stream(text.split("\n")).filter(line -> !line.isBlank()).toList();
    if (lines.size() > 1 && isProgram(parsed(lines.get(0)))) {
      lines.forEach(line -> found.add(named("program " + (found.size() + 1), line)));
    } else if (isProgram(parsed(text)) || BEGUN.matcher(text).lookingAt()) {
      found.add(named("program", text));
    }
    return found;
  }

  private static Fields named(String name, String text) {
    Fields raw = parsed(text);
    return new Fields()
        .put("name", raw.get("name") instanceof String given ? given : name)
        .put("about", raw.get("about") instanceof String about ? about : "")
        .put("text", text);
  }

  /** The object of a text; an empty one if it has none. */
  private static Fields parsed(String text) {
    try {
      return Fields.of(text.getBytes(StandardCharsets.UTF_8));
    } catch (Unusable wrong) {
      return new Fields();
    }
  }

  private static boolean isProgram(Fields raw) {
    return raw.get("format") instanceof String format && format.startsWith(ANY_FORMAT);
  }

  /** The program of an object. */
  Fields program(Fields raw) {
    if (!(raw.get("format") instanceof String)) {
      throw new Unusable("a program, with \"format\": \"" + FORMAT + "\"", "none", "format");
    }
    var read = (Fields) program.read(raw);
    Fields classes = read.object("header").get("classes") instanceof Fields given ? given : new Fields();
    String cpu = read.object("header").text("cpu");
    for (String list : new String[] {"bodies", "outside"}) {
      checkEach(read, list, each -> {
        Object ob = each.get("ob");
        if (ob instanceof Long number && number > lastOb && !classes.has(ob.toString())) {
          throw new Unusable("one of the header's \"classes\"", "OB " + ob, "ob");
        }
        checkLocal(each, cpu);
        checkEach(each, "steps", step -> checkLocal(step, cpu));
      });
    }
    return read;
  }

  private void checkLocal(Fields step, String cpu) {
    if (Events.LOCAL_TIME.equals(step.get("event"))) {
      events.checkLocal(cpu);
    }
  }

  /** Checks each object of a list, if there is one; an error names its place. */
  private static void checkEach(Fields of, String list, Consumer<Fields> check) {
    if (!of.has(list)) {
      return;
    }
    Reader checked =
        value -> {
          check.accept((Fields) value);
          return value;
        };
    try {
      each(checked).read(of.get(list));
    } catch (Unusable wrong) {
      throw wrong.inside(list);
    }
  }

  /** What a CPU offers: lists of names or numbers, yes or no, and the milliseconds of the {@code longest} program. */
  Fields offer(Fields raw) {
    return offer.read(raw);
  }

  private Object header(Object value) {
    Fields raw = object(value);
    for (int i = 0; i < raw.size(); i++) {
      if (!OF_HEADER.contains(raw.name(i)) && !raw.name(i).startsWith(Table.OWN)) {
        throw new Unusable("one of " + String.join(", ", OF_HEADER), "an unknown field", raw.name(i));
      }
    }
    header.read(raw.without().put("format", Header.FORMAT), null);
    Fields read = raw.without().put("clock", DATE.read(raw.get("clock")));
    return raw.has("step7") ? read.put("step7", step7(raw.object("step7"))) : read;
  }

  /** The parameters, which the header's reader has taken, with their start points in one spelling. */
  private static Fields step7(Fields raw) {
    Fields read = raw.without();
    if (raw.get("tod") instanceof Fields parameters) {
      var all = new Fields();
      for (int i = 0; i < parameters.size(); i++) {
        var one = (Fields) parameters.value(i);
        boolean starts = one.get("start") != null;
        all.add(parameters.name(i), starts ? one.without().put("start", DATE.read(one.get("start"))) : one);
      }
      read.put("tod", all);
    }
    return read;
  }

  private Object event(Object value, Map<String, Reader> kinds) {
    Fields event = (Fields) known(object(value), "event", kinds);
    if (event.get("event").equals("clock") && event.has("to") == event.has("by")) {
      throw new Unusable("one of to and by", event.has("to") ? "both" : "none");
    }
    if (event.get("event").equals("interrupt")) {
      events.checkFault(event);
    }
    return event;
  }

  private Object step(Object value) {
    Fields step = object(value);
    if (step.has("call")) {
      return known(step, "call", calls);
    }
    if (step.has("event")) {
      return event(step, own);
    }
    if (step.has("wait")) {
      return waiting.read(step);
    }
    if (step.has("end")) {
      return ending.read(step);
    }
    throw new Unusable("a step with call, wait, event or end", "none of them");
  }

  private Object body(Object value) {
    var read = (Fields) body.read(value);
    var steps = (List<?>) read.get("steps");
    for (int i = 0; i < steps.size() - 1; i++) {
      if (((Fields) steps.get(i)).has("end")) {
        throw new Unusable("end as the last step", "steps behind it", "steps");
      }
    }
    return read;
  }

  private Object bodies(Object value) {
    var bodies = (List<?>) each(this::body).read(value);
    var runs = new HashSet<String>();
    for (Object each : bodies) {
      var one = (Fields) each;
      String run = "OB " + one.get("ob") + ", " + (one.has("run") ? "run " + one.get("run") : "every other run");
      if (!runs.add(run)) {
        throw new Unusable("one body for each OB and run", "two of " + run);
      }
    }
    return bodies;
  }

  private static Object known(Fields raw, String field, Map<String, Reader> kinds) {
    Object name = raw.get(field);
    if (name instanceof String && kinds.containsKey(name)) {
      return kinds.get(name).read(raw);
    }
    String found = raw.has(field) ? Quoting.quote(name) : "none";
    throw new Unusable(String.join(" or ", kinds.keySet()), found, field);
  }

  private static Fields object(Object value) {
    if (value instanceof Fields fields) {
      return fields;
    }
    throw new Unusable("an object", Quoting.quote(value));
  }

  /** The fields of a table in their order, with the implementer's own. */
  private static Reader whole(Table table) {
    return value -> {
      Fields read = table.read(value);
      return ((Fields) value).without().with(read);
    };
  }

  /** A reader of lists; an error names the place of the element, from 1. */
  private static Reader each(Reader reader) {
    return value -> {
      if (!(value instanceof List<?> list)) {
        throw new Unusable("a list", Quoting.quote(value));
      }
      var elements = new ArrayList<Object>();
      for (Object element : list) {
        try {
          elements.add(reader.read(element));
        } catch (Unusable wrong) {
          throw wrong.inside(String.valueOf(elements.size() + 1));
        }
      }
      return elements;
    };
  }

  private static Reader matching(String pattern, String expected) {
    Pattern compiled = Pattern.compile(pattern);
    return value -> {
      if (value instanceof String text && compiled.matcher(text).matches()) {
        return value;
      }
      throw new Unusable(expected, Quoting.quote(value));
    };
  }
}
