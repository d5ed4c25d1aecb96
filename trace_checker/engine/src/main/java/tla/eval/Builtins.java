package tla.eval;

import java.util.Arrays;

import tlc2.value.impl.EnumerableValue;
import tlc2.value.impl.FcnRcdValue;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.IntervalValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.Reducible;
import tlc2.value.impl.SetEnumValue;
import tlc2.value.impl.StringValue;
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;
import tlc2.value.impl.ValueVec;
import util.UniqueString;

/** The operators of TLA+ and of its standard modules on TLC's values. */
final class Builtins {
  /** So many elements are compared one after the other. */
  private static final int FEW = 32;

  private Builtins() {}

  static boolean equal(Value a, Value b) {
    if (a == b) {
      return true;
    }
    if (a instanceof IntValue x && b instanceof IntValue y) {
      return x.val == y.val;
    }
    if (a instanceof StringValue x && b instanceof StringValue y) {
      return x.val.equals(y.val);
    }
    if (a instanceof RecordValue x && b instanceof RecordValue y) {
      return equal(x, y);
    }
    if (a instanceof FcnRcdValue x && b instanceof FcnRcdValue y && x.domain != null && x.domain == y.domain) {
      return equal(x.values, y.values);
    }
    if (a instanceof SetEnumValue x && b instanceof SetEnumValue y) {
      return equal(elements(x), elements(y));
    }
    return a.equals(b);
  }

  // As TLC has it, whose own comparison guards each value against exceptions, which costs more than it compares.

  private static boolean equal(Value[] a, Value... b) {
    for (int i = 0; i < a.length; i++) {
      if (!equal(a[i], b[i])) {
        return false;
      }
    }
    return true;
  }

  private static boolean equal(ValueVec a, ValueVec b) {
    if (a.size() != b.size()) {
      return false;
    }
    for (int i = 0; i < a.size(); i++) {
      if (!equal(a.elementAt(i), b.elementAt(i))) {
        return false;
      }
    }
    return true;
  }

  private static boolean equal(RecordValue a, RecordValue b) {
    a.normalize();
    b.normalize();
    if (a.names.length != b.names.length) {
      return false;
    }
    for (int i = 0; i < a.names.length; i++) {
      if (a.names[i] != b.names[i] || !equal(a.values[i], b.values[i])) {
        return false;
      }
    }
    return true;
  }

  /** Whether a set has an element. */
  static boolean member(Value element, Value set) {
    if (!(set instanceof SetEnumValue s) || s.elems.size() > FEW) {
      return set.member(element);
    }
    for (int i = 0; i < s.elems.size(); i++) {
      if (equal(s.elems.elementAt(i), element)) {
        return true;
      }
    }
    return false;
  }

  /** The elements of a finite set, in TLC's order and each once. */
  static ValueVec elements(Value set) {
    Value each = set instanceof SetEnumValue ? set : set.toSetEnum();
    each.normalize();
    return ((SetEnumValue) each).elems;
  }

  static boolean isEmpty(Value set) {
    if (set instanceof SetEnumValue s) {
      return s.elems.size() == 0;
    }
    return set instanceof IntervalValue i ? i.low > i.high : elements(set).size() == 0;
  }

  static int cardinality(Value set) {
    return set instanceof IntervalValue i ? i.size() : elements(set).size();
  }

  private static Reducible reducible(Value set) {
    return set instanceof Reducible r ? r : (Reducible) set.toSetEnum();
  }

  static Value cup(Value a, Value b) {
    if (isEmpty(a)) {
      return b;
    }
    return isEmpty(b) ? a : reducible(a).cup((Value) reducible(b));
  }

  static Value cap(Value a, Value b) {
    return reducible(a).cap(b);
  }

  static Value minus(Value a, Value b) {
    return isEmpty(a) || isEmpty(b) ? a : reducible(a).diff(b);
  }

  static boolean subset(Value a, Value b) {
    ValueVec elements = elements(a);
    for (int i = 0; i < elements.size(); i++) {
      if (!member(elements.elementAt(i), b)) {
        return false;
      }
    }
    return true;
  }

  static Value union(Value sets) {
    ValueVec each = elements(sets);
    var all = new ValueVec();
    for (int i = 0; i < each.size(); i++) {
      ValueVec inner = elements(each.elementAt(i));
      for (int k = 0; k < inner.size(); k++) {
        all.addElement(inner.elementAt(k));
      }
    }
    return new SetEnumValue(all, false);
  }

  static Value domain(Value function) {
    if (function instanceof FcnRcdValue f) {
      return f.getDomain();
    }
    if (function instanceof TupleValue t) {
      return t.getDomain();
    }
    return ((FcnRcdValue) function.toFcnRcd()).getDomain();
  }

  static boolean inDomain(Value function, Value x) {
    return function instanceof FcnRcdValue f ? place(f, x) >= 0 : domain(function).member(x);
  }

  /** The place of x in the function's domain; -1 if x is not in it. */
  private static int place(FcnRcdValue function, Value x) {
    if (function.intv != null) {
      int i = ((IntValue) x).val;
      return i < function.intv.low || i > function.intv.high ? -1 : i - function.intv.low;
    }
    for (int i = 0; i < function.domain.length; i++) {
      if (equal(function.domain[i], x)) {
        return i;
      }
    }
    return -1;
  }

  private static int place(RecordValue record, UniqueString name) {
    for (int i = 0; i < record.names.length; i++) {
      if (record.names[i].equals(name)) {
        return i;
      }
    }
    return -1;
  }

  static Value apply(Value function, Value x) {
    if (function instanceof FcnRcdValue f) {
      return f.values[place(f, x)];
    }
    if (function instanceof TupleValue t) {
      return t.elems[((IntValue) x).val - 1];
    }
    if (function instanceof RecordValue r) {
      return r.values[place(r, ((StringValue) x).val)];
    }
    return apply(function.toFcnRcd(), x);
  }

  static Value field(Value record, UniqueString name) {
    if (record instanceof RecordValue r) {
      return r.values[place(r, name)];
    }
    return field(record.toRcd(), name);
  }

  /** {@code function} with another value for x, which is in its domain. */
  static Value except(Value function, Value x, Value value) {
    if (function instanceof FcnRcdValue f) {
      var values = f.values.clone();
      values[place(f, x)] = value;
      return f.intv != null
          ? new FcnRcdValue(f.intv, values)
          : new FcnRcdValue(f.domain, values, f.isNormalized());
    }
    if (function instanceof RecordValue r && x instanceof StringValue name) {
      var values = r.values.clone();
      values[place(r, name.val)] = value;
      return new RecordValue(r.names, values, r.isNormalized());
    }
    if (function instanceof TupleValue t && x instanceof IntValue i) {
      var values = t.elems.clone();
      values[i.val - 1] = value;
      return new TupleValue(values);
    }
    return except(function.toFcnRcd(), x, value);
  }

  static Value function(Value domain, Value[] values) {
    return domain instanceof IntervalValue interval
        ? new FcnRcdValue(interval, values)
        : new FcnRcdValue(elements(domain).toArray(), values, true);
  }

  static TupleValue tuple(Value sequence) {
    if (sequence instanceof TupleValue t) {
      return t;
    }
    return (TupleValue) ((FcnRcdValue) sequence).toTuple();
  }

  static Value append(Value sequence, Value last) {
    Value[] old = tuple(sequence).elems;
    Value[] elements = Arrays.copyOf(old, old.length + 1);
    elements[old.length] = last;
    return new TupleValue(elements);
  }

  /** SubSeq; {@code from} and {@code to} count from 1. */
  static Value section(Value sequence, int from, int to) {
    if (from > to) {
      return TupleValue.EmptyTuple;
    }
    Value[] elements = tuple(sequence).elems;
    if (from < 1 || to > elements.length) {
      throw new IndexOutOfBoundsException();
    }
    return new TupleValue(Arrays.copyOfRange(elements, from - 1, to));
  }

  static Value concatenation(Value a, Value b) {
    Value[] left = tuple(a).elems;
    Value[] right = tuple(b).elems;
    Value[] elements = Arrays.copyOf(left, left.length + right.length);
    System.arraycopy(right, 0, elements, left.length, right.length);
    return new TupleValue(elements);
  }

  /** a % b of TLA+. */
  static int modulo(int a, int b) {
    if (b <= 0) {
      throw new ArithmeticException();
    }
    return Math.floorMod(a, b);
  }

  /** SUBSET; a ClassCastException if {@code set} is not a finite set. */
  static Value powerset(Value set) {
    return new tlc2.value.impl.SubsetValue((EnumerableValue) set);
  }
}
