"""Reading and editing TLC's configuration files (``.cfg``).

Edits keep everything that they do not change, comments too, so that the text of a derived model differs from its base
by exactly what its entry in the manifest says.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import lru_cache

_SECTIONS = {
    "CONSTANT": "CONSTANT",
    "CONSTANTS": "CONSTANT",
    "INVARIANT": "INVARIANT",
    "INVARIANTS": "INVARIANT",
    "PROPERTY": "PROPERTY",
    "PROPERTIES": "PROPERTY",
    "CONSTRAINT": "CONSTRAINT",
    "CONSTRAINTS": "CONSTRAINT",
    "ACTION_CONSTRAINT": "ACTION_CONSTRAINT",
    "ACTION_CONSTRAINTS": "ACTION_CONSTRAINT",
    **{
        name: name
        for name in (
            "SPECIFICATION",
            "INIT",
            "NEXT",
            "SYMMETRY",
            "VIEW",
            "CHECK_DEADLOCK",
            "ALIAS",
            "POSTCONDITION",
            "TYPE",
            "TYPE_CONSTRAINT",
            "_PERIODIC",
        )
    },
}
_TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|<-|=|[{}\[\],]|[^\s={}\[\],"<(\\]+|[<(\\]')

_OUTSIDE = re.compile(r'"[^"]*"?|\\\*[^\n]*|\(\*')
_NESTED = re.compile(r"\(\*|\*\)")
_VISIBLE = re.compile(r"[^\n]")


class CfgError(ValueError):
    """A configuration file lacks the text that an edit needs; the text names the constant or section."""


@dataclass(frozen=True)
class Assignment:
    """``name operator value`` in a CONSTANT section; `start` and `end` are the text span of operator and value."""

    name: str
    operator: str
    value: str
    start: int
    end: int


@dataclass(frozen=True)
class Section:
    """A section: its keyword in the singular, its names or values, the span of its text, keyword included."""

    keyword: str
    names: tuple[str, ...]
    start: int
    end: int


@dataclass(frozen=True)
class Cfg:
    """A configuration file's text with the places of its parts."""

    text: str
    sections: tuple[Section, ...]
    assignments: tuple[Assignment, ...]

    def names(self, keyword: str) -> tuple[str, ...]:
        """Return all names that stand in sections of this keyword (singular: INVARIANT, PROPERTY, ...)."""
        return tuple(name for s in self.sections if s.keyword == keyword for name in s.names)


@lru_cache(maxsize=1024)
def parse(text: str) -> Cfg:
    """Read a configuration file. Unknown words before the first keyword raise `CfgError`."""
    tokens = list(_TOKEN.finditer(_blank_comments(text)))
    sections: list[Section] = []
    assignments: list[Assignment] = []
    heads = [i for i, token in enumerate(tokens) if token[0] in _SECTIONS]
    if tokens and (not heads or heads[0] != 0):
        raise CfgError(f"{tokens[0][0]!r} stands before the first keyword")
    for head, following in zip(heads, [*heads[1:], len(tokens)], strict=True):
        body = tokens[head + 1 : following]
        keyword = _SECTIONS[tokens[head][0]]
        end = tokens[following - 1].end()
        sections.append(Section(keyword, tuple(t[0] for t in body), tokens[head].start(), end))
        if keyword == "CONSTANT":
            assignments += _assignments(text, body)
    return Cfg(text, tuple(sections), tuple(assignments))


def override(text: str, name: str, value: str) -> str:
    """Return the text with the one assignment of `name` changed.

    `value` is what TLC's grammar allows after the operator and keeps the operator that is there; ``<- Definition`` or
    ``= value`` changes the operator too. ``<- Definition`` also adds the line where `name` is a definition that the
    file does not replace yet. Raises `CfgError` if `name` is not assigned exactly once or already has that value.
    """
    found = [a for a in parse(text).assignments if a.name == name]
    operator, right = _split(value)
    if not found and operator == "<-":
        return f"{text.rstrip()}\nCONSTANT {name} <- {right}\n"
    if len(found) != 1:
        raise CfgError(f"{name} is assigned {len(found)} times, an override needs exactly one")
    old = found[0]
    new = (operator or old.operator, right)
    if new == (old.operator, old.value):
        raise CfgError(f"{name} {old.operator} {old.value} already: the override changes nothing")
    return f"{text[: old.start]}{new[0]} {new[1]}{text[old.end :]}"


def without(text: str, name: str) -> str:
    """Return the text without the one assignment of `name`. Raises `CfgError` if it is not assigned exactly once."""
    found = [a for a in parse(text).assignments if a.name == name]
    if len(found) != 1:
        raise CfgError(f"{name} is assigned {len(found)} times, it is to be left out once")
    section = next(s for s in parse(text).sections if s.start < found[0].start <= s.end)
    alone = sum(section.start < a.start <= section.end for a in parse(text).assignments) == 1
    begin = section.start if alone else text[: found[0].start].rstrip().rindex(name)
    return f"{text[:begin].rstrip()}\n{text[found[0].end :].lstrip()}"


def replace_section(text: str, keyword: str, names: list[str]) -> str:
    """Return the text with all sections of this keyword (singular) replaced by one of these names; none: removed."""
    for section in reversed([s for s in parse(text).sections if s.keyword == keyword]):
        text = text[: section.start] + text[section.end :]
    return f"{text.rstrip()}\n{keyword} {' '.join(names)}\n" if names else text


def replacements(text: str) -> dict[str, str]:
    """Return the definitions that a configuration replaces by others."""
    return {a.name: a.value for a in parse(text).assignments if a.operator == "<-"}


def _split(value: str) -> tuple[str | None, str]:
    for operator in ("<-", "="):
        if value.startswith(operator):
            return operator, value.removeprefix(operator).strip()
    return None, value.strip()


def _assignments(text: str, body: list[re.Match[str]]) -> list[Assignment]:
    starts = [i for i in range(len(body) - 1) if body[i + 1][0] in ("=", "<-")]
    result = []
    for start, following in zip(starts, [*starts[1:], len(body)], strict=True):
        operator, last = body[start + 1], body[following - 1]
        value = text[operator.end() : last.end()].strip()
        result.append(Assignment(body[start][0], operator[0], value, operator.start(), last.end()))
    return result


def _blank_comments(text: str) -> str:
    """Replace comments by spaces, so that positions stay."""
    parts, done, at, depth = [], 0, 0, 0
    while mark := (_NESTED if depth else _OUTSIDE).search(text, at):
        at = mark.end()
        if not depth and mark[0][0] != '"':
            parts.append(text[done : mark.start()])
            done = mark.start()
        depth += {"(*": 1, "*)": -1}.get(mark[0], 0)
        if not depth and mark[0][0] != '"':
            parts.append(_VISIBLE.sub(" ", text[done:at]))
            done = at
    parts.append(_VISIBLE.sub(" ", text[done:]) if depth else text[done:])
    return "".join(parts)
