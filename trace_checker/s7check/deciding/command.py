"""``s7check decide``."""

from __future__ import annotations

from pathlib import Path

import click
import msgspec

from s7check.completion import complete_files
from s7check.deciding.letters_left import ContradictionError, Letters
from s7check.engine.client import Engine
from s7check.judging.replay import Replay, TooLongError
from s7check.names import logs_of
from s7check.output import echo, write_whole
from s7check.report.report import clause_text

_HELP = """Say which readings of the open questions logs leave.

For every question that the manuals leave open (docs/rules/readings.md), the letters under which all the logs can be
explained, one question changed at a time. Where the defaults do not explain a log, letters are taken that do.

\b
  s7check decide --output cpu.json experiments/*.ndjson
  s7check trace --set @cpu.json run.ndjson
Exit codes: 0 told, 1 no reading explains all logs, 2 a log cannot be used, 3 no verdict about a log.
"""


@click.command("decide", help=_HELP, short_help="Say which readings of the open questions logs leave.")
@click.option(
    "--output",
    "file",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Write the letters that are decided to FILE, a JSON object for --set @FILE or the header's readings.",
)
@click.argument("logs", nargs=-1, required=True, metavar="LOG...", shell_complete=complete_files)
def decide_command(file: Path | None, logs: tuple[str, ...]) -> int:
    """Decide and print."""
    replays: dict[str, Replay] = {}
    for name in logs_of(logs):
        if not Path(name).is_file():
            raise click.ClickException(f"{click.format_filename(name)}: expected a file of logs; found none")
        try:
            replays[name] = Replay(name, [])
        except TooLongError as error:
            raise click.ClickException(f"{click.format_filename(name)}: expected a log of at most 4 MiB") from error
    try:
        with Engine() as engine:
            for name, replay in replays.items():
                if not replay.others(engine):
                    raise click.ClickException(
                        f"{click.format_filename(name)}: expected a log (`s7check trace` says more)"
                    )
            letters = Letters(engine, replays)
    except ContradictionError as error:
        echo(f"no reading explains: {', '.join(map(str, error.args[0]))}")
        return 1
    echo("\n".join(_lines(letters)))
    if file is not None:
        write_whole(file, msgspec.json.encode(letters.decided) + b"\n")
    return 0


def _lines(letters: Letters) -> list[str]:
    open_ones = len(letters.left) - len(letters.decided) - len(letters.narrowed)
    return [
        *(f"{name} is {letter}: {clause_text(name)}" for name, letter in letters.decided.items()),
        *(f"{name} is one of {', '.join(left)}: {clause_text(name)}" for name, left in letters.narrowed.items()),
        f"{len(letters.decided)} decided, {len(letters.narrowed)} narrowed, {open_ones} as open as before",
    ]
