"""``s7check migrate``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click
import msgspec

from s7check.asking.log_prefix import Prefix, read_prefix
from s7check.asking.variants import AS_IT_IS
from s7check.completion import complete_files
from s7check.ending import ending
from s7check.engine import pool
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.kit.from_log import program_of
from s7check.kit.program import FORMAT, HEADER_FIELDS, Program, read_program
from s7check.log.errors import UnusableLogError
from s7check.migrating.as_html import page
from s7check.migrating.table import FAMILIES, Difference
from s7check.migrating.walk import Point, migrated, points
from s7check.output import echo
from s7check.report.report import clause_text
from s7check.simulating.separation import log_of
from s7check.simulating.simulate_command import the_program

Json = dict[str, Any]

_HELP = """Tell what changes for a program on a CPU of another family.

LOG is a log of the old CPU, LOG:7 the log up to line 7, PROGRAM a program of the kit, which both CPUs run. Each line
that the new CPU would not show, or need not, has what was, what it becomes, what to do in the program, and the rules of
both sides. The new family is advisory: what no text states is open, and a point of trust L is a hint.

Priorities are kept, as a migration keeps them; --new-project takes the defaults of the new family.

Exit codes: 0 no difference, 1 differences, 2 the log cannot be used, 3 the specification could not be evaluated.
"""


@click.command("migrate", help=_HELP, short_help="Tell what changes for a program on a CPU of another family.")
@click.option("--to", "family", type=click.Choice(list(FAMILIES)), default="S7-1500", show_default=True, help="It.")
@click.option("--new-project", is_flag=True, help="Priorities by default, not kept.")
@click.option(
    "--format", "output", type=click.Choice(["text", "json", "html"]), default="text", show_default=True, help="Form."
)
@click.option("--only", metavar="NAME", help="The program with this name, where the file has several.")
@click.argument("log", metavar="LOG[:LINE]|PROGRAM", shell_complete=complete_files)
def migrate_command(family: str, new_project: bool, output: str, only: str | None, log: str) -> int:
    """Compare and print."""
    with ending(log), pool.engine() as engine:
        prefix, program = _read(engine, log, only)
        found = list(points(engine, prefix, family, new_project))
        if output == "json":
            echo("\n".join(msgspec.json.encode(point).decode() for point in found))
        elif output == "html":
            other = _other_log(engine, prefix, program, migrated(prefix.header, family, new_project))
            mine = [line for _, line in prefix.events]
            echo(page(Path(prefix.name).name, (prefix.header["cpu"], family), found, mine, other).decode())
        else:
            echo("\n".join(_text(prefix, family, found)))
    return 1 if found else 0


def _read(engine: Engine, name: str, only: str | None) -> tuple[Prefix, Program | None]:
    """The log, or that which the old CPU makes of a program."""
    path = Path(name)
    if path.is_file() and FORMAT.encode() in path.read_bytes()[:4096]:
        program = the_program(path, only)
        header, *lines = log_of(engine, program, AS_IT_IS)
        return Prefix(name, header, list(enumerate(lines, 2))), program
    return read_prefix(engine, name), None


def _other_log(engine: Engine, prefix: Prefix, program: Program | None, header: Json) -> list[Json]:
    """What the new CPU makes of the program, or of that which the log shows; nothing where that cannot be told."""
    try:
        raw = program.raw if program else program_of(engine, prefix.texts, "migrated", "A log's program.", [])
        fields = {name: header[name] for name in HEADER_FIELDS if name in header}
        return log_of(engine, read_program(msgspec.json.encode(raw | {"header": fields})), AS_IT_IS)[1:]
    except (EngineError, UnusableLogError):
        return []


def _text(prefix: Prefix, family: str, found: list[Point]) -> list[str]:
    if not found:
        return [f"{prefix.name}: nothing of it changes on an {family}, as far as its texts say"]
    first = next((point for point in found if point.kind != "hint"), None)
    begin = f"first line that changes: {first.line}" if first else "no line changes; hints below"
    said = [f"{prefix.name}: on an {family}, {begin}"]
    told: set[str] = set()
    for point in found:
        said += _of_point(point, told)
    ids = sorted({name for point in found for name in (*point.old, *point.new)})
    return [*said, "", *(clause_text(name) for name in ids if name in _cited(found))]


def _cited(found: list[Point]) -> set[str]:
    """The rules of the differences, and of points without one."""
    named = {name for point in found for one in point.differences for name in (*one.old, *one.new)}
    return named | {name for point in found if not point.differences for name in (*point.old, *point.new)}


_VERBS = {"will": "does not come", "may": "need not come", "hint": "look at it"}


def _of_point(point: Point, told: set[str]) -> list[str]:
    said = [f"{point.line}: {point.at} {point.text}: {_VERBS[point.kind]}"]
    if point.instead:
        said.append(f"    instead: {', '.join(point.instead)}")
    if not point.differences:
        said.append(f"    rules: {', '.join(point.old)} -> {', '.join(point.new)}")
    for one in point.differences:
        said += [f"    {one.id}, as above"] if one.id in told else _of_difference(one)
        told.add(one.id)
    return said


def _of_difference(one: Difference) -> list[str]:
    return [
        f"    {one.id} ({one.area}, {one.trust}): {', '.join(one.old)} -> {', '.join(one.new)}",
        f"      was: {one.was}",
        f"      is:  {one.becomes}",
        f"      do:  {one.do}",
    ]
