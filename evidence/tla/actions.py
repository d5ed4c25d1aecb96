"""Which expressions determine the next state, and the parts of a conjunction or disjunction."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from tree_sitter import Node

from evidence.tla.modules import closure
from evidence.tla.syntax import Module, meaningful, operand, references, symbol, walk

INITIAL = "Init"
"""The definition in which an equation gives a variable its first value."""

TEMPORAL = frozenset({"step_expr_or_stutter", "step_expr_no_stutter", "fairness"})
"""Parts of a formula that TLC reads and does not evaluate."""


@dataclass(frozen=True)
class Actions:
    """The definitions that determine the next state; `initial` in the definition of the first one."""

    acting: frozenset[str]
    initial: bool = False

    def acts(self, node: Node) -> bool:
        """Whether an expression determines a variable."""
        if any(n.type in ("prime", "unchanged") for n in walk(node)) or references(node) & self.acting:
            return True
        return self.initial and assigns(node)


def acting(root: str, modules: Mapping[str, Module]) -> frozenset[str]:
    """The definitions with a prime, and the definitions that use them, as a module of `modules` knows the names."""
    uses = {name: unit for known in closure(root, modules) for name, unit in modules[known].definitions.items()}
    found = {name for name, unit in uses.items() if any(n.type in ("prime", "unchanged") for n in walk(unit))}
    used = {name: references(unit) for name, unit in uses.items()}
    while more := {name for name, names in used.items() if names & found} - found:
        found |= more
    return frozenset(found)


def assigns(node: Node) -> bool:
    """Whether an expression is an equation or membership of a name."""
    return symbol(node) in ("eq", "in") and operand(node, "lhs").type == "identifier_ref"


def _members(node: Node, infix: str, bulleted: str) -> list[Node]:
    """The parts of a conjunction or disjunction; none for a part of a longer one, which is dealt with as a whole."""
    if node.type == bulleted:
        return [meaningful(item)[-1] for item in meaningful(node)]
    parent = node.parent
    if symbol(node) != infix or (parent is not None and symbol(parent) == infix):
        return []
    parts = [node]
    while any(symbol(part) == infix for part in parts):
        parts = [p for part in parts for p in (sides(part) if symbol(part) == infix else [part])]
    return parts


def sides(node: Node) -> list[Node]:
    """The two sides of an infix operator."""
    return [operand(node, "lhs"), operand(node, "rhs")]


def conjuncts(node: Node) -> list[Node]:
    """The parts of a conjunction; none for any other node, or for a part of a longer conjunction."""
    return _members(node, "land", "conj_list")


def disjuncts(node: Node) -> list[Node]:
    """The parts of a disjunction; none for any other node, or for a part of a longer disjunction."""
    return _members(node, "lor", "disj_list")
