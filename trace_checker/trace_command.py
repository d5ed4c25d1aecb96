"""``s7check trace``."""

import os
import sys

import click

from trace_checker.check import check_log
from trace_checker.engine_client import Engine
from trace_checker.report.as_json import to_json
from trace_checker.report.as_text import to_text
from trace_checker.report.progress import ProgressLine
from trace_checker.verdict import Report


@click.command("trace", short_help="Check logs of a CPU against the specification.")
@click.option(
    "--format",
    "output",
    type=click.Choice(["text", "json"]),
    default="text",
    show_default=True,
    help="text for people; json prints one object a log.",
)
@click.argument("logs", nargs=-1, required=True, metavar="LOG...")
def trace_command(output: str, logs: tuple[str, ...]) -> int:
    r"""Check whether recorded runs of a CPU keep to the rules of the S7-300/400.

    A LOG is a file of the format s7-interrupt-log/1: what the CPU did, one JSON object a line, the
    SFC calls with their RET_VAL, OBs starting and ending, the clock being set. A file whose name
    ends in .gz is unpacked; - reads standard input while it is being written.

    \b
    Verdicts, and the exit code that each stands for:
      accepted    0  an S7-300/400 may behave like this
      rejected    1  it may not: the line, what it may do instead, the rule
      unusable    2  the log is not of the format: the line and the field
      no verdict  3  the check could not be done, no Java for instance

    Over several logs the exit code is the highest of theirs.
    """
    code = 0
    with Engine() as engine:
        for name in logs:
            with ProgressLine(click.format_filename(name)) as progress:
                report = check_log(name, engine, progress.update)
            _print(report, output)
            code = max(code, report.exit_code)
    return code


def _print(report: Report, output: str) -> None:
    try:
        if output == "json":
            click.echo(to_json(report))
        else:
            click.echo(to_text(report), color=False if "NO_COLOR" in os.environ else None)
    except BrokenPipeError:
        # Whoever read the output has seen enough; the exit code still counts.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
