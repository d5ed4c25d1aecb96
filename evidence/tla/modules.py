"""The modules of a directory, and the modules that each is built on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from evidence.tla.syntax import Module, SyntaxTreeError
from s7check.resources import modules

WORDING = ("*Reasons", "PastLines", "Explain", "NextLines")
"""Modules of spec/ that only word a rejection or the possible next lines: no verdict depends on them."""


JUDGING = "Explain"
"""The module of spec/ that the trace checker's engine evaluates."""


def read_modules(directory: Path) -> dict[str, Module]:
    """The modules of a directory by name."""
    return {path.stem: Module(path.stem, path.read_bytes()) for path in modules(directory)}


def module_folders(directory: Path) -> tuple[Path, ...]:
    """The folders in which the modules of a directory stand: where TLC looks for them."""
    return tuple(sorted({path.parent for path in modules(directory)}))


def closure(root: str, modules: Mapping[str, Module]) -> frozenset[str]:
    """The module, and the modules that it is built on. Raises `SyntaxTreeError` if it is not among them."""
    if root not in modules:
        raise SyntaxTreeError(f"{root}.tla: no such module")
    return reached([root], {name: module.imports for name, module in modules.items()})


def judging(spec: Mapping[str, Module]) -> dict[str, Module]:
    """The modules of spec/ that the trace checker's engine reads; those of properties are not among them."""
    return {name: spec[name] for name in sorted(closure(JUDGING, spec))}


def reached(names: Iterable[str], uses: Mapping[str, Iterable[str]]) -> frozenset[str]:
    """The names that `uses` knows, and all names that they use, directly or not."""
    found: set[str] = set()
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        if name in uses and name not in found:
            found.add(name)
            waiting += uses[name]
    return frozenset(found)
