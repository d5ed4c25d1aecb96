"""The modules of a directory, and what each is built on."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from evidence.tla.syntax import Module

WORDING = ("PastLines", "*Reasons", "Explain")
"""Modules of spec/ that only word a rejection."""


def read_modules(directory: Path) -> dict[str, Module]:
    """The modules of a directory by name."""
    return {path.stem: Module(path.stem, path.read_bytes()) for path in sorted(directory.rglob("*.tla"))}


def closure(root: str, modules: Mapping[str, Module]) -> frozenset[str]:
    """The module and those of `modules` that it is built on."""
    found: set[str] = set()
    waiting = {root}
    while waiting:
        name = waiting.pop()
        found.add(name)
        waiting |= {n for n in modules[name].imports if n in modules} - found
    return frozenset(found)
