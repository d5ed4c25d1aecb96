"""Which expressions a model evaluates.

In a copy of the specification each expression that has mutants tells TLC when it is evaluated for the first time. A
mutant of an expression that a model does not evaluate changes nothing for the model, which then need not be run.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from trace_checker.mutants.listing import Mutant
from trace_checker.mutants.syntax import Module, Span

MODULE = "MutantMarks"
_SAID = re.compile(r'<<"evaluated", (\d+)>>')


@dataclass(frozen=True)
class Marks:
    """The marked modules by name, the module of the marks itself among them, and the number of each mutant's mark."""

    texts: Mapping[str, bytes]
    numbers: Mapping[str, int]


def mark(modules: Mapping[str, Module], mutants: Sequence[Mutant]) -> Marks:
    """Mark the expressions of these mutants."""
    spans = sorted({(m.module, m.span) for m in mutants})
    number = {place: index for index, place in enumerate(spans, 1)}
    texts = {MODULE: _marks(len(spans))}
    for name in {module for module, _ in spans}:
        around: dict[Span, tuple[str, str]] = {
            span: (f"(IF Evaluated({index}) THEN", " ELSE FALSE)")
            for (module, span), index in number.items()
            if module == name
        }
        texts[name] = _extend(modules[name].wrapped(around))
    return Marks(texts, {m.id: number[m.module, m.span] for m in mutants})


def evaluated(output: str) -> frozenset[int]:
    """The numbers of the marks that TLC told."""
    return frozenset(int(number) for number in _SAID.findall(output))


def _marks(number: int) -> bytes:
    return rf"""---- MODULE {MODULE} ----
LOCAL INSTANCE Naturals
LOCAL INSTANCE TLC
ASSUME \A i \in 1..{number} : TLCSet(i, FALSE)
Evaluated(i) == TLCGet(i) \/ (TLCSet(i, TRUE) /\ PrintT(<<"evaluated", i>>))
====
""".encode()


def _extend(text: bytes) -> bytes:
    """Have a module extend that of the marks."""
    if Module("", text).imports:
        return text.replace(b"EXTENDS", f"EXTENDS {MODULE},".encode(), 1)
    head, line, rest = text.partition(b"\n")
    return head + line + f"EXTENDS {MODULE}\n".encode() + rest
