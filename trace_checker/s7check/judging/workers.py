"""Work on many logs at a time: each thread has an engine of its own, and results come in the order of the logs."""

import os
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Future, wait
from queue import SimpleQueue
from threading import Semaphore, Thread
from types import TracebackType
from typing import Self, TypeVar

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


class Workers:
    """Threads that judge logs, each with an engine that ``start`` makes; at most one for each processor.

    An engine that fails costs the log that it was judging. As a context manager it ends the engines; after an
    exception it kills them, and waits for nobody.
    """

    def __init__(self, start: Callable[[], Engine]) -> None:
        self._start = start
        self._most = min(_processors(), _MOST)
        self._todo: SimpleQueue[Callable[[Engine], None] | None] = SimpleQueue()
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
                self._todo.put(None)
            for thread in self._threads:
                thread.join()
        for engine in self._engines:
            engine.__exit__(kind, error, at)

    def in_order(self, items: Iterable[_Item], work: Callable[[_Item, Engine], _Result]) -> Iterator[Future[_Result]]:
        """What ``work`` makes of each item, in the order of the items."""
        under_way: deque[Future[_Result]] = deque()
        for item in items:
            while under_way and len(under_way) >= self._ahead():
                alone = _ALONE - self._busy_for()
                if alone <= 0 or wait(under_way, alone).done:
                    yield under_way.popleft()
            under_way.append(self.submit(item, work))
        yield from under_way

    def submit(self, item: _Item, work: Callable[[_Item, Engine], _Result]) -> Future[_Result]:
        """What ``work`` makes of an item, after all that was submitted before."""
        future: Future[_Result] = Future()

        def job(engine: Engine) -> None:
            try:
                future.set_result(work(item, engine))
            except BaseException as error:  # it is raised where the result is asked for
                future.set_exception(error)

        self._todo.put(job)
        if not self._idle.acquire(blocking=False) and len(self._threads) < self._most:
            engine = self._start()
            self._engines.append(engine)
            # A daemon: it may wait for a stream that never ends.
            self._threads.append(Thread(target=self._run, args=(engine,), daemon=True))
            self._threads[-1].start()
        return future

    def _run(self, engine: Engine) -> None:
        while (job := self._todo.get()) is not None and not self._broken_off:
            job(engine)
            self._idle.release()

    def _busy_for(self) -> float:
        return time.monotonic() - self._begun

    def _ahead(self) -> int:
        return 1 if self._busy_for() < _ALONE else _AHEAD * self._most
