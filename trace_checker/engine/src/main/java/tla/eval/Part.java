package tla.eval;

import tlc2.value.impl.Value;

/** Builds a value of an outcome from the inputs and the computed integers of a {@link Recording}. */
interface Part {
  Value built(int[] registers, Value[] inputs);

  /** The same value whatever the times are. */
  record Constant(Value value) implements Part {
    @Override
    public Value built(int[] registers, Value[] inputs) {
      return value;
    }
  }

  static Value[] built(Part[] parts, int[] registers, Value[] inputs) {
    var values = new Value[parts.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = parts[i].built(registers, inputs);
    }
    return values;
  }
}
