package s7.trace;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;

/**
 * A thread that takes what another one hands over, in its order: lines are read ahead of the judging.
 * Only one of the two works on what they share: whoever handed over waits ({@link #settle}) before it
 * touches that again.
 *
 * @param <T> what is handed over; the thread gets several at a time
 */
final class Ahead<T> {
  /** Items that are handed over together, and how many times that may wait. */
  private static final int TOGETHER = 128;

  private static final int WAITING = 16;

  /** What is done with an item. */
  interface Work<T> {
    void on(T item);
  }

  /** Items, or a sign that all before them are done. */
  private record Batch<T>(List<T> items, BlockingQueue<Boolean> done) {}

  private final Work<T> work;
  private final BlockingQueue<Batch<T>> queue = new ArrayBlockingQueue<>(WAITING);
  private final BlockingQueue<Boolean> settled = new ArrayBlockingQueue<>(1);
  private List<T> items = new ArrayList<>(TOGETHER);
  private boolean ahead;

  /** Starts the thread; an exception of {@code work} is handled as any uncaught one. */
  Ahead(String name, Work<T> work) {
    this.work = work;
    var thread = new Thread(this::run, name);
    thread.setDaemon(true);
    thread.start();
  }

  private void run() {
    try {
      while (true) {
        Batch<T> batch = queue.take();
        batch.items.forEach(work::on);
        if (batch.done != null) {
          batch.done.put(true);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Hands over an item, perhaps not before {@link #flush}. */
  void add(T item) {
    items.add(item);
    if (items.size() == TOGETHER) {
      flush();
    }
  }

  /** Hands over all that was added. */
  void flush() {
    if (!items.isEmpty()) {
      put(null);
    }
  }

  /** Waits until all that was added is done. */
  void settle() {
    if (ahead || !items.isEmpty()) {
      put(settled);
      try {
        settled.take();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
      ahead = false;
    }
  }

  private void put(BlockingQueue<Boolean> done) {
    try {
      queue.put(new Batch<>(items, done));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    items = new ArrayList<>(TOGETHER);
    ahead = true;
  }
}
