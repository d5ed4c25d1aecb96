"""TLA+ modules as far as traceability goes: definitions, the comments that belong to them, and what is left out.

A comment on a line of its own belongs to the definition (or variable) that follows; an indented one, and one at the
end of a line, to the definition around it. The box at the top of a module speaks of the module; what follows ``Left
out:`` in it is what the module does not treat, and why.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import pairwise
from pathlib import Path

from evidence.traceability.errors import UnreadableError
from evidence.traceability.ids import RangeError, tagged

_DEFINITION = re.compile(r"^(?:LOCAL\s+)?(\w+)[ \t]*(?:\([^=]*?\)|\[[^=]*?\])?\s*==(?!=)", re.MULTILINE)
_DECLARATION = re.compile(r"^(?:VARIABLES?|CONSTANTS?)\b((?:.*\n)(?:[ \t].*\n|\n)*)", re.MULTILINE)
_READING = re.compile(r'\b\w+\((?:\w+,\s*)?"(AMB-\d+)"\)')
_MARK = re.compile(r'"(?:\\.|[^"\\\n])*"|\(\*|\*\)|\\\*.*')
_EXTENDS = re.compile(r"^EXTENDS\s+(\w+(?:\s*,\s*\w+)*)", re.MULTILINE)
_INSTANCE = re.compile(r"\bINSTANCE\s+(\w+)")
_WORD = re.compile(r"\w+(?:!\w+)?")
_LEFT_OUT = re.compile(r"Left out:(.*)", re.DOTALL)


@dataclass(frozen=True)
class Definition:
    """A definition or a variable.

    `start` and `end` are where its text stands in the module. `tags` are the IDs in its comments, `readings` the
    ambiguities whose letter it looks up. `words` are the words of its code, among them ``Instance!Word`` for what
    belongs to an instance of a module; `instance_of` is that module where the definition is an instance.
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
    """A module; `tags` are those of its box that it does not leave out, `left_out` says why the others are missing."""

    name: str
    text: str
    extends: tuple[str, ...]
    definitions: tuple[Definition, ...]
    tags: tuple[str, ...]
    left_out: dict[str, str]

    def at(self, text: str) -> list[Definition]:
        """The definitions in which the first occurrence of a piece of text stands."""
        start = self.text.find(text)
        return [d for d in self.definitions if start >= 0 and d.start < start + len(text) and start < d.end]


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


def read_modules(directory: Path, pattern: str = "*.tla") -> list[Module]:
    """Read the modules of a directory. Raises `UnreadableError`, also where there are none."""
    paths = sorted(directory.glob(pattern))
    if not paths:
        raise UnreadableError(f"{directory}: no module {pattern}")
    return [read_module(path) for path in paths]


def read_module(path: Path) -> Module:
    """Read one module. Raises `UnreadableError`."""
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise UnreadableError(f"{path}: {error}") from error
    if "MODULE" not in text:
        raise UnreadableError(f"{path}: no module")
    code, blocks = _comments(text)
    definitions = _definitions(path.stem, code)
    header, *others = blocks or [_Block(0, 0, 0, 0, own_line=True)]
    if header.line != 2:
        others = blocks
        header = _Block(0, 0, 0, 0, own_line=True)
    left_out = _left_out(header.text)
    try:
        tags: dict[Definition, list[str]] = {}
        for block in others:
            owner = _owner(block, definitions, code)
            if owner:
                tags.setdefault(owner, []).extend(tagged(block.text))
        own = [tag for tag in tagged(header.text) if tag not in left_out]
    except RangeError as error:
        raise UnreadableError(f"{path}: {error}") from error
    return Module(
        path.stem,
        text,
        tuple(re.findall(r"\w+", "".join(_EXTENDS.findall(code)))),
        tuple(replace(d, tags=tuple(dict.fromkeys(tags.get(d, [])))) for d in definitions),
        tuple(own),
        left_out,
    )


def _definitions(module: str, code: str) -> list[Definition]:
    starts = {match.start(): match[1] for match in _DEFINITION.finditer(code)}
    for block in _DECLARATION.finditer(code):
        starts |= {block.start(1) + name.start(): name[0] for name in re.finditer(r"\b[A-Za-z]\w*", block[1])}
    return [
        Definition(
            module,
            starts[start],
            code.count("\n", 0, start) + 1,
            start,
            end,
            readings=tuple(dict.fromkeys(_READING.findall(code, start, end))),
            words=frozenset(_WORD.findall(code, start, end)),
            instance_of="".join(_INSTANCE.findall(code, start, end)[:1]),
        )
        for start, end in pairwise([*sorted(starts), len(code)])
    ]


def _owner(block: _Block, definitions: list[Definition], code: str) -> Definition | None:
    around = next((d for d in reversed(definitions) if d.start < block.start), None)
    following = next((d for d in definitions if d.start > block.start), None)
    if not block.own_line:
        return around
    declared = following is not None and code[code.rfind("\n", 0, following.start) + 1 : following.start].isspace()
    return following if block.column == 0 or declared else around


def _left_out(header: str) -> dict[str, str]:
    found: dict[str, str] = {}
    for paragraph in header.split("\n\n"):
        if match := _LEFT_OUT.search(paragraph):
            reason = " ".join(match[1].split())
            found |= dict.fromkeys(tagged(reason), reason)
    return found


def _comments(text: str) -> tuple[str, list[_Block]]:
    """The text with spaces for its comments, and the comments."""
    code = list(text)
    blocks: list[_Block] = []
    for start, end in _spans(text):
        for index in range(start, end):
            if text[index] != "\n":
                code[index] = " "
        begin = text.rfind("\n", 0, start) + 1
        line = text.count("\n", 0, start) + 1
        last_line = line + text.count("\n", start, end)
        own_line = not "".join(code[begin:start]).strip()
        inner = _inner(text[start:end])
        before = blocks[-1] if blocks else None
        if before and own_line and before.own_line and before.last_line == line - 1 and before.column == start - begin:
            before.texts.append(inner)
            before.last_line = last_line
        else:
            blocks.append(_Block(start, line, last_line, start - begin, own_line, [inner]))
    return "".join(code), blocks


def _inner(comment: str) -> str:
    """What a comment says, without its frame."""
    said = comment.removeprefix("\\*") if comment.startswith("\\*") else comment[2:-2]
    return "\n".join("" if set(line) <= set("*") else line for line in map(str.strip, said.split("\n")))


def _spans(text: str) -> Iterator[tuple[int, int]]:
    """Where the comments begin and end; those between ``(*`` and ``*)`` may be nested."""
    depth = start = 0
    for mark in _MARK.finditer(text):
        if mark[0] == "(*":
            start = start if depth else mark.start()
            depth += 1
        elif mark[0] == "*)" and depth:
            depth -= 1
            if not depth:
                yield start, mark.end()
        elif mark[0].startswith("\\*") and not depth:
            yield mark.span()
