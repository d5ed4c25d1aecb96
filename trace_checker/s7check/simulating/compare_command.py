"""``s7check compare``."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import click

from s7check.asking.log_prefix import read_prefix
from s7check.asking.variants import variant_options, variants
from s7check.completion import complete_files
from s7check.ending import ending
from s7check.engine import pool
from s7check.kit.program import FORMAT
from s7check.output import echo
from s7check.simulating.comparison import compare_log, compare_program
from s7check.simulating.simulate_command import the_program

_HELP = """Compare two CPUs, editions or readings on a program or a log.

Of a program of the kit both sides make a log; the answer is the first line of one that the other does not allow, with
the clauses of both sides. Of a log: which sides allow it, and otherwise the line and the clause.

\b
  s7check compare program.json --cpu S7-300 --cpu S7-400
  s7check compare run.ndjson --reading AMB-12=a --reading AMB-12=b
Exit codes: 0 no difference, 1 a difference, 2 wrong arguments, 3 the specification could not be evaluated.
"""


@click.command("compare", help=_HELP, short_help="Compare two CPUs, editions or readings on a program or a log.")
@click.option("--only", metavar="NAME", help="The program with this name, where the file has several.")
@variant_options
@click.argument("file", metavar="PROGRAM|LOG", shell_complete=complete_files)
def compare_command(
    only: str | None,
    cpus: tuple[str, ...],
    profiles: tuple[str, ...],
    readings: tuple[Mapping[str, str], ...],
    file: str,
) -> int:
    """Compare and print."""
    sides = variants(cpus, profiles, readings)
    with ending(file), pool.engine() as engine:
        if _is_program(Path(file)):
            if len(sides) != 2:
                raise click.UsageError(f"expected two of --cpu, --profile and --reading; found {len(sides)}")
            differ, lines = compare_program(engine, the_program(Path(file), only), sides[0], sides[1])
        elif not sides:
            raise click.UsageError("expected --cpu, --profile or --reading; found none of them")
        else:
            differ, lines = compare_log(engine, read_prefix(engine, file), sides)
    echo("\n".join(lines))
    return int(differ)


def _is_program(file: Path) -> bool:
    try:
        with file.open("rb") as content:
            return FORMAT.encode() in content.read(4096)
    except OSError:
        return False
