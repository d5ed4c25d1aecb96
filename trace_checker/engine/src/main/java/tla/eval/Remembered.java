package tla.eval;

import java.util.Arrays;
import java.util.List;

import tlc2.value.impl.IntValue;
import tlc2.value.impl.Value;

/**
 * The evaluations of an operator on inputs of one shape: a tree of the comparisons that they make,
 * with an outcome at the end of each way. To evaluate the operator again only the integers on the
 * way are computed.
 *
 * @param <T> the type of an outcome
 */
final class Remembered<T> {
  /** The most ways through an operator that are kept. */
  private static final int MOST_WAYS = 64;

  /** So often inputs come before a way is recorded: to record costs as much as some evaluations. */
  private static final int OFTEN = 5;

  /** Steps, and after them a comparison or an outcome. */
  private static final class Node<T> {
    Recording.Step[] steps;
    /** The operation of each step and the registers or numbers that it takes, for speed. */
    Operation[] operations;
    int[] a;
    int[] b;
    int[][] places;
    int first;
    Recording.Step comparison;
    Node<T> yes;
    Node<T> no;
    T outcome;
  }

  private Node<T> root;
  private int ways;
  private int seen;
  private boolean given;

  /** Whether these inputs are worth recording: they come again, and nothing has failed. */
  boolean worthRecording() {
    return !given && ++seen >= OFTEN && ways < MOST_WAYS;
  }

  /** No more is recorded. */
  void giveUp() {
    given = true;
  }

  /**
   * The outcome for inputs of the shape, null if they take a way that is not known.
   *
   * @param registers room for the integers on the way
   */
  T outcome(Value[] inputs, int[] registers) {
    Node<T> node = root;
    while (node != null) {
      Operation[] operations = node.operations;
      for (int i = 0; i < operations.length; i++) {
        int a = node.a[i];
        registers[node.first + i] =
            switch (operations[i]) {
              case TAKE -> taken(inputs, node.places[i]);
              case CONSTANT -> a;
              default -> operations[i].on(registers[a], registers[node.b[i]]);
            };
      }
      if (node.comparison == null) {
        return node.outcome;
      }
      Recording.Step comparison = node.comparison;
      boolean holds = comparison.operation().on(registers[comparison.a()], registers[comparison.b()]) != 0;
      node = holds ? node.yes : node.no;
    }
    return null;
  }

  private static int taken(Value[] inputs, int[] place) {
    return ((IntValue) Shapes.at(inputs[place[0]], place, 1)).val;
  }

  /** Adds the way of a recording; false if it contradicts another way, which must not happen. */
  boolean add(Recording recording, T outcome) {
    ways++;
    List<Recording.Step> steps = recording.steps();
    Node<T> node = root;
    Node<T> last = null;
    boolean held = false;
    int begin = 0;
    int register = 0;
    for (int i = 0; i <= steps.size(); i++) {
      boolean end = i == steps.size();
      if (!end && !steps.get(i).operation().isComparison()) {
        continue;
      }
      if (node == null) {
        node = new Node<>();
        node.steps = steps.subList(begin, i).toArray(Recording.Step[]::new);
        node.operations = new Operation[node.steps.length];
        node.a = new int[node.steps.length];
        node.b = new int[node.steps.length];
        node.places = new int[node.steps.length][];
        for (int k = 0; k < node.places.length; k++) {
          node.operations[k] = node.steps[k].operation();
          node.a[k] = node.steps[k].a();
          node.b[k] = node.steps[k].b();
          if (node.steps[k].operation() == Operation.TAKE) {
            node.places[k] = recording.places().get(node.steps[k].a());
          }
        }
        node.first = register;
        node.comparison = end ? null : steps.get(i);
        if (last == null) {
          root = node;
        } else if (held) {
          last.yes = node;
        } else {
          last.no = node;
        }
      }
      if (!Arrays.asList(node.steps).equals(steps.subList(begin, i)) || end != (node.comparison == null)) {
        return false;
      }
      register += i - begin;
      begin = i + 1;
      if (end) {
        node.outcome = outcome;
      } else {
        last = node;
        held = steps.get(i).outcome();
        node = held ? node.yes : node.no;
      }
    }
    return true;
  }
}
