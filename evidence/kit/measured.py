"""kit/reached.ndjson: what each program of the kit reaches, with the hash of what it was measured on."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from evidence.common.checkout import ROOT, SOFT_PLC
from evidence.kit.files import REACHED, Json, as_line, digest, read_lines, write_lines
from evidence.kit.programs import programs
from evidence.tla.modules import read_modules

_SOFT_PLC = ("faults", "plc", "random", "s7cpu", "scenario")
"""The folders that the soft PLC is built from."""


def write(origin: str, names: Iterable[str], of: Mapping[str, Json]) -> None:
    """Keep the requirements and the outcomes of guards that the programs of these names reach.

    `origin` is that before the measurement: what changes meanwhile is newer. Raises OSError.
    """
    nothing: Json = {"requirements": [], "guards": []}
    write_lines(ROOT / REACHED, [{"origin": origin}, *_lines({name: of.get(name, nothing) for name in names})])


def _lines(of: Mapping[str, Json]) -> Iterator[Json]:
    """A line for the programs that reach the same requirements, and one for the outcomes of guards of a definition."""
    alike: dict[str, list[str]] = {}
    guards: dict[str, dict[str, list[str]]] = {}
    for name, found in sorted(of.items()):
        alike.setdefault(" ".join(found["requirements"]), []).append(name)
        for guard in found["guards"]:
            module, definition, outcome = guard.split("/", 2)
            guards.setdefault(f"{module}/{definition}", {}).setdefault(outcome, []).append(name)
    yield from ({"requirements": names, "programs": alike[names]} for names in sorted(alike))
    yield from ({"definition": name, "guards": dict(sorted(guards[name].items()))} for name in sorted(guards))


def problems(folder: Path = ROOT) -> list[str]:
    """Says that it is older than what it was measured on, and the command. Raises OSError, ValueError."""
    if read_lines(folder / REACHED)[0] == {"origin": origin(folder)}:
        return []
    return [f"{REACHED}: older than spec/, the soft PLC or a program of the kit: s7spec kit reached --write"]


def origin(folder: Path = ROOT) -> str:
    """The hash of the specification without comments and layout, of the soft PLC, and of the programs."""
    modules = read_modules(folder / "spec")
    sources = sorted(file for part in _SOFT_PLC for file in (SOFT_PLC / part).glob("*.[ch]"))
    return digest(
        [
            *(f"{name} {module.code}" for name, module in modules.items()),
            *(file.read_text(encoding="utf-8") for file in sources),
            *map(as_line, programs()),
        ]
    )
