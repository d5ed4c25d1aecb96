"""A few lines a log, for a terminal or a file."""

from collections import Counter
from functools import partial

import click

from s7check.engine.answer import Part
from s7check.report.report import EXIT_CODES, Cause, Report, cause, in_text, parts, place

COLOURS = {"accepted": "green", "rejected": "red", "unusable": "yellow", "no verdict": "magenta"}


class TextReports:
    """The reports of a call, one after the other, as text with colours, which the output drops where there is no
    terminal.
    """

    def __init__(self) -> None:
        self._explained: dict[Cause, str] = {}
        self._verdicts: Counter[str] = Counter()
        self._deciding: Counter[str] = Counter()

    def add(self, report: Report) -> str:
        """The report; a cause that an earlier one has explained is named by that one's place."""
        self._verdicts[report.verdict] += not report.after
        self._deciding.update(report.requirements)
        return in_text(report, self._parts(report), _coloured(report.verdict), partial(click.style, bold=True))

    def _parts(self, report: Report) -> list[Part]:
        if report.verdict != "rejected":
            return list(parts(report))
        first = self._explained.setdefault(cause(report), place(report))
        if first == place(report):
            return list(parts(report))
        return [*report.refusal.decision, Part("the same cause as", [first]), *report.compared]

    def sum(self) -> str:
        """How many logs got which verdict, and how often each requirement decided; empty for a single log."""
        logs = self._verdicts.total()
        if logs < 2:
            return ""
        verdicts = ", ".join(f"{self._verdicts[name]} {_coloured(name)}" for name in EXIT_CODES if self._verdicts[name])
        lines = [f"{logs} logs: {verdicts}"]
        if self._deciding:
            often = sorted(self._deciding.items(), key=lambda pair: (-pair[1], pair[0]))
            lines.append("  rejected by: " + ", ".join(f"{name} ({count})" for name, count in often))
        return "\n".join(lines)


def _coloured(verdict: str) -> str:
    return click.style(verdict, fg=COLOURS[verdict], bold=True)
