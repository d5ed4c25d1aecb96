"""The roles of the modules of spec/.

The rules are the parts of the system and of the explanation of a log. The other modules behind a report only merge
explanations, or say why a log is rejected. Those behind no report state properties of the rules.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from evidence.tla.modules import JUDGING, reached
from evidence.views.traceability.modules import Definition, Module

SYSTEM = "System"
EXPLANATION = "PartialLogs"
REPORT = JUDGING
READINGS = "Readings"
"""The module with a name for each answer to a question that the sources leave open."""


def rules(spec: Sequence[Module]) -> list[Module]:
    """The modules with rules."""
    names = extended({SYSTEM, EXPLANATION}, spec)
    return [module for module in spec if module.name in names]


def statements(spec: Sequence[Module]) -> list[Module]:
    """The modules with statements about the rules: properties, and specifications that the rules implement."""
    names = extended({SYSTEM, EXPLANATION, REPORT}, spec)
    return [module for module in spec if module.name not in names]


def lookups(ambiguity: str, ruling: Sequence[Module]) -> list[Definition]:
    """The definitions that look an ambiguity up, by themselves or by a name of module Readings."""
    names = {d.name for m in ruling if m.name == READINGS for d in m.definitions if ambiguity in d.readings}
    others = [d for m in ruling if m.name != READINGS for d in m.definitions]
    return [d for d in others if ambiguity in d.readings or names & d.words]


def extended(names: Iterable[str], modules: Sequence[Module]) -> frozenset[str]:
    """These modules and all that they extend."""
    return reached(names, {module.name: module.extends for module in modules})
