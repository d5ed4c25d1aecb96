"""``s7check compare``."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import click

from s7check.asking.log_prefix import read_prefix
from s7check.asking.session import Session
from s7check.asking.variants import Variant, variant_options, variants
from s7check.completion import complete_files
from s7check.ending import ending
from s7check.engine import pool
from s7check.engine.client import Engine
from s7check.kit.program import FORMAT
from s7check.output import echo
from s7check.report.report import clause_text
from s7check.simulating.separation import log_of, separation
from s7check.simulating.simulate_command import the_program
from s7check.simulating.two_sides import difference_text

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
            return _programs(engine, Path(file), only, sides[0], sides[1])
        if not sides:
            raise click.UsageError("expected --cpu, --profile or --reading; found none of them")
        return _log(engine, file, sides)


def _is_program(file: Path) -> bool:
    try:
        with file.open("rb") as content:
            return FORMAT.encode() in content.read(4096)
    except OSError:
        return False


def _programs(engine: Engine, file: Path, only: str | None, first: Variant, second: Variant) -> int:
    program = the_program(file, only)
    logs = {side: log_of(engine, program, side) for side in (first, second)}
    for allowed, refused in ((first, second), (second, first)):
        found = separation(engine, program, logs[allowed], allowed, refused)
        if found is not None:
            echo("\n".join(difference_text(found, logs[allowed], logs[refused])))
            return 1
    echo(f"no difference: each allows the log of the other ({len(logs[first]) - 1} events)")
    return 0


def _log(engine: Engine, file: str, sides: list[Variant]) -> int:
    prefix = read_prefix(engine, file)
    ends: set[int | None] = set()
    named: set[str] = set()
    for side in sides:
        session = Session(engine, side.of(prefix.header))
        line, requirements = None, []
        for number, event in prefix.events:
            refusal = session.feed(event)
            if refusal is not None:
                line, requirements = number, refusal.requirements
                break
        ends.add(line)
        named.update(requirements)
        said = "allows it" if line is None else f"line {line} is not possible: {', '.join(requirements)}"
        echo(f"{side.name}: {said}")
    for name in sorted(named):
        echo(f"  {clause_text(name)}")
    return 1 if len(ends) > 1 else 0
