"""How far the work is, on standard error and on terminals only."""

import sys
import time
from types import TracebackType
from typing import TYPE_CHECKING, Self

from s7check.log.errors import printable
from s7check.log.source import Source

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID

_DELAY = 1.0
"""Seconds before anything is shown: most calls are done by then."""


class ProgressBar:
    """A line with the number of logs done, the current log, its events and, of a file, the part read."""

    def __init__(self, logs: int) -> None:
        self._logs = logs
        self._done = 0
        self._name = ""
        self._begun = time.monotonic()
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
        self._show(self._name)

    def update(self, source: Source, events: int) -> None:
        """``events`` events have been read from ``source``."""
        part = f", {source.taken / source.size:.0%}" if source.size else ""
        self._show(f"{self._name}: {events:,} events{part}")

    def trying(self) -> None:
        """The log is being judged by other readings."""
        self._show(f"{self._name}: other readings")

    def done(self) -> None:
        """The log at work is done."""
        self._done += 1

    def pause(self) -> None:
        """Takes the line away, for something else to be printed."""
        if self._bar is not None:
            self._bar.stop()
            self._bar = None

    def _show(self, text: str) -> None:
        if not self._shown or time.monotonic() - self._begun < _DELAY:
            return
        if self._bar is None or self._task is None:
            self._bar, self._task = self._started()
        self._bar.update(self._task, description=text, completed=self._done)

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

        many = [BarColumn(), MofNCompleteColumn()] if self._logs > 1 else []
        console = Console(stderr=True, highlight=False)
        bar = Progress(
            *many, TextColumn("{task.description}", markup=False), TimeElapsedColumn(), console=console, transient=True
        )
        bar.start()
        return bar, bar.add_task("", total=self._logs)
