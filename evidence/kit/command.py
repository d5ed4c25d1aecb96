"""``s7check generate-kit``."""

from __future__ import annotations

import json
from collections.abc import Iterable
from pathlib import Path

import click

from evidence.common.checkout import ROOT
from evidence.kit import calendar, calls, meetings, shipped, waiting
from evidence.kit.from_log import Json
from s7check.kit.program import read_program

PROGRAMS = ROOT / "kit" / "programs"


@click.command("generate-kit", short_help="Make the programs of the conformance kit.")
@click.option("--seed", type=click.IntRange(min=0), default=1, show_default=True, help="Decides the drawn programs.")
@click.option("--write", is_flag=True, help="Write the files of kit/programs; without it, say whether they differ.")
def generate_command(seed: int, write: bool) -> int:
    """Make the programs; the same seed gives the same programs.

    Exit codes: 0 done, or nothing differs; 1 the files differ, and --write was not given.
    """
    made = [
        *shipped.programs(ROOT / "traces"),
        *calls.programs(),
        *calendar.programs(),
        *waiting.programs(),
        *meetings.programs(seed),
    ]
    files = _by_area(made)
    click.echo(f"{len(made)} programs, {sum(map(len, files.values())):,} bytes")
    different = [name for name, text in files.items() if _kept(PROGRAMS / name) != text]
    different += sorted(file.name for file in PROGRAMS.glob("*.ndjson") if file.name not in files)
    if not write:
        for name in different:
            click.echo(f"kit/programs/{name} differs: expected the programs of this seed; see --write")
        return 1 if different else 0
    PROGRAMS.mkdir(parents=True, exist_ok=True)
    for name in different:
        if name in files:
            (PROGRAMS / name).write_text(files[name], encoding="utf-8")
        else:
            (PROGRAMS / name).unlink()
    return 0


def _kept(file: Path) -> str:
    return file.read_text(encoding="utf-8") if file.is_file() else ""


def _by_area(programs: Iterable[Json]) -> dict[str, str]:
    """The text of each file, a program a line, the smallest first."""
    areas: dict[str, list[str]] = {}
    for program in programs:
        line = json.dumps(program, ensure_ascii=False, separators=(",", ":"))
        read_program(line.encode())
        areas.setdefault(program["name"].split("-")[0], []).append(line)
    return {f"{area}.ndjson": "".join(f"{line}\n" for line in sorted(lines, key=len)) for area, lines in areas.items()}
