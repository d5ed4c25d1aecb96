"""How far the work is, on standard error and on terminals only."""

import sys
import time
from collections.abc import Callable
from threading import Lock
from types import TracebackType
from typing import TYPE_CHECKING, Self

from s7check.log.errors import printable
from s7check.log.source import Source

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID

_BAR = 12
"""Characters of the bar itself."""

_DELAY = 1.0
"""Seconds before anything is shown: most calls are done by then."""


class ProgressBar:
    """A line with the number of logs done, the current log, its events and, of a file, the part read."""

    def __init__(self, logs: int) -> None:
        self._logs = logs
        self._done = 0
        self._name = ""
        self._begun = time.monotonic()
        self._lock = Lock()
        self._bar: Progress | None = None
        self._task: TaskID | None = None
        self._shown = sys.stderr is not None and sys.stderr.isatty()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, _: type[BaseException] | None, __: BaseException | None, ___: TracebackType | None) -> None:
        self.pause()

    def begin(self, name: str) -> None:
        """The log ``name`` is the next."""
        self._name = printable(name)
        self._show()

    def of(self, name: str) -> Callable[[Source, int], None]:
        """The ``update`` of the log ``name``: several are at work, and the latest is shown."""
        shown = printable(name)

        def update(source: Source, events: int) -> None:
            if shown == self._name:
                self.update(source, events)

        return update

    def update(self, source: Source, events: int) -> None:
        """``events`` events have been read from ``source``."""
        part = f", {source.taken / source.size:.0%}" if source.size else ""
        self._show(f"{events:,} events{part}")

    def trying(self) -> None:
        """The log is being judged by other readings."""
        self._show("other readings")

    def done(self) -> None:
        """The log at work is done."""
        self._done += 1

    def pause(self) -> None:
        """Takes the line away, for something else to be printed."""
        with self._lock:
            if self._bar is not None:
                self._bar.stop()
                self._bar = None

    def _show(self, counts: str = "") -> None:
        if not self._shown or time.monotonic() - self._begun < _DELAY:
            return
        with self._lock:
            if self._bar is None or self._task is None:
                self._bar, self._task = self._started()
            self._bar.update(self._task, description=self._name, counts=counts, completed=self._done)

    def _started(self) -> tuple["Progress", "TaskID"]:
        # Most calls show no bar: they do not wait for its library.
        from rich.console import Console
        from rich.progress import (
            BarColumn,
            MofNCompleteColumn,
            Progress,
            TextColumn,
            TimeElapsedColumn,
        )
        from rich.table import Column

        whole = Column(no_wrap=True)
        many = [BarColumn(_BAR), MofNCompleteColumn(table_column=whole)] if self._logs > 1 else []
        console = Console(stderr=True, highlight=False)
        bar = Progress(
            *many,
            # Where the line is short a name is cut, a count never.
            TextColumn("{task.description}", markup=False, table_column=Column(no_wrap=True, ratio=1)),
            TextColumn("{task.fields[counts]}", markup=False, table_column=whole),
            TimeElapsedColumn(table_column=whole),
            console=console,
            transient=True,
            expand=True,
        )
        bar.start()
        return bar, bar.add_task("", total=self._logs, counts="")
