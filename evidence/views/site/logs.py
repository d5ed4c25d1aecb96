"""Logs as timelines, each with the address under which the explorer opens it."""

from __future__ import annotations

import base64
import html
import json
import tempfile
import zlib
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from evidence.common.cases import CasesError
from s7check.judging.check import check_log
from s7check.judging.replay import FOLLOWED, Replay, with_steps
from s7check.report.markup import as_text
from s7check.report.report import Report
from s7check.report.timeline import timeline

if TYPE_CHECKING:
    from evidence.common.cases import Case
    from s7check.engine.client import Engine

EXPLORER = "explorer.html"
"""The page of `make page`, if it was built."""


class Logs:
    """The timelines of cases of traces/, drawn once."""

    def __init__(self, cases: Sequence[Case], engine: Engine) -> None:
        self._cases = {case.id: case for case in cases}
        self._engine = engine
        self.shown = cache(self._shown)

    def named(self, name: str) -> Case | None:
        """The case with a name, without its area, if there is one."""
        return next((case for case in self._cases.values() if case.name == name), None)

    def plainest(self, names: Sequence[str]) -> str:
        """The first of some cases whose log has all kinds and the default reading; the first if none has."""
        plain = (name for name in names if not self._cases[name].header.keys() & {"readings", "profile", "records"})
        return next(plain, names[0])

    @staticmethod
    def opened(case: Case) -> str:
        """The explorer's address of a case, open at its rejected line, or else behind its end."""
        lines = [line for line in case.lines if line.strip()]
        return address(case.name, lines, len(lines) - 1 if case.line is None else max(0, case.line - 2))

    def _shown(self, name: str) -> tuple[Case, str]:
        """A case and its timeline. Raises `CasesError` if the verdict is not that of the case."""
        case = self._cases[name]
        with tempfile.TemporaryDirectory() as folder:
            report = drawable(case.put(Path(folder)), self._engine)
        if report.verdict != case.verdict:
            raise CasesError(f"{name}: expected {case.verdict}, the log is {report.verdict}")
        return case, picture(report)


def drawable(log: Path, engine: Engine) -> Report:
    """The verdict about a log with the situations after its lines."""
    replay = Replay(str(log), [])
    answer = replay.judge(engine, follow=FOLLOWED)
    if answer.verdict == "accepted":
        return Report(str(log), "accepted", "", lines=replay.lines, steps=answer.steps)
    return with_steps(check_log(str(log), engine, lambda *_: None), engine, replay)


def picture(report: Report) -> str:
    """The timeline of a log as HTML; nothing for a log without situations."""
    drawn = timeline(report)
    if drawn is None:
        return ""
    label = html.escape(f"timeline of lines {drawn.first} to {drawn.last}")
    parts = as_text(drawn.labels) + as_text(drawn.lanes)
    return f'<div class="scroll" role="region" tabindex="0" aria-label="{label}">{parts}</div>'


def address(name: str, lines: Sequence[bytes], shown: int, sides: Sequence[str] = ()) -> str:
    """The explorer's address of a log, open behind `shown` lines of it, with these CPUs beside it.

    It is what toLink of page/model.js makes.
    """
    header, *others = (line.decode() for line in lines if line.strip())
    branch = {"name": name, "header": header, "lines": others, "shown": shown}
    beside = [{"name": f"cpu {cpu}", "chosen": {"cpu": cpu}} for cpu in sides]
    document = {"branches": [branch], "current": 0, "sides": beside}
    deflate = zlib.compressobj(9, wbits=-15)
    packed = deflate.compress(json.dumps(document).encode()) + deflate.flush()
    return f"{EXPLORER}#{base64.urlsafe_b64encode(packed).decode().rstrip('=')}"
