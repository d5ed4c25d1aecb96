"""The conditions that need a witness: guards and actions of the specification, antecedents of its properties.

| kind | what | where | to be seen |
|---|---|---|---|
| `guard` | a conjunct or disjunct that determines no variable | actions | TRUE and FALSE |
| `condition` | that of an IF | actions, properties | TRUE and FALSE |
| `case` | that of an arm of a CASE, but for OTHER | actions, properties | TRUE |
| `antecedent` | the left side of `=>` | properties | TRUE |
| `filter` | that of a set | properties | TRUE |
| `instance` | the body of a universal quantifier, unless it is an implication | properties | evaluated |
| `action` | what stands last in an action of the next-state relation | System | evaluated |
"""

from __future__ import annotations

import fnmatch
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

from tree_sitter import Node

from evidence.tla.actions import TEMPORAL, Actions, acting, conjuncts, disjuncts
from evidence.tla.marks import Wrapping, by_value, when_evaluated
from evidence.tla.modules import WORDING
from evidence.tla.names import Names
from evidence.tla.syntax import Module, Span, code, meaningful, operand, span, symbol, token, walk

SYSTEM, NEXT = "System", "Next"
"""The module and the definition that say which actions there are."""

PROPERTIES = ("Properties*", "Inductive")
"""Modules with properties."""

TIMES = TEMPORAL | {"always", "eventually", "leads_to"}
"""Formulas of time, which TLC reads and does not evaluate."""

Kind = Literal["guard", "condition", "case", "antecedent", "filter", "instance", "action"]
Side = Literal["TRUE", "FALSE", "evaluated"]

SIDES: Mapping[Kind, tuple[Side, ...]] = {
    "guard": ("TRUE", "FALSE"),
    "condition": ("TRUE", "FALSE"),
    "case": ("TRUE",),
    "antecedent": ("TRUE",),
    "filter": ("TRUE",),
    "instance": ("evaluated",),
    "action": ("evaluated",),
}


@dataclass(frozen=True)
class Condition:
    """Something to be witnessed; it has the marks `number` and `number` + 1."""

    id: str
    module: str
    definition: str
    kind: Kind
    line: int
    text: str
    span: Span
    number: int

    @property
    def sides(self) -> tuple[Side, ...]:
        """The values that have to be seen."""
        return SIDES[self.kind]

    def mark(self, side: Side) -> int:
        """The number of the mark of a side."""
        return self.number + (side == "FALSE")

    @property
    def wrapping(self) -> Wrapping:
        """The marks around it."""
        if self.sides == ("evaluated",):
            return when_evaluated(self.mark("evaluated"))
        return by_value(self.mark("TRUE"), self.mark("FALSE"))


@dataclass(frozen=True)
class _Place:
    """The place of a condition; `shown` is the code for the reader."""

    kind: Kind
    node: Node
    shown: Node


def conditions(modules: Mapping[str, Module]) -> list[Condition]:
    """All conditions of these modules. Raises `SyntaxTreeError`."""
    found: list[Condition] = []
    for name, module in modules.items():
        if any(fnmatch.fnmatchcase(name, pattern) for pattern in WORDING):
            continue
        context = Actions(acting(name, modules))
        names = Names(name)
        for definition, unit in module.definitions.items():
            body = operand(unit, "definition")
            for place in _places(module, definition, body, context):
                node = place.node
                identity = names.give(definition, place.kind, body, node)
                line, text = place.shown.start_point.row + 1, code(place.shown)
                number = 2 * len(found) + 1
                found.append(Condition(identity, name, definition, place.kind, line, text, span(node), number))
    return found


def _places(module: Module, definition: str, body: Node, context: Actions) -> Iterator[_Place]:
    if any(fnmatch.fnmatchcase(module.name, pattern) for pattern in PROPERTIES):
        for node in walk(body):
            if not any(inner.type in TIMES for inner in walk(node)):
                yield from _of_property(node)
                yield from _of_choice(node)
    elif definition in context.acting and not any(node.type in TIMES for node in walk(body)):
        for node in walk(body):
            yield from _of_action(node, context)
            yield from _of_choice(node)
    if (module.name, definition) == (SYSTEM, NEXT):
        yield from _taken(body, module, context)


def _of_choice(node: Node) -> Iterator[_Place]:
    if node.type == "if_then_else":
        condition = operand(node, "if")
        yield _Place("condition", condition, condition)
    elif node.type == "case_arm":
        condition = meaningful(node)[0]
        yield _Place("case", condition, condition)


def _of_action(node: Node, context: Actions) -> Iterator[_Place]:
    for part in conjuncts(node) + disjuncts(node):
        if not context.acts(part) and part.type != "boolean":
            yield _Place("guard", part, part)


def _of_property(node: Node) -> Iterator[_Place]:
    if symbol(node) == "implies":
        left = operand(node, "lhs")
        yield _Place("antecedent", left, left)
    elif node.type == "set_filter":
        condition = operand(node, "filter")
        yield _Place("filter", condition, condition)
    elif node.type == "bounded_quantification" and operand(node, "quantifier").type == "forall":
        said = operand(node, "expression")
        if symbol(said) != "implies":
            yield _Place("instance", said, node)


def _taken(node: Node, module: Module, context: Actions, whole: Node | None = None) -> Iterator[_Place]:
    """The last part of each action of a next-state relation: TLC reaches it if all parts before it are true.

    An action is an expression that is neither a disjunction, nor a quantifier, nor a definition of the module without
    parameters.
    """
    parts = [part for part in conjuncts(node) if context.acts(part)]
    if parts:
        yield from _taken(parts[-1], module, context, node)
    elif alternatives := disjuncts(node):
        for alternative in alternatives:
            yield from _taken(alternative, module, context)
    elif node.type == "parentheses":
        yield from _taken(meaningful(node)[1], module, context, whole)
    elif node.type == "bounded_quantification":
        yield from _taken(operand(node, "expression"), module, context)
    elif node.type == "identifier_ref" and token(node) in module.definitions:
        yield from _taken(operand(module.definitions[token(node)], "definition"), module, context)
    else:
        yield _Place("action", node, whole or node)
