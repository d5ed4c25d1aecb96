"""``s7check next``."""

from collections.abc import Mapping

import click
import msgspec

from s7check.asking.log_prefix import Prefix, read_prefix
from s7check.asking.next_answer import what_is_next
from s7check.asking.next_json import to_json
from s7check.asking.next_text import to_text
from s7check.asking.variants import variant_options, variants
from s7check.asking.why_not import why_not
from s7check.completion import complete_files
from s7check.engine import pool
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.log.errors import UnusableLogError
from s7check.log.objects import decoded
from s7check.output import echo
from s7check.report.as_json import to_json as report_to_json
from s7check.report.as_text import TextReports
from s7check.report.report import EXIT_CODES

_HELP = """Say what may come after a log.

LOG is a log of `s7check trace`; LOG:7 is the log up to its line 7. The answer has the situation of the CPU after
that line, what has to come and by when, and each event that may come: its values, the times between which it may come,
the requirements. --cpu, --profile and --reading add columns: what another CPU, edition or reading changes.

\b
With --why EVENT, an event as a JSON object: why it may not come.
  s7check next run.ndjson:7 --why '{"event": "start", "ob": 10}'
Exit codes: 0 the event may come, 1 it may not; 2 the log cannot be used, 3 the question could not be answered.
"""


@click.command("next", help=_HELP, short_help="Say what may come after a log, and why something may not.")
@click.option(
    "--format", "output", type=click.Choice(["text", "json"]), default="text", show_default=True, help="Form."
)
@click.option("--why", "event", metavar="EVENT", help="Why this line, a JSON object, is not possible next.")
@variant_options
@click.argument("log", metavar="LOG[:LINE]", shell_complete=complete_files)
def next_command(
    output: str,
    event: str | None,
    cpus: tuple[str, ...],
    profiles: tuple[str, ...],
    readings: tuple[Mapping[str, str], ...],
    log: str,
) -> int:
    """Answer and report."""
    try:
        with pool.engine() as engine:
            prefix = read_prefix(engine, log)
            if event is not None:
                return _why(engine, prefix, event, output)
            answer = what_is_next(engine, prefix, variants(cpus, profiles, readings))
            echo(to_text(answer) if output == "text" else to_json(answer))
            return 0
    except UnusableLogError as error:
        where = f"{log.rpartition(':')[0] if error.line and ':' in log else log}" + (
            f":{error.line}" if error.line else ""
        )
        click.echo(f"{click.format_filename(where)}: unusable: {error.reason}", err=True)
        return EXIT_CODES["unusable"]
    except EngineError as error:
        click.echo(f"{click.format_filename(log)}: no verdict: {error}", err=True)
        return EXIT_CODES["no verdict"]


def _why(engine: Engine, prefix: Prefix, text: str, output: str) -> int:
    try:
        event = decoded(text.encode())
    except UnusableLogError as error:
        raise click.UsageError(f"--why: {error.reason}") from error
    try:
        last, line, report = why_not(engine, prefix, event)
    except UnusableLogError as error:
        raise click.UsageError(f"--why: {error.reason}") from error
    if report is None:
        said = {"log": prefix.name, "line": last, "event": line, "possible": True}
        echo(f"{prefix.name}:{last}: this may come next" if output == "text" else msgspec.json.encode(said).decode())
        return 0
    echo(TextReports().add(report) if output == "text" else report_to_json(report).decode())
    return EXIT_CODES["rejected"]
