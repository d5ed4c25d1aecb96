"""All mutants of a specification."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from tree_sitter import Node

from evidence.mutants.operators import Context, edits, literals
from evidence.tla.actions import INITIAL, TEMPORAL, acting
from evidence.tla.names import Names
from evidence.tla.syntax import Module, Span, code, operand, span, walk

STATEMENTS = frozenset({"bounded_quantification", "case"})
"""The expressions that a quantifier or OTHER is part of."""


@dataclass(frozen=True)
class Mutant:
    """A changed specification: which module, its whole text, and the change in words.

    `span` is where the expression stands that is evaluated otherwise.
    """

    id: str
    module: str
    definition: str
    kind: str
    line: int
    was: str
    by: str
    span: Span
    text: bytes


def mutants(modules: Mapping[str, Module], names: Iterable[str]) -> list[Mutant]:
    """All mutants of the modules of these names. Raises `SyntaxTreeError`."""
    return [mutant for name in sorted(names) for mutant in _of_module(modules[name], acting(name, modules))]


def _of_module(module: Module, actions: frozenset[str]) -> Iterator[Mutant]:
    seen = {_words(module.text)}
    names = Names(module.name)
    known = literals(module)
    for definition, unit in module.definitions.items():
        body = operand(unit, "definition")
        if any(node.type in TEMPORAL for node in walk(body)):
            continue
        context = Context(actions, definition == INITIAL, known)
        for edit in edits(body, context):
            text = module.replaced(edit.node, edit.pieces)
            if (words := _words(text)) in seen:
                continue  # another kind of change has come to the same
            seen.add(words)
            yield Mutant(
                names.give(definition, edit.kind, body, edit.node, edit.by),
                module.name,
                definition,
                edit.kind,
                edit.node.start_point.row + 1,
                code(edit.node),
                edit.by,
                span(_expression(edit.node)),
                text,
            )


def _words(text: bytes) -> bytes:
    return b" ".join(text.split())


def _expression(node: Node) -> Node:
    """The node, or the expression that it is a word of."""
    if node.type in ("forall", "exists", "OTHER"):
        while node.type not in STATEMENTS:
            assert node.parent is not None
            node = node.parent
    return node
