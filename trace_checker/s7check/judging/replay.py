"""A log judged again: under other headers, or for the steps between its lines."""

import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from msgspec.structs import replace

from s7check.engine.answer import Answer, OtherHeader
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.engine.process import EngineTooSlowError
from s7check.log.chosen import NOTHING, Chosen
from s7check.log.encoding import as_utf8
from s7check.log.errors import UnusableLogError
from s7check.log.profile_file import folder_of, header_line
from s7check.log.source import open_log
from s7check.report.clauses import texts
from s7check.report.report import Reading, Report

LONGEST = 4 * 1024 * 1024
"""Bytes of a log that is judged again."""

FOLLOWED = 160
"""Lines before the verdict of which a report shows the situations."""


class TooLongError(Exception):
    """The log is too long, or was a stream that is gone."""


class Replay:
    """The text of a log, in memory. Raises TooLongError."""

    def __init__(self, name: str, lines: Sequence[bytes], chosen: Chosen = NOTHING) -> None:
        self._data = b"\n".join(lines) + b"\n" if name == "-" else _bytes_of(name)
        self._folder = folder_of(name)
        self._chosen = chosen

    @property
    def lines(self) -> list[bytes]:
        """The lines of the log."""
        return self._data.removesuffix(b"\n").split(b"\n")

    def others(self, engine: Engine, report: Report | None = None) -> list[OtherHeader]:
        """The headers beside the log's own with what was chosen; none if that cannot be read.

        ``report`` tells which of them matter.
        """
        rejected: dict[str, Any] = {}
        if report is not None and report.verdict == "rejected":
            candidates = [name for one in report.candidates for name in one.requirements]
            rejected = {"rules": [*report.requirements, *candidates]}
            rejected |= {} if report.asked is None else {"asked": report.asked}
        header = header_line(self._data) or self._data
        return engine.read(header, self._folder, self._chosen.message(), rejected).others

    def judge(
        self,
        engine: Engine,
        changes: Chosen = NOTHING,
        last: int | None = None,
        follow: int = 0,
        until: float | None = None,
    ) -> Answer:
        """The engine's answer to the log under another header, up to the line ``last``; ``until`` as in ``begin``."""
        data = self._data if last is None else b"\n".join(self._data.split(b"\n", last)[:last])
        engine.begin(self._chosen.but(changes).message(), follow, until, self._folder)
        engine.send(data)
        return engine.finish()

    def reading(self, engine: Engine, other: OtherHeader, until: float | None = None) -> Reading | None:
        """The verdict about the log under another header; none if the engine fails.

        None if the engine has no verdict at the time ``until`` of ``time.monotonic``.
        """
        if until is not None and time.monotonic() > until:
            return None
        try:
            answer = self.judge(engine, Chosen.of(other.chosen), until=until)
        except EngineTooSlowError:
            return None
        except EngineError:
            return Reading(other.kind, other.change, "no verdict")
        line = answer.line if answer.unusable is None else answer.unusable.line
        return Reading(other.kind, other.change, "no verdict" if answer.verdict == "error" else answer.verdict, line)


def with_readings(report: Report, engine: Engine, replay: Replay, until: float | None = None) -> Report:
    """The report with the verdicts under other CPUs, other profiles, and one other letter at a time.

    The engine says under which the verdict stays, and which matter most; these come first. At the time ``until`` of
    ``time.monotonic`` it ends.
    """
    engine.tell(texts)
    others = replay.others(engine, report)
    if not others:
        return report
    tried: dict[str, Reading | None] = {}
    for one in sorted(others, key=lambda one: one.distance):
        same = Reading(one.kind, one.change, "rejected", report.line)
        tried[one.change] = same if one.same else replay.reading(engine, one, until)
    readings = [reading for one in others if (reading := tried[one.change]) is not None]
    untried = [one.change for one in others if tried[one.change] is None]
    engine.tell(texts)  # the engine may be another one by now
    said = engine.readings(
        verdict=report.verdict, line=report.line, tried=readings, untried=untried, remedy=" (see --budget)"
    )
    return replace(report, readings=readings, untried=untried, compared=said)


def with_steps(report: Report, engine: Engine, replay: Replay) -> Report:
    """The report with the log's lines and the situations after them."""
    last = report.line if report.verdict != "accepted" else None
    answer = replay.judge(engine, last=last, follow=FOLLOWED)
    return replace(report, lines=replay.lines, steps=answer.steps)


def _bytes_of(name: str) -> bytes:
    data = b""
    try:
        if not Path(name).is_file():
            raise TooLongError
        with open_log(name) as source:
            for chunk in as_utf8(source.chunks()):
                data += chunk
                if len(data) > LONGEST:
                    raise TooLongError
    except (OSError, ValueError) as error:
        raise TooLongError from error
    except UnusableLogError:
        pass  # a damaged end was reported already
    return data
