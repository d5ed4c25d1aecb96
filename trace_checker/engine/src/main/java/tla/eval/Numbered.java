package tla.eval;

import java.util.Arrays;

/** Objects by 64-bit numbers that are well mixed: a map without an object for each number. */
final class Numbered<T> {
  private static final int LEAST = 1 << 10;

  private long[] numbers = new long[LEAST];
  private Object[] objects = new Object[LEAST];
  private int size;

  int size() {
    return size;
  }

  /** The object of a number; null if it has none. */
  @SuppressWarnings("unchecked")
  T get(long number) {
    return (T) objects[place(number)];
  }

  /** Gives an object to a number that has none. */
  void put(long number, T object) {
    if (2 * ++size > objects.length) {
      grow();
    }
    int place = place(number);
    numbers[place] = number;
    objects[place] = object;
  }

  void clear() {
    Arrays.fill(objects, null);
    size = 0;
  }

  /** The place where a number is, or where it would be. */
  private int place(long number) {
    int last = objects.length - 1;
    int place = (int) number & last;
    while (objects[place] != null && numbers[place] != number) {
      place = (place + 1) & last;
    }
    return place;
  }

  private void grow() {
    long[] oldNumbers = numbers;
    Object[] oldObjects = objects;
    numbers = new long[2 * oldNumbers.length];
    objects = new Object[numbers.length];
    for (int i = 0; i < oldObjects.length; i++) {
      if (oldObjects[i] != null) {
        int place = place(oldNumbers[i]);
        numbers[place] = oldNumbers[i];
        objects[place] = oldObjects[i];
      }
    }
  }
}
