"""TLA+ modules as syntax trees, and replacing a piece of a module.

Columns carry meaning in TLA+: the bullets of a list of conjuncts stand below each other. A replacement therefore
leaves every token that it keeps in its column, on a line of its own where the new text has taken its place.
"""

from __future__ import annotations

import warnings
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import tree_sitter_tlaplus
from tree_sitter import Language, Node, Parser

COMMENTS = frozenset({"comment", "block_comment"})

with warnings.catch_warnings():
    # The grammar's package hands its language over as a number, which the binding still takes but frowns upon.
    warnings.simplefilter("ignore", DeprecationWarning)
    _PARSER = Parser(Language(tree_sitter_tlaplus.language()))


class SyntaxTreeError(ValueError):
    """A module that the grammar cannot read; the text names it and the line."""


@dataclass(frozen=True)
class At:
    """New text that stands where `node` stood."""

    node: Node
    text: str


Span = tuple[int, int]
"""From which byte to before which byte of a module an expression stands."""

Piece = str | Node | At
"""A part of a replacement: new text behind the part before it, a node that is kept, new text in a node's place."""


@dataclass(frozen=True)
class Module:
    """A module's name, text and tree."""

    name: str
    text: bytes

    @cached_property
    def _tree(self) -> Node:
        return _PARSER.parse(self.text).root_node

    @property
    def root(self) -> Node:
        """The tree. Raises `SyntaxTreeError`."""
        root = self._tree
        if root.has_error:
            line = next(n.start_point.row + 1 for n in walk(root) if n.is_error or n.is_missing)
            raise SyntaxTreeError(f"{self.name}.tla:{line}: the grammar cannot read this")
        return root

    @cached_property
    def units(self) -> list[Node]:
        """The units of the module: definitions, declarations and so on, without LOCAL."""
        units = [unit for module in self.root.children if module.type == "module" for unit in module.children]
        return [unit.children[-1] if unit.type == "local_definition" else unit for unit in units]

    @cached_property
    def definitions(self) -> dict[str, Node]:
        """The definitions of the module itself, without definitions inside of LET."""
        found = {}
        for unit in self.units:
            name = unit.child_by_field_name("name")
            if unit.type in ("operator_definition", "function_definition") and name is not None:
                found[token(name)] = unit
        return found

    @cached_property
    def extends(self) -> tuple[str, ...]:
        """The modules that it extends."""
        return tuple(
            token(n) for u in self.units if u.type == "extends" for n in u.children if n.type == "identifier_ref"
        )

    @cached_property
    def imports(self) -> frozenset[str]:
        """The modules that it extends or makes an instance of."""
        importing = [n for n in walk(self.root) if n.type in ("extends", "instance")]
        return frozenset(token(n) for unit in importing for n in unit.children if n.type == "identifier_ref")

    @cached_property
    def code(self) -> str:
        """The text without comments and layout: only this part decides the result of a check."""
        return code(self._tree)

    def replaced(self, node: Node, pieces: Sequence[Piece]) -> bytes:
        """Return the text with `node` replaced."""
        out = bytearray(self.text[: node.start_byte])
        for piece in pieces:
            if isinstance(piece, str):
                out += piece.encode()
            elif isinstance(piece, At):
                place(out, self.text, piece.node.start_byte)
                out += piece.text.encode()
            else:
                place(out, self.text, piece.start_byte)
                out += self.text[piece.start_byte : end(piece)]
        rest = end(node)
        line = self.text[rest : (self.text.find(b"\n", rest) + 1) or None]
        if line.strip():
            place(out, self.text, rest)
        return bytes(out) + self.text[rest:]

    def wrapped(self, around: Mapping[Span, tuple[str, str]]) -> bytes:
        """Return the text with something before and after each of these expressions; they may be nested."""
        opening: defaultdict[int, list[str]] = defaultdict(list)
        closing: defaultdict[int, list[str]] = defaultdict(list)
        for (first, last), (before, after) in sorted(around.items(), key=lambda item: (item[0][0], -item[0][1])):
            opening[first].append(before)
            closing[last].insert(0, after)
        out = bytearray()
        at = 0
        for leaf in leaves(self.root):
            out += b"\n" * self.text.count(b"\n", at, leaf.start_byte)
            for text in opening[leaf.start_byte]:
                place(out, self.text, leaf.start_byte)
                out += text.encode()
            place(out, self.text, leaf.start_byte)
            at = leaf.end_byte
            out += self.text[leaf.start_byte : at]
            out += "".join(closing[at]).encode()
        return bytes(out) + b"\n"


@lru_cache(maxsize=32)
def read_text(text: str) -> Module:
    """The module that this text is, called flat. Many queries share most of their texts, so the trees are kept."""
    return Module("flat", text.encode())


def place(out: bytearray, text: bytes, byte: int) -> None:
    """Bring `out` to the column that this byte has in the text."""
    column = _column(text, byte)
    here = _column(out, len(out))
    out += b" " * (column - here) if here <= column else b"\n" + b" " * column


def _column(text: bytes | bytearray, byte: int) -> int:
    return len(text[text.rfind(b"\n", 0, byte) + 1 : byte].decode())


def walk(node: Node) -> Iterator[Node]:
    """The node and everything below it, in the order of the text."""
    yield node
    for child in node.children:
        yield from walk(child)


def end(node: Node) -> int:
    """Where a node's last token ends; the grammar counts the comments that follow a list to it."""
    children = [child for child in node.children if child.type not in COMMENTS]
    return end(children[-1]) if children else node.end_byte


def token(node: Node) -> str:
    """The text of a node."""
    return (node.text or b"").decode()


def code(node: Node) -> str:
    """The tokens of a node with a space between them."""
    return " ".join(token(leaf) for leaf in leaves(node) if leaf.type not in COMMENTS)


def leaves(node: Node) -> Iterator[Node]:
    """The tokens of a node, comments among them."""
    if node.type in COMMENTS or node.type == "string" or not node.children:
        yield node
    else:
        for child in node.children:
            yield from leaves(child)


def span(node: Node) -> Span:
    """Where an expression stands, without the comments behind it."""
    return node.start_byte, end(node)


def references(node: Node) -> frozenset[str]:
    """The names that are used in a node, but names of an instance, such as Next in ``Lock!Next``."""
    return frozenset(token(n) for n in walk(node) if n.type == "identifier_ref" and not is_of_instance(n))


def is_of_instance(name: Node) -> bool:
    """Whether the name is that of an operator of an instance, such as Next in ``Lock!Next``."""
    whole = name.parent
    if whole is not None and whole.type == "bound_op" and whole.children[0] == name:
        name, whole = whole, whole.parent
    return whole is not None and whole.type == "prefixed_op" and whole.children[-1] == name


def operand(node: Node, field: str) -> Node:
    """The child that the grammar gives this name."""
    child = node.child_by_field_name(field)
    assert child is not None, f"{node.type} has no {field}"
    return child


def symbol(node: Node) -> str:
    """The kind of an infix, prefix or postfix operator; of any other node nothing."""
    if node.type not in ("bound_infix_op", "bound_prefix_op", "bound_postfix_op"):
        return ""
    return operand(node, "symbol").type


def meaningful(node: Node) -> list[Node]:
    """The children that are no comments."""
    return [child for child in node.children if child.type not in COMMENTS]
