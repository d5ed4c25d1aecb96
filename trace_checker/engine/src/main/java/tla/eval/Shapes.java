package tla.eval;

import java.util.Arrays;
import java.util.Set;

import tlc2.value.impl.FcnRcdValue;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.SetEnumValue;
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;
import util.UniqueString;

/**
 * The shape of a value: the value without its times. Times are the integers in the fields and
 * variables with certain names; which names these are matters for speed alone.
 *
 * <p>Sets count as sequences of their elements in TLC's order, so that an element of a shape has its
 * place in every value of that shape.
 */
final class Shapes {
  private static final long TIME = 0x51A7E5D1C3B2F04DL;

  private final Set<String> times;
  private boolean[] known = {};
  private boolean[] isTime = {};

  Shapes(Set<String> times) {
    this.times = times;
  }

  boolean areTimes(UniqueString name) {
    int token = name.getTok();
    if (token >= known.length) {
      known = Arrays.copyOf(known, 2 * token);
      isTime = Arrays.copyOf(isTime, 2 * token);
    }
    if (!known[token]) {
      known[token] = true;
      isTime[token] = times.contains(name.toString());
    }
    return isTime[token];
  }

  /**
   * A hash of the shape of a value, which may have recorded integers in it where times are.
   *
   * @param inTime whether an integer in this place is a time
   * @throws UnsupportedOperationException if a recorded integer is elsewhere
   */
  long of(Value value, boolean inTime) {
    if (value instanceof IntValue number) {
      return inTime ? TIME : Hash.mix(number.val);
    }
    if (value instanceof Sym) {
      if (!inTime) {
        throw new UnsupportedOperationException("a time in another place");
      }
      return TIME;
    }
    // Places count in TLC's order, which must not come about later.
    value.normalize();
    if (value instanceof RecordValue record) {
      long hash = 1;
      for (int i = 0; i < record.names.length; i++) {
        UniqueString name = record.names[i];
        hash = Hash.mix(hash + name.getTok());
        hash = Hash.mix(hash + of(record.values[i], areTimes(name)));
      }
      return hash;
    }
    if (value instanceof FcnRcdValue function) {
      long hash = 2 + function.values.length;
      for (int i = 0; i < function.values.length; i++) {
        hash = Hash.mix(hash + (function.intv != null ? function.intv.low + i : of(function.domain[i], false)));
        hash = Hash.mix(hash + of(function.values[i], inTime));
      }
      return hash;
    }
    if (value instanceof TupleValue tuple) {
      long hash = 3;
      for (Value each : tuple.elems) {
        hash = Hash.mix(hash + of(each, inTime));
      }
      return hash;
    }
    if (value instanceof SetEnumValue set) {
      long hash = 4;
      for (int i = 0; i < set.elems.size(); i++) {
        hash = Hash.mix(hash + of(set.elems.elementAt(i), false));
      }
      return hash;
    }
    return Hash.mix(5 + Hash.of(value));
  }

  /**
   * The part of a value at a place: the position in each part on the way; -1, -2, ... stand for the
   * elements of a function's domain.
   */
  static Value at(Value value, int[] path, int from) {
    Value part = value;
    for (int i = from; i < path.length; i++) {
      int k = path[i];
      if (part instanceof RecordValue record) {
        part = record.values[k];
      } else if (part instanceof FcnRcdValue function) {
        part = k < 0 ? function.domain[-1 - k] : function.values[k];
      } else if (part instanceof SetEnumValue set) {
        part = set.elems.elementAt(k);
      } else {
        part = ((TupleValue) part).elems[k];
      }
    }
    return part;
  }
}
