"""Values as TLC prints them, as Python's.

A record or a function is a dict, a set or a tuple is a list, TRUE and FALSE are bool. TLC prints the elements of a
set in one order, so equal sets are equal lists.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

_TOKEN = re.compile(r'\s*("(?:[^"\\]|\\.)*"|-?\d+|\w+|\|->|:>|@@|<<|>>|\.\.|[\[\]{}(),])')


class UnreadableValueError(ValueError):
    """The text is not a value that TLC prints; the message has the place."""


def value(text: str) -> Any:
    """Read one value. Raises `UnreadableValueError`."""
    tokens = _Tokens(text)
    read = _value(tokens)
    tokens.end()
    return read


def assignments(text: str) -> dict[str, Any]:
    r"""Read a state as TLC prints it: ``/\ name = value`` for each variable, or one ``name = value``."""
    read: dict[str, Any] = {}
    for part in re.split(r"^/\\ ", text, flags=re.MULTILINE):
        name, equals, rest = part.partition(" = ")
        if equals:
            read[name.strip()] = value(rest)
    return read


class _Tokens:
    def __init__(self, text: str) -> None:
        self._text = text
        self._found = list(self._scan(text))
        self._next = 0

    def _scan(self, text: str) -> Iterator[str]:
        at = 0
        while text[at:].strip():
            found = _TOKEN.match(text, at)
            if found is None:
                raise UnreadableValueError(f"not a value at character {at}: {text[at : at + 40]!r}")
            yield found[1]
            at = found.end()

    def peek(self) -> str:
        return self._found[self._next] if self._next < len(self._found) else ""

    def take(self) -> str:
        token = self.peek()
        self._next += 1
        return token

    def expect(self, token: str) -> None:
        if (found := self.take()) != token:
            raise UnreadableValueError(f"expected {token}, found {found or 'the end'}: {self._text[:60]!r}")

    def end(self) -> None:
        if self.peek():
            raise UnreadableValueError(f"expected the end, found {self.peek()}: {self._text[:60]!r}")


def _value(tokens: _Tokens) -> Any:
    found = tokens.take()
    if found == "<<":
        return _listed(tokens, ">>")
    if found == "{":
        return _listed(tokens, "}")
    if found == "[":
        return _record(tokens)
    if found == "(":
        return _function(tokens)
    if found in ("TRUE", "FALSE"):
        return found == "TRUE"
    if found.startswith('"'):
        return found[1:-1]
    if re.fullmatch(r"-?\d+", found):
        number = int(found)
        if tokens.peek() != "..":
            return number
        tokens.take()
        return list(range(number, int(tokens.take()) + 1))
    raise UnreadableValueError(f"no value begins with {found or 'the end'}")


def _listed(tokens: _Tokens, closing: str) -> list[Any]:
    found: list[Any] = []
    while tokens.peek() != closing:
        found.append(_value(tokens))
        if tokens.peek() == ",":
            tokens.take()
    tokens.take()
    return found


def _record(tokens: _Tokens) -> dict[str, Any]:
    found: dict[str, Any] = {}
    while tokens.peek() != "]":
        name = tokens.take()
        tokens.expect("|->")
        found[name] = _value(tokens)
        if tokens.peek() == ",":
            tokens.take()
    tokens.take()
    return found


def _function(tokens: _Tokens) -> dict[Any, Any]:
    found: dict[Any, Any] = {}
    while True:
        argument = _value(tokens)
        tokens.expect(":>")
        found[argument] = _value(tokens)
        if tokens.take() == ")":
            return found
