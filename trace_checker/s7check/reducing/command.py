"""``s7check reduce``."""

import time
from collections.abc import Iterator, Sequence
from pathlib import Path

import click

from s7check.asking.onward import rejections
from s7check.completion import complete_files
from s7check.engine.client import Engine
from s7check.judging.check import check_log
from s7check.log.chosen import NOTHING
from s7check.log.errors import UnusableLogError
from s7check.log.objects import decoded, objects
from s7check.output import echo, write_whole
from s7check.reducing.candidate import Fields, as_text
from s7check.reducing.reduction import Reduction, reduce_log
from s7check.report.report import EXIT_CODES, Report, message, place

_NOT_REJECTED = 1
_BUDGET = 30.0

_HELP = """Write the smallest log that is rejected for the same reason as LOG.

Lines are left out, then fields of the header, OBs and fields of events, and times are made round, as long as the log is
rejected at its last line by the requirement that is named first for LOG.

Exit codes: 0 the log is written, 1 LOG is accepted, 2 LOG or an option cannot be used, or the log cannot be written, 3
no verdict.
"""


@click.command("reduce", help=_HELP, short_help="The smallest log that is rejected alike.")
@click.option(
    "-o",
    "--output",
    "file",
    type=click.Path(dir_okay=False, path_type=Path),
    help="Write the log to FILE, whole or not at all, and not to standard output.",
    metavar="FILE",
)
@click.option(
    "--budget",
    type=click.FloatRange(min=0),
    default=_BUDGET,
    show_default=True,
    help="Seconds to try smaller logs for a rejection once LOG is judged; then the smallest is written.",
    metavar="SECONDS",
)
@click.option(
    "--keep-going",
    is_flag=True,
    help="Also a log for each rejection behind the first: for --output FILE.ndjson, FILE-2.ndjson and so on.",
)
@click.argument("log", metavar="LOG", shell_complete=complete_files)
def reduce_command(file: Path | None, budget: float, keep_going: bool, log: str) -> int:
    """Reduce and write."""
    if keep_going and (file is None or log == "-"):
        raise click.UsageError("--keep-going: expected --output FILE, and a log that can be read again")
    with Engine() as engine:
        report = check_log(log, engine, lambda _, __: None)
        if report.verdict != "rejected":
            click.echo(f"{place(report)}: {report.verdict}: {message(report)}", err=True)
            return _NOT_REJECTED if report.verdict == "accepted" else EXIT_CODES[report.verdict]
        _write(file, report, reduce_log(_lines(log, report), report, engine, time.monotonic() + budget))
        if file is not None and keep_going:
            for number, (behind, lines) in enumerate(_behind(log, report), 2):
                reduction = reduce_log(lines, behind, engine, time.monotonic() + budget)
                _write(file.with_stem(f"{file.stem}-{number}"), behind, reduction)
    return 0


def _behind(log: str, report: Report) -> Iterator[tuple[Report, Sequence[Fields]]]:
    """The rejections behind the first one, each with the log as it was judged up to there."""
    with Engine() as engine:  # the other engine ends where a smaller log takes too long
        for one in rejections(log, report, engine, NOTHING):
            yield one.report, [one.header, *one.lines]


def _write(file: Path | None, report: Report, reduction: Reduction) -> None:
    """Writes the log, and says how many lines are left of those up to the rejected one."""
    text = as_text(reduction.header, reduction.events)
    if file is None:
        echo(text)
    else:
        try:
            write_whole(file, text)
        except OSError as error:
            raise click.FileError(str(file), hint=error.strerror or str(error)) from error
    more = "" if reduction.done else "; not everything was tried (see --budget)"
    lines = len(reduction.events) + 1
    said = f"{lines} of {report.line} lines, {', '.join(report.requirements)}"
    click.echo(f"{place(report)}: {said}{more}", err=True)


def _lines(log: str, report: Report) -> list[Fields]:
    """The header and the events up to the rejected line."""
    fields: list[Fields] = []
    if log == "-":
        fields = [decoded(text) for text in report.lines if text.strip()]
    else:
        fields = [line for number, _, line in objects(log) if number <= (report.line or 0)]
    if not fields:
        raise UnusableLogError("a stream of at most 16 MiB", "a longer one")
    return fields
