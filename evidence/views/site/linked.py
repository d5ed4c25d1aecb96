"""TLA+ as HTML: each name leads to its definition, each tag in a comment to its requirement or question."""

from __future__ import annotations

import html
import re
from bisect import bisect_left
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from evidence.tla import syntax
from evidence.tla.syntax import COMMENTS, token, walk
from evidence.views.traceability.modules import Definition, Module
from evidence.views.traceability.roles import extended

TAG = re.compile(r"\b(?:[A-Z]{3,4}|[AT]15)-\d{2,}\b")


@dataclass(frozen=True)
class _Mark:
    """A piece of a module's text, in bytes: a comment, a definition's name, or a use of one (`of`) or of a module."""

    start: int
    end: int
    kind: Literal["comment", "name", "use"]
    of: Definition | None = None


class Linked:
    """The modules of spec/ with links between them.

    `places` has the page of each module; `place_of` gives the place of an ID, empty where there is none.
    """

    def __init__(self, spec: Sequence[Module], places: Mapping[str, str], place_of: Callable[[str], str]) -> None:
        self.places = places
        self._place_of = place_of
        self._trees = {module.name: syntax.Module(module.name, module.text) for module in spec}
        self._seen = {module.name: self._visible(module, spec) for module in spec}
        self._marks = {module.name: list(self._marked(module.name)) for module in spec}

    @staticmethod
    def _visible(module: Module, spec: Sequence[Module]) -> dict[str, Definition]:
        reached = extended({module.name}, spec)
        return {d.name: d for other in spec if other.name in reached for d in other.definitions}

    def place(self, definition: Definition) -> str:
        """The place of a definition in the site."""
        return f"{self.places[definition.module]}#{definition.name}"

    def code(self, module: str, start: int, end: int, to: Callable[[str], str], *, anchors: bool = False) -> str:
        """The text between two bytes of a module; `to` makes the address of a place, `anchors` marks definitions."""
        text = self._trees[module].text
        marks = self._marks[module]
        parts, at = [], start
        for mark in marks[bisect_left(marks, start, key=lambda mark: mark.start) :]:
            if mark.end > end:
                break
            shown = self._shown(mark, text[mark.start : mark.end].decode(), to, anchors=anchors)
            parts += [_escaped(text[at : mark.start].decode()), shown]
            at = mark.end
        return "".join([*parts, _escaped(text[at:end].decode())])

    def definition(self, one: Definition, to: Callable[[str], str]) -> str:
        """The text of an operator; only its name where it is a variable."""
        unit = self._trees[one.module].definitions.get(one.name)
        if unit is None:
            return f'<a href="{to(self.place(one))}">{one.name}</a>'
        return self.code(one.module, unit.start_byte, syntax.end(unit), to)

    def _shown(self, mark: _Mark, text: str, to: Callable[[str], str], *, anchors: bool) -> str:
        if mark.kind == "comment":
            return f'<i class="note">{self._tagged(text, to)}</i>'
        if mark.of is not None:
            return f'<a href="{to(self.place(mark.of))}">{text}</a>'
        if mark.kind == "use":
            return f'<a href="{to(self.places[text])}">{text}</a>'
        return f'<b id="{text}">{text}</b>' if anchors else f"<b>{text}</b>"

    def _marked(self, module: str) -> Iterator[_Mark]:
        seen = self._seen[module]
        named = {d.start for d in seen.values() if d.module == module}
        for node in walk(self._trees[module].root):
            if node.type in COMMENTS:
                yield _Mark(node.start_byte, node.end_byte, "comment")
            elif node.type == "identifier" and node.start_byte in named:
                yield _Mark(node.start_byte, node.end_byte, "name")
            elif node.type == "identifier_ref" and (token(node) in seen or token(node) in self.places):
                yield _Mark(node.start_byte, node.end_byte, "use", seen.get(token(node)))

    def _tagged(self, comment: str, to: Callable[[str], str]) -> str:
        def link(found: re.Match[str]) -> str:
            place = self._place_of(found[0])
            return f'<a href="{to(place)}">{found[0]}</a>' if place else found[0]

        return TAG.sub(link, _escaped(comment))


def with_links(text: str, to: Callable[[str], str]) -> str:
    """A text as HTML, in which IDs are links; `to` makes the address of an ID."""
    return TAG.sub(lambda found: f'<a href="{to(found[0])}">{found[0]}</a>', _escaped(text))


def _escaped(text: str) -> str:
    return html.escape(text, quote=False)
