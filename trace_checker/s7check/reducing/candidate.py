"""Logs in pieces, and the question whether such a log is rejected like the original."""

import time
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import msgspec

from s7check.asking.session import Session
from s7check.engine.answer import Answer
from s7check.engine.client import Engine
from s7check.engine.process import EngineTooSlowError
from s7check.log.errors import UnusableLogError
from s7check.report.report import Report

Fields = Mapping[str, Any]

_PATIENCE = 2.0
"""Seconds for a candidate. Where much is open a whole log may take minutes, and what is left of it is to be small."""


class OutOfTimeError(Exception):
    """There is no time left for another candidate."""


@dataclass(frozen=True)
class Event:
    """A line of a log."""

    fields: Fields

    def with_fields(self, changes: Fields, without: Sequence[str] = ()) -> "Event":
        """The same line with other fields."""
        return Event({name: value for name, value in {**self.fields, **changes}.items() if name not in without})


class Judge:
    """Judges candidates in one engine until ``until`` of ``time.monotonic``.

    A candidate fits if it is readable, and rejected at its last line, too late or not as the first one, by rules among
    which is the first requirement that decided there. If it is too late, the same events had to come before it.
    """

    def __init__(self, engine: Engine, rejection: Report, until: float) -> None:
        """``rejection`` is the report of the log itself, which is not judged again: that may take minutes."""
        self._engine = engine
        self._late = bool(rejection.late)
        self._owed = rejection.expected
        self._decided = set(rejection.requirements[:1])
        self._until = until

    def fits(self, header: Fields, events: Sequence[Event]) -> bool:
        """Whether the log is rejected alike. Raises EngineError, and OutOfTimeError."""
        if time.monotonic() > self._until:
            raise OutOfTimeError
        answer = self.answer(header, events)
        return (
            answer is not None
            and answer.verdict == "rejected"
            and answer.line == len(events) + 1
            and answer.late == self._late
            and (not self._late or [one.text for one in answer.expected] == self._owed)
            and self._decided <= set(answer.requirements)
        )

    def explained(self, header: Fields, events: Sequence[Event]) -> list[Event]:
        """The log without the rejected lines before its last line. Raises EngineError, and OutOfTimeError."""
        try:
            session = Session(self._engine, header)
        except UnusableLogError:
            return list(events)
        kept = []
        for one in events[:-1]:
            if time.monotonic() > self._until:
                raise OutOfTimeError
            with suppress(UnusableLogError):
                if session.feed(one.fields) is None:
                    kept.append(one)
        session.close()
        return [*kept, events[-1]]

    def answer(self, header: Fields, events: Sequence[Event]) -> Answer | None:
        """The engine's answer; none if it takes too long. Raises EngineError."""
        try:
            self._engine.begin(until=time.monotonic() + _PATIENCE)
            self._engine.send(as_text(header, events))
            return self._engine.finish()
        except EngineTooSlowError:
            # Without the lines in between time may elapse for years; the next candidate gets a new engine.
            return None


def as_text(header: Fields, events: Iterable[Event]) -> bytes:
    """The log as a file has it."""
    encoder = msgspec.json.Encoder()
    return b"".join(encoder.encode(fields) + b"\n" for fields in [header, *(one.fields for one in events)])
