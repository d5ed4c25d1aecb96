"""Which mutants a model can notice.

A mutant of an expression that a model does not evaluate changes nothing for the model, which then need not be run.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from evidence.mutants.listing import Mutant
from evidence.tla.marks import marked, when_evaluated
from evidence.tla.syntax import Module


@dataclass(frozen=True)
class Marks:
    """The marked modules by name, the module of the marks itself among them, and the number of each mutant's mark."""

    texts: Mapping[str, bytes]
    numbers: Mapping[str, int]


def mark(modules: Mapping[str, Module], mutants: Sequence[Mutant]) -> Marks:
    """Mark the expressions of these mutants."""
    spans = sorted({(m.module, m.span) for m in mutants})
    number = {place: index for index, place in enumerate(spans, 1)}
    texts = marked(modules, {place: when_evaluated(index) for place, index in number.items()}, len(spans))
    return Marks(texts, {m.id: number[m.module, m.span] for m in mutants})
