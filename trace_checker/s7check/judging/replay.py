"""A log judged again: under other headers, or for the steps between its lines."""

import time
from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from s7check.engine.answer import Alternatives, Answer
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.engine.process import EngineTooSlowError
from s7check.log.chosen import NOTHING, Chosen
from s7check.log.errors import UnusableLogError
from s7check.log.profile_file import folder_of
from s7check.log.reader import read_log
from s7check.log.source import open_log
from s7check.log.tables import PRIORITY_CPUS
from s7check.report.clauses import clause, named
from s7check.report.report import Reading, Report, Verdict

LONGEST = 4 * 1024 * 1024
"""Bytes of a log that is judged again."""

FOLLOWED = 160
"""Lines before the verdict of which a report shows the situations."""


class TooLongError(Exception):
    """The log is too long, or was a stream that is gone."""


class Replay:
    """The events of a log, in memory. Raises TooLongError."""

    def __init__(self, name: str, lines: Sequence[bytes], chosen: Chosen = NOTHING) -> None:
        data = b"\n".join(lines) + b"\n" if name == "-" else _bytes_of(name)
        self.lines: list[bytes] = []
        self.header: dict[str, Any] = {}
        self._events: list[dict[str, Any]] = []
        self._unusable: int | None = None
        try:
            for batch in read_log([data], folder_of(name)):
                self.lines += batch.lines.texts
                self.header = batch.header or self.header
                self._events += batch.events
        except UnusableLogError as error:
            self._unusable = error.line
        if self.header:
            self.header = chosen.in_place_of(self.header)

    def judge(
        self,
        engine: Engine,
        header: dict[str, Any],
        last: int | None = None,
        follow: int = 0,
        until: float | None = None,
    ) -> Answer:
        """The engine's answer to the log under ``header``, up to the line ``last``; ``until`` as in ``begin``."""
        engine.begin(header, follow, until)
        engine.send([event for event in self._events if last is None or event["line"] <= last])
        return engine.finish()

    def reading(
        self, engine: Engine, reading: Reading, changes: dict[str, Any], until: float | None = None
    ) -> Reading | None:
        """``reading`` with the verdict about the log when its header is changed; none if the engine fails.

        None if the engine has no verdict at the time ``until`` of ``time.monotonic``.
        """
        if until is not None and time.monotonic() > until:
            return None
        try:
            answer = self.judge(engine, self.header | changes, until=until)
        except EngineTooSlowError:
            return None
        except EngineError:
            return replace(reading, verdict="no verdict")
        if answer.verdict == "rejected":
            return replace(reading, verdict="rejected", line=answer.line)
        if answer.verdict == "error":
            return replace(reading, verdict="no verdict", line=answer.line)
        verdict: Verdict = "accepted" if self._unusable is None else "unusable"
        return replace(reading, verdict=verdict, line=self._unusable)


def with_readings(report: Report, engine: Engine, replay: Replay, until: float | None = None) -> Report:
    """The report with the verdicts under other CPUs, other profiles, and one other letter at a time.

    A letter on which nothing in the log depends leaves the verdict as it is. Of the others those that bear on the rule
    that decided come first. At the time ``until`` of ``time.monotonic`` it ends.
    """
    if not replay.header:
        return report
    all_changes = list(_changes(replay.header, engine.alternatives()))
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
    if not replay.header:
        return replace(report, lines=replay.lines)
    last = report.line if report.verdict != "accepted" else None
    answer = replay.judge(engine, replay.header, last, FOLLOWED)
    return replace(report, lines=replay.lines, steps=answer.steps)


def _changes(header: dict[str, Any], others: Alternatives) -> Iterable[tuple[Reading, dict[str, Any]]]:
    for family in others.families:
        if family != header["cpu"]:
            priority = header["priority"] if family in PRIORITY_CPUS else []
            yield Reading("cpu", f"cpu {family}", "no verdict"), {"cpu": family, "priority": priority}
    for profile in ["", *others.profiles]:
        if profile != header["profile"]:
            change = f"profile {profile}" if profile else "no profile"
            yield Reading("profile", change, "no verdict"), {"profile": profile}
    named = dict(header["readings"])
    defaults = dict(others.defaults)
    for ambiguity, letters in others.letters:
        own = named.get(ambiguity, None if header["profile"] else defaults.get(ambiguity))
        for letter in letters:
            if letter != own:
                readings = [*([a, x] for a, x in header["readings"] if a != ambiguity), [ambiguity, letter]]
                yield Reading("letter", f"{ambiguity} {letter}", "no verdict"), {"readings": readings}


def _bytes_of(name: str) -> bytes:
    data = b""
    try:
        if not Path(name).is_file():
            raise TooLongError
        with open_log(name) as source:
            for chunk in source.chunks():
                data += chunk
                if len(data) > LONGEST:
                    raise TooLongError
    except (OSError, ValueError) as error:
        raise TooLongError from error
    except UnusableLogError:
        pass  # a damaged end was reported already
    return data
