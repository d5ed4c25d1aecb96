"""The kinds of change that make a mutant.

No change is made that TLC refuses whatever the rules say: what determines the next state (or, in Init, the first) is
never dropped, negated or made an alternative, since a state with a missing variable is an error and shows nothing.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from tree_sitter import Node

from evidence.tla.actions import Actions, assigns, conjuncts, disjuncts, sides
from evidence.tla.syntax import At, Module, Piece, code, meaningful, operand, symbol, token, walk

COMPARISONS: Mapping[str, tuple[str, ...]] = {
    "eq": ("#",),
    "neq": ("=",),
    "lt": ("<=", ">="),
    "leq": ("<", ">"),
    "gt": (">=", "<="),
    "geq": (">", "<"),
    "in": ("\\notin",),
    "notin": ("\\in",),
}
"""The replacements of a comparison; its opposite is among them."""


@dataclass(frozen=True)
class Edit:
    """A change: its kind, the node that is replaced, and the pieces in its place."""

    kind: str
    node: Node
    pieces: tuple[Piece, ...]

    @property
    def by(self) -> str:
        """The new code on one line."""
        texts = (p if isinstance(p, str) else p.text if isinstance(p, At) else code(p) for p in self.pieces)
        return " ".join("".join(f" {text} " for text in texts).split())


@dataclass(frozen=True)
class Context(Actions):
    """The context of a change: also the literals of the module, by the type of their nodes."""

    literals: Mapping[str, frozenset[str]] = field(default_factory=dict)


def literals(module: Module) -> dict[str, frozenset[str]]:
    """The strings and hexadecimal numbers of a module, by the type of their nodes."""
    nodes = [n for n in walk(module.root) if n.type in ("string", "hex_number")]
    return {kind: frozenset(token(n) for n in nodes if n.type == kind) for kind in ("string", "hex_number")}


def edits(definition: Node, context: Context) -> Iterator[Edit]:
    """All changes of a definition, in the order of the text."""
    for node in walk(definition):
        for operator in OPERATORS:
            yield from operator(node, context)


def _drop_conjunct(node: Node, context: Context) -> Iterator[Edit]:
    for part in conjuncts(node):
        if not context.acts(part) and part.type != "boolean":
            yield Edit("drop-conjunct", part, ("TRUE",))


def _drop_disjunct(node: Node, _: Context) -> Iterator[Edit]:
    for part in disjuncts(node):
        if part.type != "boolean":
            yield Edit("drop-disjunct", part, ("FALSE",))


def _negate(kind: str, node: Node, context: Context) -> Iterator[Edit]:
    """Negate an expression, unless a comparison's opposite or a flipped literal does so already."""
    if context.acts(node) or node.type == "boolean" or symbol(node) in COMPARISONS:
        return
    if symbol(node) == "lnot":
        yield Edit(kind, node, (operand(node, "rhs"),))
    else:
        yield Edit(kind, node, ("~(", node, ")"))


def _negate_guard(node: Node, context: Context) -> Iterator[Edit]:
    guards = conjuncts(node)
    if symbol(node) == "implies":
        guards = [operand(node, "lhs")]
    elif node.type == "set_filter":
        guards = [operand(node, "filter")]
    for guard in guards:
        yield from _negate("negate-guard", guard, context)


def _negate_condition(node: Node, context: Context) -> Iterator[Edit]:
    if node.type == "if_then_else":
        yield from _negate("negate-condition", operand(node, "if"), context)


def _compare(node: Node, context: Context) -> Iterator[Edit]:
    if symbol(node) not in COMPARISONS:
        return
    left, right = sides(node)
    if symbol(left) == "prime" or (context.initial and assigns(node)):
        return
    for other in COMPARISONS[symbol(node)]:
        yield Edit("comparison", node, (left, f" {other} ", right))


def _connect(node: Node, context: Context) -> Iterator[Edit]:
    if node.type in ("conj_list", "disj_list"):
        items = [meaningful(item) for item in meaningful(node)]
        other = "\\/" if node.type == "conj_list" else "/\\"
        pieces: tuple[Piece, ...] = tuple(p for item in items for p in (At(item[0], other), item[-1]))
        pair = len(items) > 1
    elif symbol(node) in ("land", "lor"):
        left, right = sides(node)
        other = "\\/" if symbol(node) == "land" else "/\\"
        # The two have the same precedence and need parentheses beside each other.
        pieces = ("((", left, f") {other} (", right, "))")
        pair = True
    else:
        return
    if pair and not (other == "\\/" and context.acts(node)):
        yield Edit("connective", node, pieces)


def _quantify(node: Node, context: Context) -> Iterator[Edit]:
    if node.type != "bounded_quantification":
        return
    quantifier = operand(node, "quantifier")
    if quantifier.type == "exists" and not context.acts(node):
        yield Edit("quantifier", quantifier, ("\\A",))
    elif quantifier.type == "forall":
        yield Edit("quantifier", quantifier, ("\\E",))


def _calculate(node: Node, _: Context) -> Iterator[Edit]:
    if symbol(node) in ("plus", "minus"):
        other = "-" if symbol(node) == "plus" else "+"
        yield Edit("arithmetic", node, (operand(node, "lhs"), f" {other} ", operand(node, "rhs")))


def _count(node: Node, _: Context) -> Iterator[Edit]:
    if node.type == "nat_number":
        number = int(token(node))
        yield Edit("constant", node, (str(number + 1),))
        yield Edit("constant", node, (str(number - 1) if number else "(-1)",))


def _keep_field(node: Node, _: Context) -> Iterator[Edit]:
    if node.type == "except_update":
        value = operand(node, "new_val")
        if value.type != "prev_func_val":
            yield Edit("keep-field", value, ("@",))


def _keep_variable(node: Node, _: Context) -> Iterator[Edit]:
    if symbol(node) in ("eq", "in") and symbol(operand(node, "lhs")) == "prime":
        left, right = sides(node)
        variable = token(operand(left, "lhs"))
        if token(right) != variable:
            yield Edit("unchanged", node, (left, f" = {variable}"))


def _drop_from_union(node: Node, _: Context) -> Iterator[Edit]:
    members = sides(node) if symbol(node) in ("cup", "setminus") else []
    for side in members[1:] if symbol(node) == "setminus" else members:
        if symbol(side) != "cup":  # its own sides are dropped one by one
            yield Edit("drop-union", side, ("{}",))


def _drop_arm(node: Node, _: Context) -> Iterator[Edit]:
    if node.type in ("case_arm", "other_arm"):
        yield Edit("drop-case", meaningful(node)[0], ("FALSE",))


def _replace_literal(node: Node, context: Context) -> Iterator[Edit]:
    others = context.literals.get(node.type, frozenset()) - {token(node)}
    if others:
        # Whatever else is in the module, the same one wins: an id lives as long as both literals do.
        yield Edit("literal", node, (min(others, key=lambda other: _rank(token(node), other)),))


def _rank(*texts: str) -> bytes:
    return hashlib.sha256("\0".join(texts).encode()).digest()


def _flip(node: Node, _: Context) -> Iterator[Edit]:
    if node.type == "boolean":
        yield Edit("boolean", node, ("FALSE" if token(node) == "TRUE" else "TRUE",))


OPERATORS: Sequence[Callable[[Node, Context], Iterator[Edit]]] = (
    _drop_conjunct,
    _drop_disjunct,
    _negate_guard,
    _negate_condition,
    _compare,
    _connect,
    _quantify,
    _calculate,
    _count,
    _keep_field,
    _keep_variable,
    _drop_from_union,
    _drop_arm,
    _replace_literal,
    _flip,
)
