package s7.trace;

import java.util.HashMap;
import java.util.Map;

import s7.log.Fields;
import s7.log.Moment;
import tla.eval.Shaped;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.StringValue;
import tlc2.value.impl.Value;

/**
 * Turns normalised events into records of the specification.
 *
 * <p>Events that differ in times alone have the same {@link Shaped.Example}.
 */
final class Records {
  /** The most examples that are known; then all are forgotten. */
  private static final int MOST = 10_000;

  private final Template template;
  private final Map<Long, Known> examples = new HashMap<>();
  private final Map<String, Value> strings = new HashMap<>();
  private long hash;

  /**
   * @param noEvent an event without values
   */
  Records(RecordValue noEvent) {
    template = new Template(noEvent);
  }

  /** A record without values, and where its fields are. */
  private static final class Template {
    private final RecordValue record;
    private final Map<String, Integer> places = new HashMap<>();
    private final Template[] inner;
    private final boolean[] isTime;
    private final int minutes;
    private final int milliseconds;

    Template(RecordValue record) {
      record.normalize();
      this.record = record;
      inner = new Template[record.names.length];
      isTime = new boolean[record.names.length];
      for (int i = 0; i < inner.length; i++) {
        String name = record.names[i].toString();
        places.put(name, i);
        inner[i] = record.values[i] instanceof RecordValue values ? new Template(values) : null;
        isTime[i] = Contract.TIMES.contains(name) || inner[i] != null && inner[i].minutes >= 0;
      }
      minutes = places.getOrDefault(Contract.MINUTES, -1);
      milliseconds = places.getOrDefault(Contract.MILLISECONDS, -1);
    }

    RecordValue with(Value... values) {
      return new RecordValue(record.names, values, true);
    }

    RecordValue moment(Moment moment) {
      var values = new Value[2];
      values[minutes] = IntValue.gen(moment.minutes());
      values[milliseconds] = IntValue.gen(moment.milliseconds());
      return with(values);
    }

    /** Whether two records have the same values but for times, and the same times. */
    boolean alike(Value[] one, Value[] other) {
      for (int i = 0; i < one.length; i++) {
        if (one[i] == other[i]) {
          continue;
        }
        Value none = record.values[i];
        boolean same =
            isTime[i]
                ? one[i] != none && other[i] != none
                : inner[i] != null
                    ? inner[i].alike(((RecordValue) one[i]).values, ((RecordValue) other[i]).values)
                    : one[i].equals(other[i]);
        if (!same) {
          return false;
        }
      }
      return true;
    }
  }

  private record Known(Shaped.Example example, Value[] values) {}

  /** What is known of all events that differ from one in dates alone: the places of those fields that may have dates. */
  private record Dated(Records of, Shaped.Example example, Value[] values, int... places) {}

  private void note(Fields event, Shaped.Example example, Value... values) {
    var places = new int[event.size()];
    for (int i = 0; i < places.length; i++) {
      boolean hasDate = event.value(i) instanceof Moment || event.value(i) instanceof Fields;
      places[i] = hasDate ? template.places.getOrDefault(event.name(i), -1) : -1;
    }
    event.note(new Dated(this, example, values, places));
  }

  private RecordValue of(Dated known, Fields event) {
    Value[] values = known.values.clone();
    for (int i = 0; i < known.places.length; i++) {
      int place = known.places[i];
      if (place >= 0) {
        values[place] = value(template, place, event.value(i));
      }
    }
    return known.example.with(values);
  }

  /** The record of an event. */
  RecordValue of(Fields event) {
    if (event.noted() instanceof Dated known && known.of == this) {
      return of(known, event);
    }
    hash = 0;
    Value[] values = values(template, event);
    Known like = examples.get(hash);
    if (like == null || !template.alike(values, like.values)) {
      if (examples.size() == MOST) {
        examples.clear();
      }
      like = new Known(new Shaped.Example(template.with(values)), values);
      examples.put(hash, like);
    }
    if (event.hasExample()) {
      note(event, like.example, values);
    }
    return like.example.with(values);
  }

  private Value[] values(Template template, Fields fields) {
    Value[] values = template.record.values.clone();
    for (int i = 0; i < fields.size(); i++) {
      Integer place = template.places.get(fields.name(i));
      if (place != null) {
        hash = 31 * hash + place;
        values[place] = value(template, place, fields.value(i));
      }
    }
    return values;
  }

  private Value value(Template template, int place, Object value) {
    if (value instanceof Moment moment) {
      return template.inner[place].moment(moment);
    }
    if (value instanceof Fields fields) {
      Template inner = template.inner[place];
      return inner.with(values(inner, fields));
    }
    if (!template.isTime[place]) {
      hash = 31 * hash + value.hashCode();
    }
    return value instanceof String text
        ? strings.computeIfAbsent(text, StringValue::new)
        : IntValue.gen(((Number) value).intValue());
  }
}
