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

from evidence.tla.modules import reached
from evidence.tla.syntax import Module, SyntaxTreeError, end, references

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
class _Part:
    """The text of a module between its first and its last line, and the number of its first line."""

    text: str
    line: int
    extends: tuple[str, ...]


def flatten(top: str, folders: Sequence[Path]) -> Flat:
    """Return the module `top` with all that it extends; a module in none of the folders is left to the tool.

    The definitions stand there as they are, in the order in which the tool reads them. Raises `SyntaxTreeError` for
    a module that the grammar cannot read, and if `top` is not there.
    """
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
    extends = f"EXTENDS {', '.join(standard)}" if standard else ""
    lines, places = [f"---- MODULE {top} ----", extends], [(top, 1), (top, 1)]
    for name, part in parts.items():
        own = part.text.split("\n")
        lines += own
        places += [(name, part.line + number) for number in range(len(own))]
    return Flat(top, "\n".join([*lines, "====\n"]), (*places, (top, 1)))


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
    return _Part(body.decode(), first.end_point.row + 1, module.extends)


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
