package tla.eval;

import tlc2.value.impl.BoolValue;
import tlc2.value.impl.FcnRcdValue;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.IntervalValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.StringValue;
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;
import tlc2.value.impl.ValueVec;

/**
 * Hashes values to 64 bits; equal values have the same hash. It is cheaper than TLC's fingerprints,
 * since sets and functions need no order.
 *
 * <p>Records and tuples are functions. The hash of a set or function is a sum over its elements or
 * pairs, each well mixed.
 */
public final class Hash {
  /** By so much SplitMix64 goes from number to number. */
  public static final long STEP = 0x9E3779B97F4A7C15L;

  private Hash() {}

  static long of(Value value) {
    if (value instanceof IntValue number) {
      return mix(number.val);
    }
    if (value instanceof Sym sym) {
      return mix(mix(sym.identity));
    }
    if (value instanceof BoolValue truth) {
      return truth.val ? 0x5851F42D4C957F2DL : 0x14057B7EF767814FL;
    }
    if (value instanceof StringValue string) {
      return mix(string.val.getTok() ^ 0x2545F4914F6CDD1DL);
    }
    if (value instanceof RecordValue record) {
      long sum = 0;
      for (int i = 0; i < record.names.length; i++) {
        sum += pair(mix(record.names[i].getTok() ^ 0x2545F4914F6CDD1DL), of(record.values[i]));
      }
      return mix(sum);
    }
    if (value instanceof FcnRcdValue function) {
      return function(function);
    }
    if (value instanceof TupleValue tuple) {
      long sum = 0;
      for (int i = 0; i < tuple.elems.length; i++) {
        sum += pair(mix(i + 1), of(tuple.elems[i]));
      }
      return mix(sum);
    }
    if (value instanceof IntervalValue interval) {
      long sum = 0;
      for (int i = interval.low; i <= interval.high; i++) {
        sum += mix(mix(i));
      }
      return ~mix(sum);
    }
    Value set = value.toSetEnum();
    if (set != null) {
      ValueVec elements = Builtins.elements(set);
      long sum = 0;
      for (int i = 0; i < elements.size(); i++) {
        sum += mix(of(elements.elementAt(i)));
      }
      return ~mix(sum);
    }
    return function((FcnRcdValue) value.toFcnRcd());
  }

  private static long function(FcnRcdValue function) {
    long sum = 0;
    for (int i = 0; i < function.values.length; i++) {
      long x = function.intv != null ? mix(function.intv.low + i) : of(function.domain[i]);
      sum += pair(x, of(function.values[i]));
    }
    return mix(sum);
  }

  private static long pair(long x, long y) {
    return mix(x * STEP + y);
  }

  /** A bijection in which every bit of the result depends on every bit of x (SplitMix64). */
  public static long mix(long x) {
    long z = x + STEP;
    z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
    z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
    return z ^ (z >>> 31);
  }

  /** Hashes tuples that share many parts with the tuples before. */
  static final class Parts {
    /** So many values of a part are known. */
    private static final int MOST = 4;

    /** The values at place i and their hashes begin at {@code MOST * i}. */
    private Value[] known = {};

    private long[] hashes = {};
    private int oldest;

    long of(Value value) {
      if (!(value instanceof TupleValue tuple)) {
        return Hash.of(value);
      }
      if (known.length < MOST * tuple.elems.length) {
        known = new Value[MOST * tuple.elems.length];
        hashes = new long[known.length];
      }
      long hash = 0;
      for (int i = 0; i < tuple.elems.length; i++) {
        hash = mix(hash + part(tuple.elems[i], MOST * i));
      }
      return hash;
    }

    private long part(Value part, int from) {
      for (int i = from; i < from + MOST; i++) {
        if (known[i] == part) {
          return hashes[i];
        }
      }
      oldest = oldest + 1 & MOST - 1;
      known[from + oldest] = part;
      return hashes[from + oldest] = Hash.of(part);
    }
  }
}
