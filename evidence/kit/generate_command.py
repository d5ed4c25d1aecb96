"""``s7check generate-kit``."""

from __future__ import annotations

from collections.abc import Iterable

import click

from evidence.common.cases import all_cases
from evidence.common.console import plain
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.kit import calendar, calls, meetings, nesting, paths, shipped, waiting
from evidence.kit.files import PROGRAMS, as_line, kept, unmeasured
from evidence.tla.tlc import ToolMissingError
from s7check.kit.from_log import Json
from s7check.kit.program import read_program


@click.command("generate-kit", short_help="Make the programs of the conformance kit.")
@click.option("--seed", type=click.IntRange(min=0), default=1, show_default=True, help="Decides the drawn programs.")
@click.option("--write", is_flag=True, help="Write the files of kit/programs; without it, say whether they differ.")
@click.option("--without-paths", is_flag=True, help="Keep the paths of models as they are: TLC takes minutes for them.")
def generate_command(seed: int, *, write: bool, without_paths: bool) -> int:
    """Make the programs; the same seed gives the same programs.

    Exit codes: 0 done, or nothing differs; 1 the files differ, and --write was not given; 2 a file cannot be read, 3
    TLC is missing or failed, 130 interrupted.
    """
    processes = Processes()
    with session(processes, (OSError, ValueError), (ToolMissingError, paths.NoGraphError)) as console:
        known = kept()
        made = [
            *shipped.programs(all_cases()),
            *calls.programs(),
            *calendar.programs(),
            *waiting.programs(),
            *nesting.programs(),
            *meetings.programs(seed),
            *(_kept_paths(known) if without_paths else paths.programs(processes)),
        ]
        files = _by_area(made)
        plain(console, f"{len(made)} programs, {sum(len(line) for lines in files.values() for line in lines):,} bytes")
        now = {name: [as_line(unmeasured(one)) for one in programs.values()] for name, programs in known.items()}
        different = sorted(name for name in {*files, *now} if files.get(name) != now.get(name))
        if not write:
            for name in different:
                plain(console, f"kit/programs/{name} differs: expected the programs of this seed; see --write")
            return 1 if different else 0
        for name in different:
            _write(name, files.get(name, []), known.get(name, {}))
    return 0


def _kept_paths(known: dict[str, dict[str, Json]]) -> list[Json]:
    return [unmeasured(one) for programs in known.values() for name, one in programs.items() if paths.MARK in name]


def _by_area(programs: Iterable[Json]) -> dict[str, list[str]]:
    """The lines of each file, a program a line, the smallest first."""
    areas: dict[str, list[str]] = {}
    for program in programs:
        line = as_line(program)
        read_program(line.encode())
        areas.setdefault(f"{program['name'].split('-')[0]}.ndjson", []).append(line)
    return {name: sorted(lines, key=lambda line: (len(line), line)) for name, lines in areas.items()}


def _write(name: str, lines: list[str], known: dict[str, Json]) -> None:
    """Write a file, or remove it if nothing is left; what was measured of programs that stay is kept."""
    measured = {as_line(unmeasured(one)): as_line(one) for one in known.values()}
    text = "".join(f"{measured.get(line, line)}\n" for line in lines)
    PROGRAMS.mkdir(parents=True, exist_ok=True)
    if text:
        (PROGRAMS / name).write_text(text, encoding="utf-8")
    else:
        (PROGRAMS / name).unlink()
