"""All mutants of a specification.

A mutant's id is made of the module, the definition, the kind of change, and a hash of the code that is replaced, of
what replaces it, and of the few words before it: lines may move, and other definitions change, without a new id.
"""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from tree_sitter import Node

from evidence.mutants.operators import INITIAL, Context, acting, edits, literals
from evidence.mutants.syntax import COMMENTS, Module, Span, code, leaves, operand, span, token, walk

TEMPORAL = frozenset({"step_expr_or_stutter", "step_expr_no_stutter", "fairness"})
"""What makes a definition a formula for TLC to read, not to evaluate."""

CONTEXT = 3
"""How many words tell equal changes of one definition apart."""

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


class Names:
    """Gives ids to places of a module that last while lines move and other definitions change."""

    def __init__(self, module: str) -> None:
        """Begin with none."""
        self._module = module
        self._given: Counter[str] = Counter()

    def give(self, definition: str, kind: str, body: Node, node: Node, *more: str) -> str:
        """Make an id of a definition, a kind, and a hash of a node of its body, of words before it, and of `more`."""
        words = "\0".join([_before(body, node), code(node), *more])
        name = f"{self._module}/{definition}/{kind}/{hashlib.sha256(words.encode()).hexdigest()[:8]}"
        self._given[name] += 1
        return f"{name}-{self._given[name]}" if self._given[name] > 1 else name


def read_modules(directory: Path) -> dict[str, Module]:
    """The modules of a directory by name."""
    return {path.stem: Module(path.stem, path.read_bytes()) for path in sorted(directory.rglob("*.tla"))}


def mutants(modules: Mapping[str, Module], names: Iterable[str]) -> list[Mutant]:
    """All mutants of the modules of these names. Raises `SyntaxTreeError`."""
    actions = acting(modules.values())
    return [mutant for name in sorted(names) for mutant in _of_module(modules[name], actions)]


def _of_module(module: Module, actions: frozenset[str]) -> Iterator[Mutant]:
    seen = {_words(module.text)}
    names = Names(module.name)
    known = literals(module)
    for definition, unit in module.definitions.items():
        body = operand(unit, "definition")
        if any(node.type in TEMPORAL for node in walk(body)):
            continue
        context = Context(actions, known, initial=definition == INITIAL)
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


def _before(body: Node, node: Node) -> str:
    """The last words of a definition's body before a node."""
    words = [leaf for leaf in leaves(body) if leaf.type not in COMMENTS and leaf.end_byte <= node.start_byte]
    return " ".join(map(token, words[-CONTEXT:]))


def _expression(node: Node) -> Node:
    """The node, or the expression that it is a word of."""
    if node.type in ("forall", "exists", "OTHER"):
        while node.type not in STATEMENTS:
            assert node.parent is not None
            node = node.parent
    return node
