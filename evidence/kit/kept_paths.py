"""kit/paths.ndjson.gz: the programs of paths through the graphs of models, with the hash of what they were made from.

A line with a model and a header stands above the paths that begin so.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

from evidence.common.checkout import MANIFEST, ROOT
from evidence.common.processes import Processes
from evidence.common.texts import digest
from evidence.kit import paths
from evidence.kit.files import PATHS, Json, as_line, read_lines, write_lines
from evidence.models.manifest import Model, load
from evidence.models.unchanged import behaviours
from evidence.tla import behaviour, values
from evidence.tla.tlc import Toolchain, find_toolchain
from s7check.kit import from_log

_MAKERS = (paths, behaviour, values, from_log)
"""The modules that make a program of a graph."""
_FROM_LOG = ROOT / "trace_checker" / "engine" / "src" / "main" / "java" / "s7" / "log" / "FromLog.java"


def models() -> list[Model]:
    """The models, in the order of the manifest."""
    return [model for model in load(ROOT / MANIFEST).models if model.name in paths.MODELS]


def renew(processes: Processes) -> None:
    """Have TLC write the graphs, and keep their paths. Raises NoGraphError, ToolMissingError, OSError."""
    tools = find_toolchain(None)
    write_lines(ROOT / PATHS, [line for model in models() for line in _lines(model, tools, processes)])


def _lines(model: Model, tools: Toolchain, processes: Processes) -> Iterator[Json]:
    # What changes while TLC runs is newer than the paths.
    begin = {"model": model.name, "origin": origin(model)}
    graph = paths.graph(model, tools, processes)
    by_header: dict[str, list[Json]] = {}
    for number, causes in paths.of_graph(graph):
        head = {**begin, "header": causes.pop("header")}
        by_header.setdefault(as_line(head), [head]).append({"path": number, **causes})
    for lines in by_header.values():
        yield from lines


def problems(folder: Path = ROOT) -> list[str]:
    """What is older than what it was made from, and the command that makes it anew. Raises OSError, ValueError."""
    kept = {(line["model"], line["origin"]) for line in read_lines(folder / PATHS) if "model" in line}
    now = {(model.name, origin(model, folder)) for model in models()}
    stale = sorted({name for name, _ in kept ^ now})
    return [f"{PATHS}: older than the model {name}: s7spec kit paths --write" for name in stale]


def origin(model: Model, folder: Path = ROOT) -> str:
    """The hash of what decides a model's graph and the paths through it.

    That is what the behaviours need of the specification's and the model's definitions, wherever they stand, the
    constants, and the text of the modules that make programs of a graph; comments and layout of TLA+ do not count.
    """
    return digest([*behaviours(model, folder), *map(_text, _MAKERS), _FROM_LOG.read_text(encoding="utf-8")])


def _text(module: ModuleType) -> str:
    assert module.__file__ is not None
    lines = Path(module.__file__).read_text(encoding="utf-8").splitlines()
    return "\n".join(line for line in lines if line.strip() and not line.startswith(("import ", "from ")))
