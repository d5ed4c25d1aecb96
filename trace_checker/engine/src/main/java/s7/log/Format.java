package s7.log;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** How the header and the events of a log are read, and programs of the kit, whose steps are like events. */
public final class Format {
  private final Words words;
  private final Header header;
  private final Events events;

  /**
   * @param words {@code Words} of the specification
   */
  public Format(Fields words) {
    this.words = new Words(words);
    header = new Header(this.words);
    events = new Events(this.words);
  }

  /** The normalised header of a text, as the first line of a log has it. */
  public Fields header(byte[] text, ProfileFile file) {
    return header(Fields.of(text), file);
  }

  Fields header(Fields line, ProfileFile file) {
    return header.read(line, file);
  }

  /** A normalised header with other choices of {@code cpu}, {@code profile} and {@code readings}. */
  public Fields chosen(Fields normalised, Fields chosen) {
    return header.chosen(normalised, chosen);
  }

  /** The normalised event of a text, as a line of a log has it; the clocks go on to it. */
  public Fields event(byte[] text, Clocks clocks) {
    clocks.requireOpen();
    Fields event = event(Fields.of(text), clocks.cpu);
    clocks.stamp(event);
    return event;
  }

  /** The normalised event of a line's object, before the clocks have gone on to it. */
  Fields event(Fields line, Clocks.Cpu cpu) {
    return events.read(line, cpu);
  }

  /** The calls that have operands. */
  public Set<String> callsWithOperands() {
    return events.calls().stream().filter(name -> events.required(name).size() > 1).collect(Collectors.toSet());
  }

  /** A program of the kit, with one spelling for each value. */
  public Fields program(byte[] text) {
    return new Programs(words, header, events).program(Fields.of(text));
  }

  /** The programs of the kit that a text holds, with {@code name}, {@code about} and {@code text}, unread. */
  public static List<Fields> programsIn(byte[] text) {
    return Programs.in(new String(text, StandardCharsets.UTF_8));
  }

  /** The header, the duration, the events from outside and the bodies of the program of a log ({@link FromLog}). */
  public Fields programOf(byte[] log, ProfileFile file) {
    return FromLog.program(this, events, log, file);
  }

  /** What a CPU offers to programs of the kit. */
  public Fields offer(byte[] text) {
    return new Programs(words, header, events).offer(Fields.of(text));
  }

  /** The clocks of a log with this normalised header, at its begin. */
  public static Clocks clocksOf(Fields header) {
    boolean jumpsLogged = ((List<?>) header.get("records")).contains("clock");
    return new Clocks((Moment) header.get("clock"), jumpsLogged, Header.cpu(header));
  }
}
