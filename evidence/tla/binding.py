"""Arguments of which an operator makes copies, bound by LET where the operator is applied.

Apalache puts the text of an argument in each place where the parameter stands. Where an argument holds another
application, and that one more, the text grows with each: that of SET_TINT has 440,000 tokens, and 6,000 with LET. What
a LET defines without parameters stays one text, and is one value for the solver. In TLA+ both mean the same.
"""

from __future__ import annotations

from collections.abc import Mapping

from tree_sitter import Node

from evidence.tla.syntax import (
    COMMENTS,
    is_of_instance,
    meaningful,
    operand,
    place,
    read_text,
    references,
    symbol,
    token,
)

_EACH = frozenset({"bounded_quantification", "choose", "set_filter", "set_map", "function_literal"})
"""What looks at an expression for each element of a set."""
_PLAIN = frozenset({"identifier_ref", "nat_number", "string", "boolean", "lambda"})
"""Arguments of which a copy costs nothing, or which no LET without parameters can define."""
_MANY = 2

_Scope = Mapping[str, "_Operator"]


class _Operator:
    """A definition: how many copies its body makes of each argument, if it primes it, and if it is an action.

    What it primes is not bound: Apalache would not put the prime on what LET defines.
    """

    def __init__(self, definition: Node, outside: _Scope) -> None:
        names, body = _parameters(definition), operand(definition, "definition")
        self.copies = [_copies(body, name, outside) for name in names]
        self.primes = [_is_primed(body, name, outside) for name in names]
        self.assigns = _assigns(body, outside)

    def binds(self, number: int, argument: Node) -> bool:
        """Whether this argument, counted from 0, is bound."""
        return self.copies[number] == _MANY and not self.primes[number] and not _is_plain(argument)


def bind_arguments(text: str) -> str:
    """The text of a module, in which LET binds each argument of which an operator makes copies.

    Names, numbers and strings stay, with or without a prime. Raises `evidence.tla.syntax.SyntaxTreeError`.
    """
    module = read_text(text)
    scope: dict[str, _Operator] = {}
    writer = _Writer(module.text)
    for child in module.root.children:
        for unit in child.children:
            writer.write(unit, scope)
            _add(unit, scope)
    return writer.out.decode() + "\n"


def _add(definition: Node, scope: dict[str, _Operator]) -> None:
    if definition.type == "operator_definition":
        scope[token(operand(definition, "name"))] = _Operator(definition, scope)


def _within(node: Node, scope: _Scope) -> _Scope:
    """The scope of what stands in the node: a LET adds the operators that it defines."""
    if node.type != "let_in":
        return scope
    inside = dict(scope)
    for definition in node.children_by_field_name("definitions"):
        _add(definition, inside)
    return inside


def _parameters(definition: Node) -> list[str]:
    """The names of a definition's parameters; of those that are operators, too."""
    named = definition.children_by_field_name("parameter")
    return [
        token(operand(child, "name") if child.type == "operator_declaration" else child)
        for child in named
        if child.type in ("identifier", "operator_declaration")
    ]


def _called(node: Node, scope: _Scope) -> _Operator | None:
    """The operator that the node applies, if it is known: a parameter is not, nor an operator of an instance."""
    if node.type not in ("identifier_ref", "bound_op"):
        return None
    name = operand(node, "name") if node.type == "bound_op" else node
    return None if is_of_instance(name) else scope.get(token(name))


def _arguments(call: Node) -> list[Node]:
    return [n for n in call.children_by_field_name("parameter") if n.type not in COMMENTS | {"(", ",", ")"}]


def _is_plain(argument: Node) -> bool:
    return argument.type in _PLAIN or (symbol(argument) == "prime" and _is_plain(operand(argument, "lhs")))


def _is_primed(node: Node, parameter: str, scope: _Scope) -> bool:
    """Whether the node puts a prime on the parameter, or an operator that it is passed to does."""
    scope = _within(node, scope)
    if symbol(node) == "prime":
        return parameter in references(node)
    called = _called(node, scope)
    primes = called.primes if called else []
    passed = (argument for argument, primed in zip(_arguments(node), primes, strict=False) if primed)
    return any(parameter in references(argument) for argument in passed) or any(
        _is_primed(child, parameter, scope) for child in node.children
    )


def _assigns(node: Node, scope: _Scope) -> bool:
    """Whether the node says what the next value of a variable is, or an operator that it applies does."""
    called = _called(node, scope)
    if symbol(node) == "unchanged" or (called is not None and called.assigns):
        return True
    if symbol(node) in ("eq", "in") and symbol(operand(node, "lhs")) == "prime":
        return True
    return any(_assigns(child, scope) for child in node.children)


def _copies(node: Node, parameter: str, scope: _Scope) -> int:
    """How many copies the node makes of the parameter's argument: 0, 1, or `_MANY` for more."""
    if node.type == "identifier_ref":
        return int(token(node) == parameter)
    scope = _within(node, scope)
    if node.type == "bound_op":
        called = _called(node, scope)
        passed = (_copies(a, parameter, scope) * _made(called, n, a) for n, a in enumerate(_arguments(node)))
        return min(_MANY, sum(passed))
    found = (_copies(child, parameter, scope) * _times(node, child) for child in node.children)
    return min(_MANY, sum(found))


def _made(called: _Operator | None, number: int, argument: Node) -> int:
    """How many copies of its argument an application makes; it may be any number where the operator is not known."""
    if called is None:
        return _MANY
    return 1 if called.binds(number, argument) else called.copies[number]


def _times(node: Node, child: Node) -> int:
    """How often the child of a node is written: many times for the elements of a set and in an operator of a LET."""
    each = node.type in _EACH and child.type != "quantifier_bound"
    return _MANY if each or _parameters(child) else 1


class _Writer:
    """Writes nodes anew. Each token stays in its column, since columns carry meaning."""

    def __init__(self, text: bytes) -> None:
        self._text = text
        self.out = bytearray()
        self._at = 0
        self._bound = 0

    def write(self, node: Node, scope: _Scope) -> None:
        """Write the node, with LET where it applies operators of the scope."""
        if node.parent is not None and node.parent.type == "module":
            self._bound = 0
        scope = _within(node, scope)
        called = _called(node, scope)
        bound = [a for n, a in enumerate(_arguments(node)) if called.binds(n, a)] if called else []
        if called and bound:
            self._write_bound(node, bound, scope, action=called.assigns)
        elif not node.children or node.type in COMMENTS or node.type == "string":
            self._write_token(node)
        else:
            for child in node.children:
                self.write(child, scope)

    def _write_token(self, leaf: Node) -> None:
        self.out += b"\n" * self._text.count(b"\n", self._at, leaf.start_byte)
        place(self.out, self._text, leaf.start_byte)
        self._at = leaf.end_byte
        self.out += self._text[leaf.start_byte : self._at]

    def _write_bound(self, call: Node, bound: list[Node], scope: _Scope, *, action: bool) -> None:
        """Write LET, or around an action a quantifier: Apalache sees FALSE in an action behind a quantifier alone."""
        names = {}
        place(self.out, self._text, call.start_byte)
        self.out += b"("
        for argument in bound:
            self._bound += 1
            names[argument] = f"bound_{self._bound}"
            before, after = ("\\E {} \\in {{", "} :") if action else ("LET {} == (", ") IN")
            self.out += before.format(names[argument]).encode()
            self.write(argument, scope)
            self.out += b"\n" * (b"\\*" in self.out[self.out.rfind(b"\n") + 1 :]) + after.encode()
            place(self.out, self._text, call.start_byte)
        for child in meaningful(call):
            if child in names:
                self.out += f" {names[child]}".encode()
            else:
                self.write(child, scope)
        self.out += b")"
        self._at = call.end_byte
