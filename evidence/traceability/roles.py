"""What the modules of spec/ are for.

The rules are what the system and the explanation of a log are made of. Modules that build on the explanation of a log
only say why a log is rejected. The others say what must hold of the rules.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from evidence.traceability.modules import Module

SYSTEM = "System"
EXPLANATION = "Unrecorded"


def rules(spec: Sequence[Module]) -> list[Module]:
    """The modules that say what the CPU does."""
    names = extended({SYSTEM, EXPLANATION}, spec)
    return [module for module in spec if module.name in names]


def statements(spec: Sequence[Module]) -> list[Module]:
    """The modules that say what must hold: properties, and specifications that the rules implement."""
    names = extended({SYSTEM, EXPLANATION}, spec)
    return [m for m in spec if m.name not in names and EXPLANATION not in extended({m.name}, spec)]


def extended(names: Iterable[str], modules: Sequence[Module]) -> set[str]:
    """These modules and all that they extend."""
    extends = {module.name: module.extends for module in modules}
    found: set[str] = set()
    todo = list(names)
    while todo:
        name = todo.pop()
        if name in extends and name not in found:
            found.add(name)
            todo += extends[name]
    return found
