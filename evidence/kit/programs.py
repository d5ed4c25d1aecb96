"""All programs of the kit: from the generators, the paths that TLC found, and what was measured of them.

setup.py imports this module where nothing but msgspec is installed. ``python -m evidence.kit.programs`` writes the
files to where the checkout's s7check looks for them.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from evidence.common.cases import all_cases
from evidence.common.checkout import MANIFEST, ROOT
from evidence.kit import calendar, calls, failing, meetings, nesting, resuming, shipped, steps, waiting, zones
from evidence.kit.files import PATHS, REACHED, Json, as_line, read_lines
from evidence.models.manifest import load
from s7check.kit.program import FORMAT
from s7check.resources import KIT

SEED = 1
"""Decides the drawn programs."""

MARK = "-path-"
"""In the names of the programs of paths."""


def programs() -> list[Json]:
    """Every program without what was measured of it. Raises OSError, ValueError."""
    return [
        *shipped.programs(all_cases()),
        *calls.programs(),
        *calendar.programs(),
        *waiting.programs(),
        *steps.programs(),
        *nesting.programs(),
        *meetings.programs(SEED),
        *resuming.programs(SEED),
        *failing.programs(SEED),
        *zones.programs(SEED),
        *_paths(),
    ]


def _paths() -> Iterator[Json]:
    models = {model.name: model for model in load(ROOT / MANIFEST).models}
    for line in read_lines(ROOT / PATHS):
        if "model" in line:
            model, header = models[line["model"]], line["header"]
        else:
            yield {
                "format": FORMAT,
                "name": f"{model.requirements[0].split('-')[0]}{MARK}{model.name}-{line.pop('path'):04}",
                "about": f"A path of the model {model.name}: {model.what}",
                "requirements": list(model.requirements),
                "header": header,
                **line,
            }


def by_area() -> dict[str, list[str]]:
    """The lines of the file of each area: a program a line with what it reaches, the smallest first."""
    measured = reaches()
    areas: dict[str, list[tuple[int, str, str]]] = {}
    for program in programs():
        bare = as_line(program)
        found = measured.get(program["name"])
        line = bare if found is None else as_line({**program, "reaches": found})
        areas.setdefault(program["name"].split("-")[0], []).append((len(bare), bare, line))
    return {area: [line for _, _, line in sorted(lines)] for area, lines in sorted(areas.items())}


def reaches() -> dict[str, Json]:
    """What each program reaches that was measured, by its name. Raises OSError, ValueError."""
    lines = read_lines(ROOT / REACHED)
    names = [name for line in lines for name in line.get("programs", ())]
    found: dict[str, Json] = {name: {"requirements": [], "guards": []} for name in names}
    for line in lines:
        for part in filter(None, line.get("numbers", "").split(", ")):
            first, _, last = part.partition("-")
            for name in names[int(first) : int(last or first) + 1]:
                found[name]["requirements"].append(line["requirement"])
        for outcome, few in line.get("guards", {}).items():
            for name in few:
                found[name]["guards"].append(f"{line['definition']}/{outcome}")
    return found


def write(folder: Path) -> int:
    """Write the files, ``AREA.ndjson``, and no other stays; how many programs they have. Raises OSError, ValueError."""
    files = by_area()
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.ndjson"):
        old.unlink()
    for area, lines in files.items():
        (folder / f"{area}.ndjson").write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
    return sum(map(len, files.values()))


if __name__ == "__main__":
    write(KIT)
