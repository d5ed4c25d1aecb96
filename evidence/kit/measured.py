"""kit/reached.ndjson: what each program of the kit reaches, with the hash of what it was measured on."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import groupby
from pathlib import Path

from evidence.common.checkout import ROOT, SOFT_PLC
from evidence.common.texts import digest
from evidence.kit.files import REACHED, Json, as_line, read_lines, write_lines
from evidence.kit.programs import programs
from evidence.tla.modules import judging, read_modules
from s7check.log.errors import ranges

_SOFT_PLC = ("faults", "plc", "random", "s7cpu", "scenario")
"""The folders that the soft PLC is built from."""


def write(origin: str, names: Iterable[str], of: Mapping[str, Json]) -> None:
    """Keep the requirements and the outcomes of guards that the programs of these names reach.

    `origin` is that before the measurement: what changes meanwhile is newer. Raises OSError.
    """
    nothing: Json = {"requirements": [], "guards": []}
    write_lines(ROOT / REACHED, [{"origin": origin}, *_lines({name: of.get(name, nothing) for name in names})])


def _lines(of: Mapping[str, Json]) -> Iterator[Json]:
    """The programs by area, and for each requirement their numbers in this order; then the outcomes of guards.

    These are gathered by definition, each outcome with the names of its few programs.
    """
    names = sorted(of)
    requirements: dict[str, list[int]] = {}
    guards: dict[str, dict[str, list[str]]] = {}
    for number, name in enumerate(names):
        for requirement in of[name]["requirements"]:
            requirements.setdefault(requirement, []).append(number)
        for guard in of[name]["guards"]:
            module, definition, outcome = guard.split("/", 2)
            guards.setdefault(f"{module}/{definition}", {}).setdefault(outcome, []).append(name)
    yield from ({"programs": list(alike)} for _, alike in groupby(names, key=lambda name: name.partition("-")[0]))
    yield from ({"requirement": name, "numbers": ranges(requirements[name])} for name in sorted(requirements))
    yield from ({"definition": name, "guards": dict(sorted(guards[name].items()))} for name in sorted(guards))


def problems(folder: Path = ROOT) -> list[str]:
    """Says that it is older than what it was measured on, and the command. Raises OSError, ValueError."""
    if read_lines(folder / REACHED)[0] == {"origin": origin(folder)}:
        return []
    return [f"{REACHED}: older than spec/, the soft PLC or a program of the kit: s7spec kit reached --write"]


def origin(folder: Path = ROOT) -> str:
    """The hash of the modules that judge logs, without comments and layout, of the soft PLC, and of the programs.

    What a program is about, and the requirements that it names, change nothing of what it reaches; the questions that
    it names do.
    """
    modules = judging(read_modules(folder / "spec"))
    sources = sorted(file for part in _SOFT_PLC for file in (SOFT_PLC / part).glob("*.[ch]"))
    return digest(
        [
            *(f"{name} {module.code}" for name, module in modules.items()),
            *(file.read_text(encoding="utf-8") for file in sources),
            *(as_line(program | {"about": "", "requirements": _questions(program)}) for program in programs()),
        ]
    )


def _questions(program: Json) -> list[str]:
    return [name for name in program["requirements"] if name.startswith("AMB-")]
