package s7.jvm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Semaphore;
import java.util.stream.IntStream;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** The thread that judges while lines are read. */
class AheadTest {
  private final List<Integer> done = new ArrayList<>();

  @Test
  @DisplayName("all items are done, in their order, when the one who added them has waited")
  void order() {
    var ahead = new Ahead("ahead");
    List<Integer> items = IntStream.range(0, 10_000).boxed().toList();
    items.forEach(item -> ahead.add(() -> done.add(item)));
    ahead.settle();
    assertEquals(items, List.copyOf(done));
    ahead.add(() -> done.add(-1));
    ahead.settle();
    ahead.settle();
    assertEquals(-1, done.get(items.size()));
  }

  @Test
  @DisplayName("items that were flushed are done without waiting; one who adds many more waits for the thread")
  void flush() throws InterruptedException {
    var may = new Semaphore(0);
    var has = new Semaphore(0);
    var ahead = new Ahead("ahead");
    Runnable item =
        () -> {
          may.acquireUninterruptibly();
          done.add(1);
          has.release();
        };
    ahead.add(item);
    ahead.flush();
    may.release();
    has.acquire();
    assertEquals(List.of(1), List.copyOf(done));
    var adding = new Thread(() -> IntStream.range(0, 100_000).forEach(i -> ahead.add(item)));
    adding.start();
    may.release(10);
    has.acquire(10);
    assertEquals(11, done.size());
    assertTrue(adding.isAlive());
    may.release(100_000);
    adding.join();
    ahead.settle();
    assertEquals(100_001, done.size());
  }
}
