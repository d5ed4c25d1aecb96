"""Work on many logs at a time: each thread has an engine of its own, and results come in the order of the logs."""

import os
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from threading import Event, Semaphore, Thread
from types import TracebackType
from typing import Generic, Self, TypeVar

from s7check.engine.client import Engine

_ALONE = 1.0
"""Seconds of work before a second engine is started: its start costs half of that."""

_MOST = 16
"""Engines at most; each may take 448 MB for its heap."""

_AHEAD = 4
"""Logs for each engine that are at work, or done before their turn."""

_Item = TypeVar("_Item")
_Result = TypeVar("_Result")


def _processors() -> int:
    """The processors that this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not on every system
        return os.cpu_count() or 1


class Outcome(Generic[_Result]):
    """What a job has come to, once it is done; ``concurrent.futures`` would cost a short call 5 ms for logging."""

    def __init__(self) -> None:
        self.done = Event()
        self._found: _Result
        self._error: BaseException | None = None

    def settle(self, work: Callable[[], _Result]) -> None:
        """Do the job."""
        try:
            self._found = work()
        except BaseException as error:  # it is raised where the result is asked for
            self._error = error
        self.done.set()

    def result(self) -> _Result:
        """The result, or the exception; blocks until the job is done."""
        self.done.wait()
        if self._error is not None:
            raise self._error
        return self._found


class Workers:
    """Threads that judge logs, each with an engine that ``start`` makes; at most one for each processor.

    An engine that fails costs the log that it was judging. As a context manager it ends the engines; after an
    exception it kills them, and waits for nobody.
    """

    def __init__(self, start: Callable[[], Engine]) -> None:
        self._start = start
        self._most = min(_processors(), _MOST)
        self._todo: deque[Callable[[Engine], None] | None] = deque()
        self._waiting = Semaphore(0)
        self._idle = Semaphore(0)
        self._engines: list[Engine] = []
        self._threads: list[Thread] = []
        self._begun = time.monotonic()
        self._broken_off = False

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._broken_off = kind is not None
        if not self._broken_off:
            for _ in self._threads:
                self._put(None)
            for thread in self._threads:
                thread.join()
        for engine in self._engines:
            engine.__exit__(kind, error, at)

    def in_order(self, items: Iterable[_Item], work: Callable[[_Item, Engine], _Result]) -> Iterator[Outcome[_Result]]:
        """What ``work`` makes of each item, in the order of the items."""
        under_way: deque[Outcome[_Result]] = deque()
        for item in items:
            while under_way and len(under_way) >= self._ahead():
                alone = _ALONE - self._busy_for()
                if alone <= 0 or under_way[0].done.wait(alone):
                    yield under_way.popleft()
            under_way.append(self.submit(item, work))
        yield from under_way

    def submit(self, item: _Item, work: Callable[[_Item, Engine], _Result]) -> Outcome[_Result]:
        """What ``work`` makes of an item, after all that was submitted before."""
        outcome: Outcome[_Result] = Outcome()
        self._put(lambda engine: outcome.settle(lambda: work(item, engine)))
        if not self._idle.acquire(blocking=False) and len(self._threads) < self._most:
            engine = self._start()
            self._engines.append(engine)
            # A daemon: it may wait for a stream that never ends.
            self._threads.append(Thread(target=self._run, args=(engine,), daemon=True))
            self._threads[-1].start()
        return outcome

    def _run(self, engine: Engine) -> None:
        while (job := self._next()) is not None and not self._broken_off:
            job(engine)
            self._idle.release()

    def _put(self, job: Callable[[Engine], None] | None) -> None:
        self._todo.append(job)
        self._waiting.release()

    def _next(self) -> Callable[[Engine], None] | None:
        self._waiting.acquire()
        return self._todo.popleft()

    def _busy_for(self) -> float:
        return time.monotonic() - self._begun

    def _ahead(self) -> int:
        return 1 if self._busy_for() < _ALONE else _AHEAD * self._most
