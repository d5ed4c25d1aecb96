"""``s7check simulate``."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import click
import msgspec

from s7check.asking.variants import Variant
from s7check.completion import complete_files
from s7check.ending import ending
from s7check.engine import pool
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.kit.collection import UnreadableProgramError, programs_of
from s7check.kit.program import Program, read_program
from s7check.letters import EDITION, OneOf, set_option
from s7check.log.errors import UnusableLogError
from s7check.output import echo
from s7check.simulating.simulation import LATENCY, outcomes, simulated

_HELP = """Run a program of the kit on the specification.

PROGRAM is a file of programs (docs/checking/kit.md), or -. The answer is the log of one behaviour, in which all
comes as early as it may, or with --seed at random. With - it is an adapter of the kit: each line is a program,
and {"event": "done"} stands behind each log.

\b
Exit codes: 0 done, 2 the program cannot be used, 3 the specification could not be evaluated.
"""


@click.command("simulate", help=_HELP, short_help="Run a program of the kit on the specification.")
@click.option("--only", metavar="NAME", help="The program with this name, where the file has several.")
@click.option("--seed", type=click.IntRange(0, 2**63 - 1), help="Choose at random; the same number chooses alike.")
@click.option(
    "--latency",
    type=click.IntRange(0, 60_000),
    default=LATENCY,
    show_default=True,
    help="Latency of the log; with --seed OBs start up to so many milliseconds late.",
    metavar="MS",
)
@click.option("--all", "whole", is_flag=True, help="Every outcome, as a tree.")
@click.option(
    "--format", "output", type=click.Choice(["text", "json"]), default="text", show_default=True, help="Form of --all."
)
@click.option("--cpu", type=OneOf("families"), metavar="FAMILY", help="Run it on this CPU.")
@click.option("--profile", type=EDITION, metavar="EDITION", help="By this edition of the manual.")
@set_option("By this reading of an open question (docs/rules/readings.md). May be given several times.")
@click.argument("program", metavar="PROGRAM", shell_complete=complete_files)
def simulate_command(
    only: str | None,
    seed: int | None,
    latency: int,
    whole: bool,
    output: str,
    cpu: str | None,
    profile: str | None,
    letters: dict[str, str],
    program: str,
) -> int:
    """Simulate and print."""
    if whole and seed is not None:
        raise click.UsageError("--all and --seed: expected one of them")
    variant = Variant("", cpu, profile, tuple(letters.items()))
    if program == "-":
        return _adapter(lambda engine, one: simulated(engine, one, variant, latency, seed))
    with ending(program), pool.engine() as engine:
        one = the_program(Path(program), only)
        if whole:
            _tree(outcomes(engine, one, variant, latency), output)
        else:
            echo("\n".join(_line(line) for line in simulated(engine, one, variant, latency, seed)))
    return 0


def the_program(file: Path, only: str | None) -> Program:
    """The program of a file, the one with that name if there are several. Raises UnusableLogError."""
    try:
        programs = programs_of([file])
    except UnreadableProgramError as error:
        raise click.ClickException(str(error)) from error
    found = [program for program in programs if only in (None, program.name)]
    if len(found) != 1:
        names = "one program" if only is None else f"a program {only}"
        raise UnusableLogError(f"{names} (--only NAME chooses)", f"{len(found)}")
    return found[0]


def _tree(tree: dict[str, Any], output: str) -> None:
    text = tree.pop("text")
    if output == "json":
        echo(_line(tree))
        return
    number = tree["outcomes"]
    echo("\n".join([_line(tree["header"]), *text, f"{number} outcome{'s' if number > 1 else ''}"]))


def _adapter(run: Callable[[Engine, Program], list[dict[str, Any]]]) -> int:
    with pool.engine() as engine:
        for text in sys.stdin.buffer:
            if not text.strip():
                continue
            try:
                lines = [*run(engine, read_program(text)), {"event": "done"}]
            except (UnusableLogError, EngineError) as error:
                lines = [{"event": "skip", "reason": str(error)}]
            sys.stdout.write("".join(_line(line) + "\n" for line in lines))
            sys.stdout.flush()
    return 0


def _line(value: dict[str, Any]) -> str:
    return msgspec.json.encode(value).decode()
