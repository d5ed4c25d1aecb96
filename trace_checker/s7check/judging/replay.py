"""A log judged again: under other headers, or for the steps between its lines."""

import time
from collections.abc import Sequence
from pathlib import Path

from msgspec.structs import replace

from s7check.engine.answer import Answer
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.engine.process import EngineTooSlowError
from s7check.log.chosen import NOTHING, Chosen
from s7check.log.encoding import as_utf8
from s7check.log.errors import UnusableLogError
from s7check.log.profile_file import folder_of, header_line
from s7check.log.source import open_log
from s7check.report.clauses import clause, named
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

    def others(self, engine: Engine) -> list[tuple[Reading, Chosen]]:
        """The headers beside the log's own with what was chosen; none if that cannot be read."""
        header = header_line(self._data) or self._data
        found = engine.read(header, self._folder, self._chosen.message(), others=True).others
        return [(Reading(one.kind, one.change, "no verdict"), Chosen.of(one.chosen)) for one in found]

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

    def reading(self, engine: Engine, reading: Reading, changes: Chosen, until: float | None = None) -> Reading | None:
        """``reading`` with the verdict about the log when its header is changed; none if the engine fails.

        None if the engine has no verdict at the time ``until`` of ``time.monotonic``.
        """
        if until is not None and time.monotonic() > until:
            return None
        try:
            answer = self.judge(engine, changes, until=until)
        except EngineTooSlowError:
            return None
        except EngineError:
            return replace(reading, verdict="no verdict")
        if answer.verdict == "error":
            return replace(reading, verdict="no verdict", line=answer.line)
        line = answer.line if answer.unusable is None else answer.unusable.line
        return replace(reading, verdict=answer.verdict, line=line)


def with_readings(report: Report, engine: Engine, replay: Replay, until: float | None = None) -> Report:
    """The report with the verdicts under other CPUs, other profiles, and one other letter at a time.

    A letter on which nothing in the log depends leaves the verdict as it is. Of the others those that bear on the rule
    that decided come first. At the time ``until`` of ``time.monotonic`` it ends.
    """
    all_changes = replay.others(engine)
    if not all_changes:
        return report
    tried: dict[str, Reading | None] = {}
    for reading, changes in sorted(all_changes, key=lambda pair: _distance(pair[0], report)):
        tried[reading.change] = (
            replace(reading, verdict="rejected", line=report.line)
            if _same(reading, report)
            else replay.reading(engine, reading, changes, until)
        )
    outcomes = [(reading.change, tried[reading.change]) for reading, _ in all_changes]
    return replace(
        report,
        readings=[outcome for _, outcome in outcomes if outcome is not None],
        untried=[change for change, outcome in outcomes if outcome is None],
    )


def _same(reading: Reading, report: Report) -> bool:
    """Whether the log is rejected alike under a reading: its question was not asked."""
    known = reading.kind == "letter" and report.verdict == "rejected" and report.asked is not None
    return known and reading.change.split()[0] not in (report.asked or ())


def _distance(reading: Reading, report: Report) -> int:
    """How far a reading is from the rule that decided: 0 if the rule is the question that it answers."""
    if reading.kind != "letter":
        return 2
    ambiguity = reading.change.split()[0]
    rules = {*report.requirements, *(rule for candidate in report.candidates for rule in candidate.requirements)}
    if ambiguity in rules:
        return 0
    return 1 if any(ambiguity in named(clause(rule).text) for rule in rules) else 3


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
