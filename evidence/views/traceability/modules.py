"""TLA+ modules as far as traceability goes: definitions, their comments, and the parts left out.

A comment on a line of its own belongs to the definition (or variable) that follows; an indented one, and one at the
end of a line, to the definition around it. The box at the top of a module speaks of the module; what follows ``Left
out:`` in it names the parts that the module does not treat, and why.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import pairwise
from pathlib import Path

from tree_sitter import Node

from evidence.tla import syntax
from evidence.tla.syntax import COMMENTS, SyntaxTreeError, meaningful, operand, token, walk
from evidence.views.traceability.ids import tagged
from s7check.resources import modules

_AMBIGUITY = re.compile(r'"((?:AMB|A15)-\d+)"')
_LEFT_OUT = re.compile(r"Left out:(.*)", re.DOTALL)
_FRAME = re.compile(r"^\s*(?:\(\*|\\\*)?\s*|\s*(?:\*\))?\s*$")
_BOX_LINE = 2


@dataclass(frozen=True)
class Definition:
    """A definition or a variable.

    Its text stands between the bytes `start` and `end` of the module. `tags` are the IDs in its comments, `readings`
    the ambiguities whose letter it looks up. `words` are the names that it uses, among them ``Instance!Word`` for the
    name that an instance of a module has; `instance_of` is that module where the definition is an instance.
    """

    module: str
    name: str
    line: int
    start: int
    end: int
    tags: tuple[str, ...] = ()
    readings: tuple[str, ...] = ()
    words: frozenset[str] = frozenset()
    instance_of: str = ""


@dataclass(frozen=True)
class Module:
    """A module; `tags` are the IDs in its box, but for `left_out`, which gives the reasons for the others."""

    name: str
    text: bytes
    extends: tuple[str, ...]
    definitions: tuple[Definition, ...]
    tags: tuple[str, ...]
    left_out: dict[str, str]

    def at(self, text: str) -> list[Definition]:
        """The definitions in which the first occurrence of a piece of text stands."""
        sought = text.encode()
        start = self.text.find(sought)
        return [d for d in self.definitions if start >= 0 and d.start < start + len(sought) and start < d.end]


@dataclass
class _Block:
    """Comments that stand below each other; `own_line` if no code stands before them, `column` is where they begin."""

    start: int
    line: int
    last_line: int
    column: int
    own_line: bool
    texts: list[str] = field(default_factory=list)

    @property
    def text(self) -> str:
        return "\n".join(self.texts)


_NO_BOX = _Block(0, 0, 0, 0, own_line=True)


def read_modules(directory: Path) -> list[Module]:
    """Read the modules of a directory. Raises ValueError, also where there are none."""
    paths = modules(directory)
    if not paths:
        raise ValueError(f"{directory}: no module *.tla")
    return [read_module(path) for path in paths]


def read_module(path: Path) -> Module:
    """Read one module. Raises ValueError."""
    try:
        read = syntax.Module(path.stem, path.read_bytes())
        root = read.root
    except OSError as error:
        raise ValueError(f"{path}: {error}") from error
    except SyntaxTreeError as error:
        raise ValueError(f"{path.parent}/{error}") from error
    definitions = _definitions(read)
    header, *others = blocks = _blocks(read.text, root) or [_NO_BOX]
    if header.line != _BOX_LINE:
        header, others = _NO_BOX, blocks
    left_out = _left_out(header.text)
    try:
        tags: dict[Definition, list[str]] = {}
        for block in others:
            owner = _owner(block, definitions, read.text)
            if owner:
                tags.setdefault(owner, []).extend(tagged(block.text))
        own = [tag for tag in tagged(header.text) if tag not in left_out]
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error
    return Module(
        path.stem,
        read.text,
        read.extends,
        tuple(replace(d, tags=tuple(dict.fromkeys(tags.get(d, [])))) for d in definitions),
        tuple(own),
        left_out,
    )


def _definitions(module: syntax.Module) -> list[Definition]:
    named = [(name, unit) for unit in module.units for name in _names(unit)]
    starts = [name.start_byte for name, _ in named]
    return [
        Definition(
            module.name,
            token(name),
            name.start_point.row + 1,
            start,
            end,
            readings=tuple(dict.fromkeys(_readings(unit))),
            words=frozenset(_words(unit)),
            instance_of=_instance(unit),
        )
        for (name, unit), (start, end) in zip(named, pairwise([*starts, len(module.text)]), strict=True)
    ]


def _instance(unit: Node) -> str:
    """The module of which a definition is an instance, or nothing."""
    instances = [node for node in unit.children if node.type == "instance"]
    return next((token(n) for instance in instances for n in instance.children if n.type == "identifier_ref"), "")


def _names(unit: Node) -> list[Node]:
    """The names that a unit of a module defines or declares."""
    if unit.type in ("variable_declaration", "constant_declaration"):
        return [node for node in unit.children if node.type == "identifier"]
    name = unit.child_by_field_name("name")
    return [name] if name is not None and unit.type in _DEFINING else []


_DEFINING = ("operator_definition", "function_definition", "module_definition")


def _words(node: Node) -> Iterator[str]:
    if node.type == "prefixed_op":
        inner = operand(node, "op")
        name, *arguments = [inner] if inner.type == "identifier_ref" else meaningful(inner)
        yield f"{token(operand(node, 'prefix')).rstrip('!')}!{token(name)}"
        for argument in arguments:
            yield from _words(argument)
    elif node.type == "identifier_ref":
        yield token(node)
    else:
        for child in node.children:
            yield from _words(child)


def _readings(unit: Node) -> Iterator[str]:
    """The ambiguities that are the argument of an operator."""
    for node in walk(unit):
        if node.type == "bound_op":
            for argument in node.children:
                if argument.type == "string" and (found := _AMBIGUITY.fullmatch(token(argument))):
                    yield found[1]


def _owner(block: _Block, definitions: list[Definition], text: bytes) -> Definition | None:
    around = next((d for d in reversed(definitions) if d.start < block.start), None)
    following = next((d for d in definitions if d.start > block.start), None)
    if not block.own_line:
        return around
    declared = following is not None and text[text.rfind(b"\n", 0, following.start) + 1 : following.start].isspace()
    return following if block.column == 0 or declared else around


def _left_out(header: str) -> dict[str, str]:
    found: dict[str, str] = {}
    for paragraph in header.split("\n\n"):
        if match := _LEFT_OUT.search(paragraph):
            reason = " ".join(match[1].split())
            found |= dict.fromkeys(tagged(reason), reason)
    return found


def _blocks(text: bytes, root: Node) -> list[_Block]:
    """The comments; comments directly below each other are one block."""
    blocks: list[_Block] = []
    for comment in (node for node in walk(root) if node.type in COMMENTS):
        line, column = comment.start_point.row + 1, comment.start_point.column
        own_line = not text[comment.start_byte - column : comment.start_byte].strip()
        inner = _inner(token(comment))
        before = blocks[-1] if blocks else None
        if before and own_line and before.own_line and before.last_line == line - 1 and before.column == column:
            before.texts.append(inner)
            before.last_line = comment.end_point.row + 1
        else:
            blocks.append(_Block(comment.start_byte, line, comment.end_point.row + 1, column, own_line, [inner]))
    return blocks


def _inner(comment: str) -> str:
    """The words of comments without their frames; the grammar joins comments below each other."""
    lines = [_FRAME.sub("", line) for line in comment.split("\n")]
    return "\n".join("" if set(line) <= set("*") else line for line in lines)
