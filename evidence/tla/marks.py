"""Which expressions TLC evaluates.

In a copy of the specification expressions tell TLC when they are evaluated for the first time.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from evidence.tla.syntax import Module, Span, walk

MODULE = "EvaluationMarks"
_SAID = re.compile(r'<<"evaluated", (\d+)>>')

Wrapping = tuple[str, str]
"""The text before an expression and after it."""


def when_evaluated(number: int) -> Wrapping:
    """Mark an expression, which may be an action: it is evaluated."""
    return f"(IF Evaluated({number}) THEN", " ELSE FALSE)"


def by_value(true: int, false: int) -> Wrapping:
    """Mark a state or action predicate: by one number that it is TRUE, by another that it is FALSE."""
    return "(IF", f" THEN Evaluated({true}) ELSE ~Evaluated({false}))"


def marked(modules: Mapping[str, Module], around: Mapping[tuple[str, Span], Wrapping], number: int) -> dict[str, bytes]:
    """The modules with marks around expressions, and the module of the marks, which are numbered from 1."""
    texts = {MODULE: _marks(number)}
    for name in {module for module, _ in around}:
        own = {span: wrapping for (module, span), wrapping in around.items() if module == name}
        texts[name] = _extend(modules[name].wrapped(own))
    return texts


def evaluated(output: str) -> frozenset[int]:
    """The numbers of the marks that TLC told."""
    return frozenset(int(number) for number in _SAID.findall(output))


def _marks(number: int) -> bytes:
    # An IF, no disjunction: of that TLC would take both sides where it looks for next states.
    return rf"""---- MODULE {MODULE} ----
LOCAL INSTANCE Naturals
LOCAL INSTANCE TLC
ASSUME \A i \in 1..{number} : TLCSet(i, FALSE)
Evaluated(i) == IF TLCGet(i) THEN TRUE ELSE TLCSet(i, TRUE) /\ PrintT(<<"evaluated", i>>)
====
""".encode()


def _extend(text: bytes) -> bytes:
    """Have a module extend that of the marks."""
    extends = next((node for node in walk(Module("", text).root) if node.type == "extends"), None)
    if extends is not None:
        behind = extends.start_byte + len("EXTENDS")
        return text[:behind] + f" {MODULE},".encode() + text[behind:]
    head, line, rest = text.partition(b"\n")
    return head + line + f"EXTENDS {MODULE}\n".encode() + rest
