package s7.log;

import java.util.ArrayDeque;

/**
 * Tells lines whose {@code at} is written in seconds or minutes how far they may reach: {@code until} is the {@code at} of
 * the first line behind them, within their step, that is written finer. They are kept back until it has come or their
 * step is over; all other lines pass at once.
 */
public final class Onward implements LogReader.Taker {
  /** The most lines that are kept back: a log need not have finer ones. */
  private static final int MOST = 100;

  private final LogReader.Taker taker;
  private final ArrayDeque<Kept> kept = new ArrayDeque<>();

  private record Kept(int line, Fields event) {
    long at() {
      return ((Moment) event.get(Events.AT)).inMilliseconds();
    }

    int step() {
      return event.has(Events.STEP) ? event.number(Events.STEP) : 1;
    }

    /** Whether a line like this one has nothing to wait for. */
    boolean isReady() {
      return step() == 1 || event.has(Events.UNTIL);
    }

    /** Whether nothing is to wait for any more behind this later line. */
    boolean isOverAt(Kept later) {
      return later.at() < at() || later.at() >= at() + step();
    }
  }

  /**
   * @param taker takes the lines
   */
  public Onward(LogReader.Taker taker) {
    this.taker = taker;
  }

  @Override
  public void header(Fields header) {
    taker.header(header);
  }

  @Override
  public void event(int line, Fields event) {
    if (kept.isEmpty() && !event.has(Events.STEP)) {
      taker.event(line, event);
      return;
    }
    var last = new Kept(line, event);
    for (Kept each : kept) {
      if (!each.isReady() && !each.isOverAt(last) && last.step() < each.step()) {
        each.event.add(Events.UNTIL, event.get(Events.AT));
      }
    }
    kept.add(last);
    while (!kept.isEmpty() && (kept.size() > MOST || kept.peek().isReady() || kept.peek().isOverAt(last))) {
      pass();
    }
  }

  private void pass() {
    Kept first = kept.poll();
    taker.event(first.line, first.event);
  }

  /** Nothing follows: no line is kept back any longer. */
  public void end() {
    while (!kept.isEmpty()) {
      pass();
    }
  }
}
