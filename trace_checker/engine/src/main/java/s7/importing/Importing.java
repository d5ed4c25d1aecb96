package s7.importing;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

import s7.log.Fields;
import s7.log.Format;
import s7.log.LogReader;
import s7.log.ProfileFile;
import s7.log.Unusable;

/**
 * Answers about sources, whose bytes come with the message:
 *
 * <ul>
 *   <li>{@code kind}: which {@code kind} of source they are, told by their beginning: {@code step7}, {@code szl},
 *       {@code ring} or {@code program}, null for none; {@code what} that is, in words; and the {@code programs} of the
 *       kit that they hold, with {@code name}, {@code about} and {@code text}.
 *   <li>{@code import} with {@code kind}, the fields {@code given} of the header, which count more than what the source
 *       tells, {@code entries} such as {@code 5-20}, {@code dates} as {@link Step7Text#read} has it, the {@code map} of
 *       a {@link Table}, whose bytes are in UTF-8, and {@code remarks} on the source: the {@code log}, objects, and
 *       {@code told}, lines for people.
 *   <li>{@code entries}: what records of the diagnostic buffer, oldest first, tell one by one: their {@code event}; old
 *       and new mode of a {@code change}; the event {@code told} of the mode, as far as these records tell it; and
 *       whether the {@code power} came back.
 *   <li>{@code mode} with {@code number}: the {@code mode} that a half-byte of the CPU stands for.
 *   <li>{@code ring}: its {@code capacity}, {@code size}, {@code written} and {@code length}, by its header; {@code
 *       slots}: what each tells, as {@link Slot#told} has it; {@code ring events} with {@code elapsed}, empty or as the
 *       answer before had it: the {@code events} of slots, and whether the clock has {@code jumped} before the last.
 *   <li>{@code state} with {@code ob} and {@code al1}, a word of SZL 16#0222: the fields of that line.
 * </ul>
 */
public final class Importing {
  private static final String LOG_FORMAT = "s7-interrupt-log/1";

  /** Required fields of the header, and the options that give them. */
  private static final List<String> REQUIRED = List.of("cpu", "obs", "mode");
  private static final Map<String, String> KINDS =
      Map.of(
          "step7", "the text of a diagnostic buffer",
          "szl", "records of SZL 16#00A0",
          "ring", "the data block of the SCL source",
          "program", "a program of the kit");

  private Importing() {}

  /** The answer to a message of that kind; what cannot be used is {@link Unusable} with its place. */
  public static Fields answer(String message, Fields json, byte[] content, Format format, ProfileFile file) {
    return switch (message) {
      case "kind" -> {
        List<Fields> programs = Format.programsIn(content);
        String kind = programs.isEmpty() ? kindOf(content) : "program";
        yield new Fields().put("kind", kind).put("what", kind == null ? null : KINDS.get(kind)).put("programs", programs);
      }
      case "import" -> log(json, content, format, file);
      case "entries" -> new Fields().put("entries", entries(content));
      case "mode" -> new Fields().put("mode", Modes.ofNibble(json.number("number")));
      case "ring" -> Ring.of(content).told();
      case "slots" ->
          new Fields().put("slots", Slot.all(content, 0, content.length).stream().map(Slot::told).toList());
      case "ring events" -> ringEvents(content, Elapsed.of(json.object("elapsed")));
      case "state" -> Slot.state(json.number("ob"), json.number("al1"), null);
      default -> throw new IllegalArgumentException("an unknown message: " + message);
    };
  }

  private static String kindOf(byte[] begin) {
    if (Step7Text.hasEntry(begin)) {
      return "step7";
    }
    try {
      byte[] raw = Octets.decoded(begin);
      return Ring.begins(raw) ? "ring" : Szl.hasRecord(raw) ? "szl" : null;
    } catch (Unusable wrong) {
      return null;
    }
  }

  private static Fields log(Fields json, byte[] content, Format format, ProfileFile file) {
    Recording.Span chosen = Recording.Span.of(json.text("entries"));
    Recording recording = recording(json, content, chosen);
    json.list("remarks").forEach(remark -> recording.remarks.add((String) remark));
    Fields header = new Fields().put("format", LOG_FORMAT).with(recording.header).with(json.object("given"));
    complete(header);
    var log = new ArrayList<Fields>();
    log.add(header);
    recording.events.forEach(placed -> log.add(placed.event()));
    check(log, recording, format, file);
    return new Fields().put("log", log).put("told", recording.told(header));
  }

  private static Recording recording(Fields json, byte[] content, Recording.Span chosen) {
    String kind = json.text("kind");
    return switch (kind) {
      case "step7" -> Step7Text.read(content, json.text("dates")).convert(chosen);
      case "szl" -> Szl.read(Octets.decoded(content)).convert(chosen);
      case "ring" -> {
        byte[] raw = Octets.decoded(content);
        yield Ring.of(raw).convert(raw, chosen);
      }
      case "csv" -> Table.of(json.text("map")).convert(new String(content, StandardCharsets.UTF_8), chosen);
      default -> throw new IllegalArgumentException("an unknown kind: " + kind);
    };
  }

  /** The mode is required here: its default in the format, STOP, would claim what nobody said. */
  private static void complete(Fields header) {
    for (String field : REQUIRED) {
      if (!header.has(field)) {
        throw new Unusable(
                "it from --" + field + " or --header, since the source does not tell it", "none", field)
            .of("header");
      }
    }
  }

  /** Reads the log, so that nothing unusable is ever given. */
  private static void check(List<Fields> log, Recording recording, Format format, ProfileFile file) {
    var taker =
        new LogReader.Taker() {
          @Override
          public void header(Fields header) {}

          @Override
          public void event(int line, Fields event) {}
        };
    var reader = new LogReader(format, taker, file);
    for (int i = 0; i < log.size(); i++) {
      try {
        byte[] line = (log.get(i) + "\n").getBytes(StandardCharsets.UTF_8);
        reader.take(line, 0, line.length);
      } catch (Unusable wrong) {
        throw wrong.of(i == 0 ? "header" : recording.events.get(i - 1).place());
      }
    }
  }

  private static Fields ringEvents(byte[] slots, Elapsed elapsed) {
    var recording = new Recording();
    Slot.all(slots, 0, slots.length).forEach(slot -> slot.addTo(recording, elapsed));
    return new Fields()
        .put("events", recording.events.stream().map(Recording.Placed::event).toList())
        .put("elapsed", elapsed.asFields())
        .put("jumped", elapsed.jumped());
  }

  private static List<Fields> entries(byte[] records) {
    var told = new ArrayList<Fields>();
    List<Entry> entries = Szl.entries(records);
    Modes modes = Modes.follow(entries);
    for (int i = 0; i < entries.size(); i++) {
      Entry entry = entries.get(i);
      Modes.Change change = Modes.changeOf(entry);
      var one = new Fields().put("event", Diagnostics.event(entry)).put("power", entry.id() == Modes.POWER_ON);
      if (change != null) {
        // List.of takes no null.
        one.put("change", Arrays.asList(change.old(), change.now()));
      }
      if (modes.events().containsKey(i)) {
        one.put("told", Diagnostics.at(modes.events().get(i), entry));
      }
      told.add(one);
    }
    return told;
  }
}
