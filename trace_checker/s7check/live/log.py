"""A log that grows: its file, its verdict, and what must come next."""

import json
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from s7check.api import Checker, NotAcceptedError
from s7check.asking.line_text import iso_of
from s7check.asking.session import Session
from s7check.engine import pool
from s7check.engine.command import EngineError
from s7check.log.errors import UnusableLogError
from s7check.report.report import Report

_LONGEST = 100_000
"""Lines for which the engine keeps the way back; beyond them nobody looks ahead."""


class GrowingLog:
    """A log behind ``header``, written to ``file`` if there is one. A log that was judged takes no more lines."""

    def __init__(self, name: str, file: Path | None, header: dict[str, Any]) -> None:
        self.name = name
        self.header = header
        self.events = 0
        self.report: Report | None = None
        self._lines: list[bytes] = []
        self._file = None if file is None else file.open("wb")
        self._checker = Checker(name=name)
        self._engine = pool.take()
        self._ahead: Session | None = Session(self._engine, header)
        self._write(header)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, _: type[BaseException] | None, __: BaseException | None, ___: TracebackType | None) -> None:
        self.close()

    def add(self, event: dict[str, Any]) -> Report | None:
        """The next event; the report if the log is not accepted with it."""
        self.events += 1
        self._write(event)
        self._look_ahead(event)
        return self.report

    def silent(self, at: str) -> Report | None:
        """Nothing else happened up to this reading of the clock; the report if something had to come until then.

        The log then ends with a line that says so.
        """
        end = {"event": "done", "at": at}
        if self._ahead is None or at <= self._ahead.clock or self.allows(end):
            return None
        self._write(end)
        return self.report

    def allows(self, event: dict[str, Any]) -> bool:
        """Whether the event may come next; so it is where nobody looks ahead any more."""
        try:
            return self._ahead is None or self._ahead.why(event) is None
        except (EngineError, UnusableLogError):
            self._look_no_more()
            return True

    def due(self) -> list[tuple[str, str]]:
        """By when something must come, and what."""
        if self._ahead is None or self.report is not None:
            return []
        try:
            possible = self._ahead.possible([])
        except EngineError:
            self._look_no_more()
            return []
        return [
            (iso_of(time.at), " or ".join(one.text for one in time.due))
            for time in possible.times
            if time.due and not possible.endless
        ]

    def close(self, until: str | None = None) -> Report:
        """The verdict; the file is complete. If nothing is missing up to ``until``, the log says so at its end."""
        if until is not None and self.report is None and (self._ahead is None or until > self._ahead.clock):
            self._write({"event": "done", "at": until})
        if self._file is not None:
            self._file.close()
            self._file = None
        report = self._checker.report()
        if self._ahead is not None:
            self._ahead.close()
            self._ahead = None
            pool.give_back(self._engine)
        self.report = self.report or report
        return self.report

    def _write(self, line: dict[str, Any]) -> None:
        self._lines.append(_text(line))
        if self._file is not None:
            self._file.write(self._lines[-1])
            self._file.flush()
        try:
            self._checker.feed(self._lines[-1])
        except NotAcceptedError as error:
            self.report = error.report

    def _look_ahead(self, event: dict[str, Any]) -> None:
        if self._ahead is None or self.report is not None:
            return
        try:
            refused = self._ahead.feed(event) is not None
        except (EngineError, UnusableLogError):
            refused = True
        if refused or self.events > _LONGEST:
            self._look_no_more()

    def _look_no_more(self) -> None:
        self._ahead = None
        self._engine.__exit__(None, None, None)


def _text(line: dict[str, Any]) -> bytes:
    return json.dumps(line, ensure_ascii=False).encode() + b"\n"
