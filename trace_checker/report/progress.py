"""How far the reading of a long log is, on standard error and on terminals only."""

import sys
import time
from types import TracebackType

from rich.console import Console
from rich.status import Status

from trace_checker.log.errors import printable
from trace_checker.log.source import Source

_DELAY = 1.0
"""Seconds before anything is shown: most logs are done by then."""


class ProgressLine:
    """A line that shows the log, its events so far and, of a file, the part read."""

    def __init__(self, name: str) -> None:
        self._name = printable(name)
        self._begun = time.monotonic()
        self._status: Status | None = None
        self._shown = sys.stderr is not None and sys.stderr.isatty()

    def __enter__(self) -> "ProgressLine":
        return self

    def __exit__(self, _: type[BaseException] | None, __: BaseException | None, ___: TracebackType | None) -> None:
        if self._status is not None:
            self._status.stop()

    def update(self, source: Source, events: int) -> None:
        """Shows that ``events`` events have been read from ``source``."""
        if not self._shown or time.monotonic() - self._begun < _DELAY:
            return
        part = f", {source.taken / source.size:.0%}" if source.size else ""
        text = f"{self._name}: {events:,} events{part}"
        if self._status is None:
            self._status = Console(stderr=True, markup=False, highlight=False).status(text)
            self._status.start()
        else:
            self._status.update(text)
