package tla.eval;

import java.util.function.Function;

import tlc2.value.impl.RecordValue;
import tlc2.value.impl.Value;

/** A record that differs from an example in times alone, so that its shape need not be found again. */
public final class Shaped extends RecordValue {
  private static final long serialVersionUID = 1L;

  private final transient Example example;

  /** A record and the shape of all that are like it. */
  public static final class Example {
    private final RecordValue record;
    private long shape;
    private boolean known;
    private Object noted;

    public Example(RecordValue record) {
      record.normalize();
      this.record = record;
    }

    /** The values of a record like this, in which the times can be replaced. */
    public Value[] values() {
      return record.values.clone();
    }

    /**
     * A record with other values.
     *
     * @param values those of the example but for times
     */
    public Shaped with(Value... values) {
      return new Shaped(this, values);
    }
  }

  private Shaped(Example example, Value[] values) {
    super(example.record.names, values, true);
    this.example = example;
  }

  /** What is noted of the example, at the first call: it must not depend on times. */
  public Object noted(Function<RecordValue, Object> note) {
    if (example.noted == null) {
      example.noted = note.apply(example.record);
    }
    return example.noted;
  }

  long shape(Shapes shapes) {
    if (!example.known) {
      example.shape = shapes.of(example.record, false);
      example.known = true;
    }
    return example.shape;
  }
}
