"""The verdicts that are compared, each with its line."""

from __future__ import annotations

from dataclasses import dataclass

from evidence.logs.random_logs import Generated


@dataclass(frozen=True)
class Judged:
    """A verdict about a log. `line` is the physical line, counted from 1, that decides a log that is rejected."""

    verdict: str
    line: int | None = None

    def __str__(self) -> str:
        return self.verdict if self.line is None else f"{self.verdict} at line {self.line}"


@dataclass(frozen=True)
class Compared:
    """A log, counted from 1, and its two verdicts. `event` is the event that the engine rejects, or empty."""

    number: int
    log: Generated
    event: str
    engine: Judged
    tlc: Judged

    @property
    def agree(self) -> bool:
        """Whether both say the same of the same line."""
        return self.engine == self.tlc
