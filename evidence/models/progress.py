"""The output while models run."""

from __future__ import annotations

import time

from rich.console import Console
from rich.live import Live
from rich.text import Text

from evidence.common.console import plain
from evidence.models.judge import Result
from evidence.models.runner import Event

QUIET_SECONDS = 20
"""Least time between two progress lines of one model where there is no terminal."""


class Progress:
    """Shows running models: a live table on a terminal, lines elsewhere. A context manager; call it with each event."""

    def __init__(self, console: Console, total: int) -> None:
        """Show the progress of `total` models on `console`."""
        self._console = console
        self._total = total
        self._done = 0
        self._running: dict[str, str] = {}
        self._told: dict[str, float] = {}
        self._live = Live(console=console, refresh_per_second=4, transient=True) if console.is_terminal else None

    def __enter__(self) -> Progress:
        """Start showing."""
        if self._live:
            self._live.start()
        return self

    def __exit__(self, *_: object) -> None:
        """Stop showing."""
        if self._live:
            self._live.stop()

    def __call__(self, event: Event) -> None:
        """Show one event."""
        name = event.model.name
        line = None
        if event.result is not None:
            self._done += 1
            self._running.pop(name, None)
            line = f"[{self._done}/{self._total}] {name}: {brief(event.result)}, {event.result.seconds:.1f} s"
        else:
            self._running[name] = event.text or "started"
            now = time.monotonic()
            if not self._live and (not event.text or now - self._told[name] >= QUIET_SECONDS):
                self._told[name] = now
                line = f"        {name}: {self._running[name]}"
        if self._live:
            self._live.update(Text("\n".join(f"        {n}: {text}" for n, text in self._running.items())))
        if line:
            self._line(line)

    def _line(self, text: str) -> None:
        plain(self._console, text)


def brief(result: Result) -> str:
    """Return "as pinned: ..." or "DRIFT: ..." with what came."""
    if result.ok:
        names = result.model.expect.property if result.outcome.kind != "passed" else None
        return f"as pinned: {result.outcome.kind}{f' {names}' if names else ''}"
    return f"DRIFT: {(result.problems + result.count_problems)[0]}"
