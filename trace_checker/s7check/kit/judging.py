"""The verdict about the log of a program: passed, failed, or passed under another reading."""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import replace
from typing import Any, cast

import msgspec

from s7check.api import check
from s7check.engine import pool
from s7check.engine.command import EngineError
from s7check.judging.replay import Replay, TooLongError, with_readings
from s7check.kit.adapter import Ran
from s7check.kit.followed import departure
from s7check.kit.program import Program
from s7check.kit.results import UNDER_ANOTHER, Result, result_of
from s7check.kit.whole import Whole, whole
from s7check.log.chosen import Chosen
from s7check.log.objects import decoded
from s7check.reducing.candidate import as_text
from s7check.reducing.reduction import reduce_log
from s7check.report.report import Reading, Report

_TRYING = 60.0
"""Seconds for other readings of a log, at most; a log of 15,000 lines takes 5."""

_REDUCING = 10.0
"""Seconds for the reduction of a log, at most."""


class LogJudge:
    """Judges logs of programs by the edition ``profile`` and the readings ``letters``, as in ``check``.

    With ``diag`` each log has to have the entries of the diagnostic buffer.
    """

    def __init__(self, profile: str | None, letters: Mapping[str, str] | None, diag: bool = False) -> None:
        self._diag = diag
        self.profile = profile
        self.letters = dict(letters or {})

    def result(self, program: Program, ran: Ran, seconds: float) -> tuple[Result, Report, Whole]:
        """The result of a log, without its ``digest``, the verdict, and the log with its end."""
        with pool.engine() as engine:
            log = whole(engine, program, ran)
        report = check(log.lines, profile=self.profile, letters=self.letters, decided=True, name=program.name)
        result = result_of(report, program.name, program.requirements, seconds)
        if report.verdict == "rejected":
            under = tuple(one.change for one in self._accepted(report, log) if not self._departure(program, log, one))
            status = UNDER_ANOTHER if under else result.status
            result = msgspec.structs.replace(result, status=status, passes_under=under)
        if result.status == "passed" and (reason := self._departure(program, log)):
            reason = f"not the log of this program: {reason}"
            result = msgspec.structs.replace(result, status="failed", reason=reason, decided=())
        return result, report, log

    def _accepted(self, report: Report, log: Whole) -> list[Reading]:
        """The readings and editions under which the log is accepted."""
        with pool.engine() as engine, suppress(EngineError, TooLongError):
            replay = Replay("-", log.lines, Chosen(self.profile, self.letters))
            tried = with_readings(report, engine, replay, time.monotonic() + _TRYING).readings or ()
            return [one for one in tried if one.verdict == "accepted" and one.kind != "cpu"]
        return []

    def _departure(self, program: Program, log: Whole, reading: Reading | None = None) -> str:
        header, *events = [line for line in log.lines if line.strip()]
        assert log.content.header is not None
        if self._diag and "diag" not in log.content.header["records"]:
            return 'line 1: field "records": expected diag, as the offer has it'
        lines = (msgspec.json.encode(self._header(decoded(header), reading)), *events)
        with pool.engine() as engine:
            return departure(engine, program, replace(log, lines=lines))

    def _header(self, header: dict[str, Any], reading: Reading | None = None) -> dict[str, Any]:
        """The header with what was chosen, and with another reading."""
        profile, letters = self.profile, self.letters
        if reading is not None and reading.kind == "profile":
            profile = "" if reading.change == "no profile" else reading.change.removeprefix("profile ")
        elif reading is not None:
            name, letter = reading.change.split()
            letters = letters | {name: letter}
        if profile is not None:
            header = {name: value for name, value in header.items() if name != "profile"}
            header |= {"profile": profile} if profile else {}
        return header | ({"readings": header.get("readings", {}) | letters} if letters else {})

    def reduced(self, report: Report) -> str:
        """The smallest log that is rejected alike; empty if the engine fails."""
        header, *events = cast("list[dict[str, Any]]", [decoded(line) for line in report.lines if line.strip()])
        with pool.engine() as engine, suppress(EngineError):
            lines = [self._header(header), *events]
            reduction = reduce_log(lines, report, engine, time.monotonic() + _REDUCING)
            return as_text(reduction.header, reduction.events).decode()
        return ""


def first_few(results: Iterable[Result], most: int) -> list[Result]:
    """The first results, ``most`` for each requirement, of logs that were rejected for it."""
    found: list[Result] = []
    seen: dict[str, int] = {}
    for result in results:
        if result.deciding:
            seen[result.deciding[0]] = seen.get(result.deciding[0], 0) + 1
            if seen[result.deciding[0]] <= most:
                found.append(result)
    return found
