package tla.eval;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

import tlc2.value.impl.BoolValue;
import tlc2.value.impl.FcnRcdValue;
import tlc2.value.impl.IntValue;
import tlc2.value.impl.IntervalValue;
import tlc2.value.impl.RecordValue;
import tlc2.value.impl.SetEnumValue;
import tlc2.value.impl.StringValue;
import tlc2.value.impl.TupleValue;
import tlc2.value.impl.Value;

/**
 * One evaluation of an operator of which every step that depends on a time is kept: how integers are
 * computed from times of the inputs, and how comparisons of them came out.
 */
final class Recording {
  /** A step: an integer is computed, or two integers are compared. */
  record Step(Operation operation, int a, int b, boolean outcome) {}

  /** The most steps that are kept; a longer evaluation is not worth it. */
  private static final int MOST_STEPS = 2_000;

  private final Shapes shapes;
  private final List<Step> steps = new ArrayList<>();
  private final List<int[]> places = new ArrayList<>();
  private final Map<Value, int[]> parts = new IdentityHashMap<>();
  private final Map<Integer, Integer> constants = new HashMap<>();
  private final Map<Step, Integer> results = new HashMap<>();
  private final Set<Step> comparisons = new HashSet<>();
  private int registers;

  Recording(Shapes shapes) {
    this.shapes = shapes;
  }

  List<Step> steps() {
    return steps;
  }

  /** The places in the inputs from which times are taken. */
  List<int[]> places() {
    return places;
  }

  /** An input with recorded integers in the place of its times; itself if it has none. */
  Value recorded(Value value, boolean inTime, int... place) {
    Value recorded = replaced(value, inTime, place);
    if (recorded != value) {
      parts.put(recorded, place);
    }
    return recorded;
  }

  private Value replaced(Value value, boolean inTime, int[] place) {
    if (value instanceof IntValue number) {
      return inTime ? Sym.taken(number.val, place) : value;
    }
    if (value instanceof RecordValue record) {
      Value[] values = null;
      for (int i = 0; i < record.values.length; i++) {
        boolean isTime = shapes.areTimes(record.names[i]);
        values = with(values, record.values, i, isTime, place);
      }
      return values == null ? value : new RecordValue(record.names, values, record.isNormalized());
    }
    if (value instanceof FcnRcdValue function) {
      Value[] values = null;
      Value[] domain = null;
      for (int i = 0; i < function.values.length; i++) {
        values = with(values, function.values, i, inTime, place);
        if (function.intv == null) {
          domain = with(domain, function.domain, i, -1 - i, false, place);
        }
      }
      return values == null && domain == null
          ? value
          : function(function, domain, values == null ? function.values : values);
    }
    if (value instanceof TupleValue tuple) {
      Value[] values = null;
      for (int i = 0; i < tuple.elems.length; i++) {
        values = with(values, tuple.elems, i, inTime, place);
      }
      return values == null ? value : new TupleValue(values);
    }
    if (value instanceof SetEnumValue set) {
      set.normalize();
      Value[] elements = set.elems.toArray();
      Value[] values = null;
      for (int i = 0; i < elements.length; i++) {
        values = with(values, elements, i, false, place);
      }
      return values == null ? value : new SetEnumValue(values, true);
    }
    return value;
  }

  private Value[] with(Value[] values, Value[] old, int i, boolean inTime, int[] place) {
    return with(values, old, i, i, inTime, place);
  }

  private Value[] with(Value[] values, Value[] old, int i, int position, boolean inTime, int[] place) {
    int[] inner = Arrays.copyOf(place, place.length + 1);
    inner[place.length] = position;
    Value each = recorded(old[i], inTime, inner);
    if (each == old[i]) {
      return values;
    }
    Value[] all = values == null ? old.clone() : values;
    all[i] = each;
    return all;
  }

  /** A function with other values and, if {@code domain} is not null, another domain. */
  private static Value function(FcnRcdValue like, Value[] domain, Value[] values) {
    return like.intv != null
        ? new FcnRcdValue(like.intv, values)
        : new FcnRcdValue(domain == null ? like.domain : domain, values, like.isNormalized());
  }

  /** The register with the result of a step, which is made once. */
  private int step(Operation operation, int a, int b) {
    var step = new Step(operation, a, b, false);
    Integer known = results.get(step);
    if (known == null) {
      add(step);
      known = registers++;
      results.put(step, known);
    }
    return known;
  }

  private void add(Step step) {
    if (steps.size() == MOST_STEPS) {
      throw new UnsupportedOperationException("a long recording");
    }
    steps.add(step);
  }

  /** The value of an operation on two integers, of which each may be recorded. */
  Value computed(Operation operation, Value a, Value b) {
    int result = operation.on(number(a), number(b));
    if (!(a instanceof Sym) && !(b instanceof Sym)) {
      return IntValue.gen(result);
    }
    return Sym.computed(result, step(operation, register(a), register(b)));
  }

  /** The outcome of a comparison of two integers, of which each may be recorded. */
  boolean compared(Operation comparison, Value a, Value b) {
    boolean outcome = comparison.on(number(a), number(b)) != 0;
    if (a instanceof Sym || b instanceof Sym) {
      var step = new Step(comparison, register(a), register(b), outcome);
      if (comparisons.add(step)) {
        add(step);
      }
    }
    return outcome;
  }

  boolean equal(Value a, Value b) {
    if (a == b) {
      return true;
    }
    if (a instanceof Sym || b instanceof Sym) {
      return compared(Operation.EQUAL, a, b);
    }
    if (a instanceof RecordValue x && b instanceof RecordValue y && x.names.length == y.names.length) {
      x.normalize();
      y.normalize();
      for (int i = 0; i < x.names.length; i++) {
        if (!x.names[i].equals(y.names[i])) {
          return false;
        }
      }
      for (int i = 0; i < x.names.length; i++) {
        if (!equal(x.values[i], y.values[i])) {
          return false;
        }
      }
      return true;
    }
    return Builtins.equal(a, b);
  }

  /** Whether a set has an element. */
  boolean member(Value element, Value set) {
    if (set instanceof SetEnumValue elements) {
      for (int i = 0; i < elements.elems.size(); i++) {
        if (equal(elements.elems.elementAt(i), element)) {
          return true;
        }
      }
      return false;
    }
    if (set instanceof IntervalValue interval && element instanceof Sym) {
      return compared(Operation.LESS_OR_EQUAL, IntValue.gen(interval.low), element)
          && compared(Operation.LESS_OR_EQUAL, element, IntValue.gen(interval.high));
    }
    return set.member(element);
  }

  /** The place of x in a function's domain; -1 if x is not in it. */
  int place(FcnRcdValue function, Value x) {
    for (int i = 0; i < function.domain.length; i++) {
      if (equal(function.domain[i], x)) {
        return i;
      }
    }
    return -1;
  }

  private static int number(Value value) {
    return value instanceof Sym sym ? sym.number : ((IntValue) value).val;
  }

  private int register(Value value) {
    if (value instanceof Sym sym) {
      if (sym.register < 0) {
        places.add(sym.place);
        sym.register = step(Operation.TAKE, places.size() - 1, 0);
      }
      return sym.register;
    }
    Integer known = constants.get(number(value));
    if (known == null) {
      known = step(Operation.CONSTANT, number(value), 0);
      constants.put(number(value), known);
    }
    return known;
  }

  /** The number of the input that a value of the outcome is, whole and with times; else -1. */
  int input(Value value) {
    int[] place = parts.get(value);
    return place != null && place.length == 1 ? place[0] : -1;
  }

  /** How a value of the outcome is built from the inputs and the computed integers. */
  Part part(Value value) {
    int[] place = parts.get(value);
    if (place != null) {
      return (registers, inputs) -> Shapes.at(inputs[place[0]], place, 1);
    }
    if (value instanceof Sym sym) {
      return (registers, inputs) -> IntValue.gen(registers[sym.register]);
    }
    if (value instanceof RecordValue record) {
      Part[] all = parts(record.values);
      return all == null ? new Part.Constant(value)
          : (r, in) -> new RecordValue(record.names, Part.built(all, r, in), record.isNormalized());
    }
    if (value instanceof FcnRcdValue function) {
      function.normalize();
      Part[] all = parts(function.values);
      Part[] domain = function.intv == null ? parts(function.domain) : null;
      if (all == null && domain == null) {
        return new Part.Constant(value);
      }
      return (r, in) ->
          function(
              function,
              domain == null ? null : Part.built(domain, r, in),
              all == null ? function.values : Part.built(all, r, in));
    }
    if (value instanceof TupleValue tuple) {
      Part[] all = parts(tuple.elems);
      return all == null ? new Part.Constant(value) : (r, in) -> new TupleValue(Part.built(all, r, in));
    }
    if (value instanceof SetEnumValue set) {
      set.normalize();
      Part[] all = parts(set.elems.toArray());
      return all == null ? new Part.Constant(value) : (r, in) -> new SetEnumValue(Part.built(all, r, in), true);
    }
    if (value instanceof IntValue || value instanceof BoolValue || value instanceof StringValue) {
      return new Part.Constant(value);
    }
    Value set = value.toSetEnum();
    if (set == null) {
      throw new UnsupportedOperationException("a value of another kind");
    }
    return part(set);
  }

  /** Null if all values are constant. */
  private Part[] parts(Value[] values) {
    var all = new Part[values.length];
    boolean constant = true;
    for (int i = 0; i < all.length; i++) {
      all[i] = part(values[i]);
      constant &= all[i] instanceof Part.Constant;
    }
    return constant ? null : all;
  }
}
