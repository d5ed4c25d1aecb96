"""What a model is made of: the modules that it is built on, the definitions that it replaces."""

from __future__ import annotations

from collections.abc import Mapping

from evidence.models import cfg
from evidence.mutants.syntax import Module


def closure(root: str, modules: Mapping[str, Module]) -> frozenset[str]:
    """The module and those of `modules` that it is built on."""
    found: set[str] = set()
    waiting = {root}
    while waiting:
        name = waiting.pop()
        found.add(name)
        waiting |= {n for n in modules[name].imports if n in modules} - found
    return frozenset(found)


def replacements(text: str) -> dict[str, str]:
    """The definitions that a configuration replaces by others."""
    return {a.name: a.value for a in cfg.parse(text).assignments if a.operator == "<-"}
