package s7.jvm;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;

import s7.trace.Handover;

/**
 * A thread that takes what another one hands over, in its order: lines are read ahead of the judging.
 * Only one of the two works on what they share: whoever handed over waits ({@link #settle}) before it
 * touches that again.
 */
final class Ahead implements Handover {
  /** Items that are handed over together, and how many times that may wait. */
  private static final int TOGETHER = 128;

  private static final int WAITING = 16;

  /** Items, or a sign that all before them are done. */
  private record Batch(List<Runnable> items, BlockingQueue<Boolean> done) {}

  private final BlockingQueue<Batch> queue = new ArrayBlockingQueue<>(WAITING);
  private final BlockingQueue<Boolean> settled = new ArrayBlockingQueue<>(1);
  private List<Runnable> items = new ArrayList<>(TOGETHER);
  private boolean ahead;

  /** Starts the thread; an exception of an item is handled as any uncaught one. */
  Ahead(String name) {
    var thread = new Thread(this::run, name);
    thread.setDaemon(true);
    thread.start();
  }

  private void run() {
    try {
      while (true) {
        Batch batch = queue.take();
        batch.items.forEach(Runnable::run);
        if (batch.done != null) {
          batch.done.put(true);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void add(Runnable item) {
    items.add(item);
    if (items.size() == TOGETHER) {
      flush();
    }
  }

  @Override
  public void flush() {
    if (!items.isEmpty()) {
      put(null);
    }
  }

  @Override
  public void settle() {
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
      queue.put(new Batch(items, done));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    items = new ArrayList<>(TOGETHER);
    ahead = true;
  }
}
