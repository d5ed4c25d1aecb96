package tla.eval;

import tlc2.value.impl.RecordValue;
import tlc2.value.impl.Value;
import util.UniqueString;

/** A field of a record. It looks first in the place where the field was the last time. */
final class Field implements Expr {
  private final Expr record;
  private final UniqueString name;
  private int place;

  Field(Expr record, UniqueString name) {
    this.record = record;
    this.name = name;
  }

  @Override
  public Value eval(Object[] frame) {
    Value value = record.eval(frame);
    if (value instanceof RecordValue r) {
      UniqueString[] names = r.names;
      if (place < names.length && names[place] == name) {
        return r.values[place];
      }
      for (int i = 0; i < names.length; i++) {
        if (names[i].equals(name)) {
          place = i;
          return r.values[i];
        }
      }
    }
    return Builtins.field(value, name);
  }
}
