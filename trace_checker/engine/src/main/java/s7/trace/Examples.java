package s7.trace;

import java.util.HashMap;
import java.util.Map;

import tla.eval.Shaped;
import tla.json.Json;
import tla.json.Values;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.Value;

/**
 * Reads lines by examples, lines that Python's reader has read: a line has the event of an example if
 * it differs from it in times alone ({@link LineText}). So no rule of the log format is here but the
 * plain form of a date and of a number. A line that is like no example, right or wrong, is Python's.
 */
final class Examples {
  /** The most examples that are known; then all are forgotten. */
  private static final int MOST = 10_000;

  private static final int MS_PER_MINUTE = 60_000;

  private final RecordValue noEvent;
  private final RecordValue noMoment;
  private final int up;
  private final int minutes;
  private final LineText text;
  private final Map<Long, Example> known = new HashMap<>();
  private boolean taken;

  /**
   * @param noEvent an event without values
   * @param text takes lines apart
   */
  Examples(RecordValue noEvent, LineText text) {
    this.noEvent = noEvent;
    this.text = text;
    up = Values.place(noEvent, Contract.UP);
    noMoment = (RecordValue) noEvent.values[up];
    minutes = Values.place(noMoment, Contract.MINUTES);
  }

  /** The place of a value in an event, or in the record that the event has in the field {@code outer}. */
  private record Place(int outer, int field, boolean isMoment) {
    private Value of(Value[] event) {
      return outer < 0 ? event[field] : ((RecordValue) event[outer]).values[field];
    }

    private void put(Value[] event, Value value) {
      if (outer < 0) {
        event[field] = value;
      } else {
        RecordValue record = (RecordValue) event[outer];
        Value[] values = record.values.clone();
        values[field] = value;
        event[outer] = new RecordValue(record.names, values, record.isNormalized());
      }
    }
  }

  /**
   * An example.
   *
   * @param rest its text without the values that may differ
   * @param places where in the event each of the values is
   * @param at which of the values the clocks look at; -1 for none
   */
  private record Example(byte[] rest, Shaped.Example event, Place[] places, int at, int counter, int to) {}

  /** The event of a line, to which the clocks go on; null if Python has to read it. */
  RecordValue read(Json line, Clocks clocks) {
    taken = line.ask(text::take);
    Example like = taken ? known.get(text.hash()) : null;
    if (like == null || !text.hasRest(like.rest)) {
      return null;
    }
    long at = text.value(like.at);
    long counter = like.counter < 0 ? Clocks.NONE : text.value(like.counter);
    if (!clocks.allow(at, counter)) {
      return null;
    }
    Value[] event = like.event.values();
    for (int i = 0; i < like.places.length; i++) {
      like.places[i].put(event, value(like.places[i], i));
    }
    event[up] = moment(clocks.advance(at, counter, like.to < 0 ? Clocks.NONE : text.value(like.to)));
    return like.event.with(event);
  }

  /** The line that could not be read is an example from now on: this is its event. */
  void learn(RecordValue event) {
    if (!taken) {
      return;
    }
    LineText.Field[] fields = text.fields();
    var places = new Place[fields.length];
    for (int i = 0; i < fields.length; i++) {
      places[i] = place(fields[i].path());
      if (places[i] == null || !places[i].of(event.values).equals(value(places[i], i)) || number(fields, fields[i].path()) != i) {
        return;
      }
    }
    int at = number(fields, Contract.AT);
    if (at < 0) {
      return;
    }
    if (known.size() == MOST) {
      known.clear();
    }
    known.put(
        text.hash(),
        new Example(
            text.rest(), new Shaped.Example(event), places, at, number(fields, Contract.UP), number(fields, Contract.TO)));
  }

  /** The last of the fields that is this one; -1 if it is not among them. */
  private static int number(LineText.Field[] fields, String path) {
    for (int i = fields.length - 1; i >= 0; i--) {
      if (fields[i].path().equals(path)) {
        return i;
      }
    }
    return -1;
  }

  /** Null if an event has no such value. */
  private Place place(String path) {
    if (path.equals(Contract.UP)) {
      return place(Contract.COUNTER);
    }
    int point = path.indexOf('.');
    int outer = point < 0 ? -1 : Values.place(noEvent, path.substring(0, point));
    var record = outer < 0 ? noEvent : (RecordValue) noEvent.values[outer];
    int field = Values.place(record, path.substring(point + 1));
    return field < 0 ? null : new Place(outer, field, record.values[field] instanceof RecordValue);
  }

  private Value value(Place place, int i) {
    return place.isMoment ? moment(text.value(i)) : IntValue.gen((int) text.value(i));
  }

  /** Milliseconds as the specification has points in time. */
  private Value moment(long milliseconds) {
    var values = new Value[2];
    values[minutes] = IntValue.gen((int) (milliseconds / MS_PER_MINUTE));
    values[1 - minutes] = IntValue.gen((int) (milliseconds % MS_PER_MINUTE));
    return new RecordValue(noMoment.names, values, true);
  }
}
