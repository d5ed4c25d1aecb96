"""A few lines a log, for a terminal or a file."""

import click

from s7check.judging.verdict import Report
from s7check.report.lines import message, parts, place, source

COLOURS = {"accepted": "green", "rejected": "red", "unusable": "yellow", "no verdict": "magenta"}


def to_text(report: Report) -> str:
    """The report as text with colours, which the output drops where there is no terminal."""
    verdict = click.style(report.verdict, fg=COLOURS[report.verdict], bold=True)
    lines = [f"{place(report)}: {verdict}: {message(report)}"]
    if report.event is not None:
        lines.append(f"    {source(report.event)}")
    for part in parts(report):
        if len(part.lines) == 1 and part.heading:
            lines.append(f"  {click.style(part.heading, bold=True)}: {part.lines[0]}")
            continue
        if part.heading:
            lines.append(f"  {click.style(part.heading, bold=True)}:")
        lines += [f"    {line}" for line in part.lines]
    return "\n".join(lines)
