"""``s7check coverage``."""

from pathlib import Path

import click

from s7check.completion import complete_files
from s7check.coverage import report
from s7check.coverage.measure import Coverage, Guard, measure, together
from s7check.engine import pool
from s7check.judging.decisions import decisions_of
from s7check.kit.collection import UnreadableProgramError, programs_of
from s7check.kit.program import Program
from s7check.log.calls import WITHOUT_NUMBER
from s7check.names import logs_of
from s7check.output import deliver, output_option
from s7check.report.progress import ProgressBar
from s7check.report.report import EXIT_CODES

_HELP = """Tell which rules logs exercise, and which they do not.

LOG is as for `s7check trace`: files, folders, patterns. For each requirement that decided nothing the report names the
programs of the kit that are about it. Of a log that is not accepted the lines before its verdict count.

Exit codes: 0 all logs accepted, 1 to 3 as `s7check trace` has them.
"""


@click.command("coverage", help=_HELP, short_help="Which rules do logs exercise?")
@click.option(
    "--format",
    "output",
    type=click.Choice(["text", "json", "html"]),
    default="text",
    show_default=True,
    help="text for people; json, one object; html, a page.",
)
@output_option
@click.option("--guards", is_flag=True, help="text: also each condition of the rules that never had an outcome.")
@click.option(
    "--programs",
    multiple=True,
    type=click.Path(exists=True, path_type=Path),
    help="Name programs of this file or folder in place of the kit's. May be given several times.",
    metavar="FILE",
)
@click.argument("logs", nargs=-1, required=True, metavar="LOG...", shell_complete=complete_files)
def coverage_command(
    output: str, file: Path | None, guards: bool, programs: tuple[Path, ...], logs: tuple[str, ...]
) -> int:
    """Measure and report."""
    if "" in logs:
        raise click.UsageError("LOG: expected the name of a file or folder, a pattern or -; found an empty text")
    names = logs_of(logs)
    try:
        total = _total(names, programs_of(programs))
    except UnreadableProgramError as error:
        raise click.ClickException(str(error)) from error
    for name, verdict in zip(names, total.coverage.verdicts, strict=True):
        if verdict != "accepted":
            click.echo(f"{click.format_filename(name)}: {verdict} (`s7check trace` says why)", err=True)
    if output == "text":
        written = report.to_text(total, guards).encode() + b"\n"
    else:
        written = report.to_json(total) if output == "json" else report.to_html(total)
    deliver(written, file)
    return max(EXIT_CODES[verdict] for verdict in total.coverage.verdicts)


def _total(names: list[str], programs: list[Program]) -> report.Total:
    found: list[Coverage] = []
    with pool.engine() as engine, ProgressBar(len(names)) as progress:
        decisions = decisions_of(engine)
        choices = engine.alternatives()
        for name in names:
            progress.begin(click.format_filename(name))
            found.append(measure(name, engine))
            progress.done()
    outcomes = [Guard.of(one, outcome) for one in decisions.guards.values() for outcome in (True, False)]
    answers = frozenset(
        (call, ret & 0xFFFF) for call, rets in choices.answers if call != WITHOUT_NUMBER for ret in rets
    )
    return report.Total(
        together(found), decisions.requirements, outcomes, answers, frozenset(choices.periods), programs
    )
