"""``s7check distinguish``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import click
import msgspec

from s7check.asking.variants import variant_options, variants
from s7check.engine import pool
from s7check.engine.client import Engine
from s7check.kit.collection import UnreadableProgramError, programs_of
from s7check.kit.layout import to_text
from s7check.kit.program import Program
from s7check.output import echo
from s7check.simulating.kept import known
from s7check.simulating.search import distinguished
from s7check.simulating.separation import Separation
from s7check.simulating.shortest import PAIRS, Bound, anywhere, searched, shortened
from s7check.simulating.two_sides import difference_text, log_of_refused

_HELP = """Find the shortest program that tells two CPUs, editions or readings apart.

It begins with a log that is known to do so, or else with the programs of the kit: one side makes the log, the other is
asked whether it allows it. The first that tells them apart is made smaller while it still does. Then all shorter logs
are searched, breadth first: those of one event, of two, and so on, of the lines that the specification offers. The
answer says how far that went.

\b
  s7check distinguish --cpu S7-300 --cpu S7-400
  s7check distinguish --reading AMB-12=a --reading AMB-12=b
Exit codes: 0 found, 1 none of the programs tried tells them apart, 2 wrong arguments, 3 the search failed.
"""


@click.command("distinguish", help=_HELP, short_help="Find the shortest program that tells CPUs or readings apart.")
@click.option(
    "--programs",
    "files",
    multiple=True,
    type=click.Path(exists=True, path_type=Path),
    metavar="FILE",
    help="Begin with the programs of this file or folder, not with what is known. May be given several times.",
)
@click.option(
    "--budget",
    type=click.FloatRange(min=0),
    default=120.0,
    show_default=True,
    metavar="SECONDS",
    help="Seconds for the programs of the kit; the other parts take more.",
)
@click.option(
    "--pairs",
    type=click.IntRange(1),
    default=PAIRS,
    show_default=True,
    metavar="N",
    help="Different situations that are kept in a search for shorter logs; 1000 are about a second.",
)
@click.option(
    "--format", "output", type=click.Choice(["text", "json"]), default="text", show_default=True, help="Form."
)
@variant_options
def distinguish_command(
    files: tuple[Path, ...],
    budget: float,
    pairs: int,
    output: str,
    cpus: tuple[str, ...],
    profiles: tuple[str, ...],
    readings: tuple[Mapping[str, str], ...],
) -> int:
    """Search and print."""
    sides = variants(cpus, profiles, readings)
    if len(sides) != 2:
        raise click.UsageError(f"expected two of --cpu, --profile and --reading; found {len(sides)}")
    try:
        with pool.engine() as engine:
            programs = _of_interest(programs_of(files), sides[0].letters, sides[1].letters)
            begun = None if files else next((one.again(engine) for one in known(sides[0], sides[1])), None)
            begun = begun or distinguished(engine, programs, sides[0], sides[1], budget)
            if begun is None:
                found, bounds = anywhere(engine, sides[0], sides[1], pairs)
            else:
                found, bounds = shortened(engine, begun, pairs)
            if found is None:
                echo(f"nothing found that tells {sides[0].name} and {sides[1].name} apart")
                echo("\n".join(f"  {bound.text()}" for bound in bounds))
                return 1
            echo(_json(found, bounds) if output == "json" else _text(engine, found, bounds))
    except UnreadableProgramError as error:
        raise click.ClickException(str(error)) from error
    return 0


def _of_interest(programs: list[Program], *letters: tuple[tuple[str, str], ...]) -> list[Program]:
    """For letters: the programs about their ambiguities, if there are any."""
    named = {name for pairs in letters for name, _ in pairs}
    return [one for one in programs if named & set(one.requirements)] or programs


def _text(engine: Engine, found: Separation, bounds: Sequence[Bound]) -> str:
    said = [f"  {text}" for text in searched(len(found.log) - 1, bounds)]
    told = difference_text(found, found.log, log_of_refused(engine, found))
    return "\n".join([to_text(found.program.raw).rstrip("\n"), *told, "searched for a shorter log:", *said])


def _json(found: Separation, bounds: Sequence[Bound]) -> str:
    return msgspec.json.encode(
        {
            "program": found.program.raw,
            "allowed": found.allowed.name,
            "refused": found.refused.name,
            "log": found.log,
            "line": found.line,
            "grounds": found.grounds,
            "requirements": found.refusal.requirements,
            "searched": bounds,
        }
    ).decode()
