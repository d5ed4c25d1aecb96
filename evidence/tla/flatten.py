"""A module and all that it extends as one module.

TLC looks at every definition once for each module in which it can be seen; a model that extends fifty modules takes
most of a short run for that. Apalache's type check takes half as long again where it follows EXTENDS itself.

usage: python -m evidence.tla.flatten [--only NAME,...] MODULE FOLDER...
(writes the module to standard output; the folders are searched in turn; NAMEs are operators, which are kept with all
that they use)
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from tree_sitter import Node

from evidence.tla.modules import reached
from evidence.tla.syntax import COMMENTS, Module, SyntaxTreeError, end, references, token

_LOCATION = re.compile(r"\bline (\d+), col (\d+) to line (\d+), col (\d+) of module (\w+)")


@dataclass(frozen=True)
class Flat:
    """The text of the one module, and for each of its lines the module and the line from which it comes."""

    name: str
    text: str
    places: tuple[tuple[str, int], ...]

    def located(self, message: str) -> str:
        """The message of a tool with the places of the modules themselves."""

        def locate(found: re.Match[str]) -> str:
            first, last = int(found[1]), int(found[3])
            if found[5] != self.name or not 0 < first <= last <= len(self.places):
                return found[0]
            module, line = self.places[first - 1]
            return f"line {line}, col {found[2]} to line {line + last - first}, col {found[4]} of module {module}"

        return _LOCATION.sub(locate, message)


@dataclass(frozen=True)
class _Unit:
    """A definition or declaration: its names, the names that it uses, its first line in a part and that behind it."""

    variable: bool
    names: frozenset[str]
    uses: frozenset[str]
    first: int
    behind: int


@dataclass(frozen=True)
class _Part:
    """The text of a module between its first and its last line, and the number of its first line.

    `units` is None if there are others than definitions and declarations, or two stand in a line.
    """

    text: str
    line: int
    extends: tuple[str, ...]
    units: tuple[_Unit, ...] | None


def flatten(top: str, folders: Sequence[Path]) -> Flat:
    """Return the module `top` with all that it extends; a module in none of the folders is left to the tool.

    The definitions stand there as they are, in the order in which the tool reads them. Raises `SyntaxTreeError` for
    a module that the grammar cannot read, and if `top` is not there.
    """
    parts, standard = _read(top, folders)
    lines: list[_Line] = []
    for name, part in parts.items():
        lines += [(text, name, part.line + number) for number, text in enumerate(part.text.split("\n"))]
    return _flat(top, standard, lines)


def split(top: str, folders: Sequence[Path]) -> tuple[Flat, ...]:
    """The same as three modules, `top` the first of them; none if there are units that it does not know.

    To find out what it can evaluate before it starts, TLC 2.18 follows each definition without parameters through all
    that it uses, each time anew: a second of CPU for a next-state relation. It leaves out those of a module with
    variables that has an instance. Such a module holds what depends on variables here, another all else.
    """
    parts, standard = _read(top, folders)
    rules, constants = f"{top}Rules", f"{top}Constants"
    known = _without_variables(parts)
    if known is None:
        return ()
    sorted_: dict[bool, list[_Line]] = {True: [], False: []}
    for name, part in parts.items():
        own = part.text.split("\n")
        for unit in part.units or ():
            where = sorted_[unit in known]
            where += [(own[number], name, part.line + number) for number in range(unit.first, unit.behind)]
    instance = [(f"{rules}Instance(unused) == INSTANCE {rules}", top, 1)]
    return (
        _flat(top, [rules], instance),
        _flat(rules, [constants], sorted_[False]),
        _flat(constants, standard, sorted_[True]),
    )


def _without_variables(parts: dict[str, _Part]) -> set[_Unit] | None:
    """The units that use no variable, directly or not; None if there are units of other kinds."""
    found: set[_Unit] = set()
    depending: set[str] = set()
    for part in parts.values():
        if part.units is None:
            return None
        for unit in part.units:
            if unit.variable or unit.uses & depending:
                depending |= unit.names
            else:
                found.add(unit)
    return found


_Line = tuple[str, str, int]
"""A line's text, and the module and the line from which it comes."""


def _flat(name: str, extends: Sequence[str], lines: Sequence[_Line]) -> Flat:
    head = [(f"---- MODULE {name} ----", name, 1), (f"EXTENDS {', '.join(extends)}" if extends else "", name, 1)]
    whole = [*head, *lines, ("====\n", name, 1)]
    return Flat(name, "\n".join(text for text, _, _ in whole), tuple((module, line) for _, module, line in whole))


def _read(top: str, folders: Sequence[Path]) -> tuple[dict[str, _Part], list[str]]:
    """The modules in the order in which the tool reads them, and the names of those that are in no folder."""
    parts: dict[str, _Part] = {}
    standard: list[str] = []
    seen: set[str] = set()

    def add(name: str) -> None:
        if name in seen:
            return
        seen.add(name)
        path = next((p for p in (folder / f"{name}.tla" for folder in folders) if p.is_file()), None)
        if path is None:
            standard.append(name)
            return
        part = _part(name, path.read_bytes())
        for extended in part.extends:
            add(extended)
        parts[name] = part

    add(top)
    if top in standard:
        raise SyntaxTreeError(f"{top}.tla: no such module in {', '.join(map(str, folders))}")
    return parts, standard


@lru_cache(maxsize=256)
def _part(name: str, text: bytes) -> _Part:
    """Read a module. Many runs share most of their modules, so the parts are kept."""
    module = Module(name, text)
    node = next((child for child in module.root.children if child.type == "module"), None)
    if node is None:
        raise SyntaxTreeError(f"{name}.tla: there is no module")
    dashes = [child for child in node.children if child.type == "header_line"]
    first, last = dashes[-1], node.children[-1]
    body = text[first.end_byte : last.start_byte]
    for unit in module.units:
        if unit.type == "extends":
            start, stop = unit.start_byte - first.end_byte, end(unit) - first.end_byte
            body = body[:start] + b"\n" * body.count(b"\n", start, stop) + body[stop:]
    return _Part(body.decode(), first.end_point.row + 1, module.extends, _units(module, node, first.end_point.row))


_AROUND = frozenset({"MODULE", "identifier", "header_line", "extends", "single_line", "double_line", *COMMENTS})


def _units(module: Module, node: Node, top: int) -> tuple[_Unit, ...] | None:
    """The units of a module whose text begins in line `top` from 0."""
    found: list[_Unit] = []
    for unit in (child for child in node.children if child.type not in _AROUND):
        variable = unit.type == "variable_declaration"
        if not variable and unit.type not in ("operator_definition", "function_definition", "constant_declaration"):
            return None
        name = unit.child_by_field_name("name")
        names = [token(name)] if name else [token(child) for child in unit.children if child.type == "identifier"]
        first = unit.start_point.row - top
        behind = module.text.count(b"\n", 0, end(unit)) - top + 1
        if found and first < found[-1].behind:
            return None
        found.append(_Unit(variable, frozenset(names), references(unit), first, behind))
    return tuple(found)


def keep_only(flat: Flat, names: Iterable[str]) -> str:
    """The module's text without the definitions that the names do not need, and without their types.

    An instance of a module stays, with the definitions that are put in the places of its parameters.
    """
    module = Module(flat.name, flat.text.encode())
    instances = {name for unit in module.units if unit.type == "module_definition" for name in references(unit)}
    needed = reached({*names, *instances}, {name: references(unit) for name, unit in module.definitions.items()})
    out, at = bytearray(), 0
    for name, unit in module.definitions.items():
        if name not in needed:
            out += module.text[at : _types(module.text, unit.start_byte)]
            at = end(unit)
    return (bytes(out) + module.text[at:]).decode()


def definition_span(module: Module, name: str) -> tuple[int, int]:
    """Where the definition of an operator begins and ends in the module's text, with its type."""
    unit = module.definitions[name]
    return _types(module.text, unit.start_byte), end(unit) + 1


def _types(text: bytes, byte: int) -> int:
    """Where the line comments begin that stand directly above this byte: Apalache reads types there."""
    while text[:byte].endswith(b"\n") and text[(above := text.rfind(b"\n", 0, byte - 1) + 1) : byte].startswith(b"\\*"):
        byte = above
    return byte


def main(arguments: list[str]) -> None:
    """Write the module that the command line asks for."""
    only = None
    if arguments[:1] == ["--only"] and len(arguments) > 1:
        only, arguments = arguments[1].split(","), arguments[2:]
    if len(arguments) < 2:
        sys.exit(__doc__)
    try:
        flat = flatten(arguments[0], [Path(folder) for folder in arguments[1:]])
    except SyntaxTreeError as error:
        sys.exit(f"flatten: {error}")
    sys.stdout.write(flat.text if only is None else keep_only(flat, only))


if __name__ == "__main__":
    main(sys.argv[1:])
