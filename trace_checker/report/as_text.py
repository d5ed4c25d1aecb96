"""A few lines a log, for a terminal or a file."""

import click

from trace_checker.log.errors import printable
from trace_checker.verdict import Report

_COLOURS = {"accepted": "green", "rejected": "red", "unusable": "yellow", "no verdict": "magenta"}
_LONGEST_LINE = 400
_MOST_EXPECTED = 12


def to_text(report: Report) -> str:
    """The report as text with colours, which the output drops where there is no terminal."""
    place = printable(report.log, _LONGEST_LINE)
    if report.line is not None:
        place += f":{report.line}"
    verdict = click.style(report.verdict, fg=_COLOURS[report.verdict], bold=True)
    lines = [f"{place}: {verdict}: {report.message}{_count(report)}"]
    if report.event is not None:
        source = report.event.decode(errors="replace").strip()
        lines.append(f"    {printable(source, _LONGEST_LINE)}")
    if report.expected:
        shown = report.expected[:_MOST_EXPECTED]
        more = len(report.expected) - len(shown)
        lines.append(f"  expected: {', '.join(shown)}{f' and {more} more' if more else ''}")
    if report.requirements:
        lines.append(f"  requirements: {', '.join(report.requirements)}")
    return "\n".join(lines)


def _count(report: Report) -> str:
    return f" ({report.events} events)" if report.verdict == "accepted" else ""
