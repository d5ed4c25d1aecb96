"""The differences that a program meets: docs/rules/differences-s7-1500.txt, whose top has its format."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

import msgspec

from s7check.log.values import instant
from s7check.resources import RULES

FAMILIES = {"S7-1500": "differences-s7-1500.txt"}
"""Family -> the file of RULES with its differences."""

_SAID = {
    "start": ("ob", "flt_id"),
    "stop": ("cause",),
    "restart": ("type",),
    "clock": ("way",),
    "SET_TINT": ("period",),
}
"""Event -> the fields whose values stand behind it, in this order; ``way``: of the clock, ``back`` or ``forward``."""

_HEADING = re.compile(r"== (MD-\d+) (\w+) ([HMLC]) (.*?) -> (.*?)(?: \[(.*)\])?")


class Difference(msgspec.Struct, frozen=True):
    """``area`` and ``trust`` (C: a control, no difference), the requirements ``old`` and ``new``, and in words what
    ``was``, what ``becomes`` of it, what to ``do``.

    ``lines`` are words of lines of an old log by which it is known, such as ``start 80 05``; those that begin with
    ``?`` are hints. ``shown`` is the text of a log that shows it, or ``none`` the reason why none can.
    """

    id: str
    area: str
    trust: str
    old: tuple[str, ...]
    new: tuple[str, ...]
    lines: tuple[str, ...]
    was: str
    becomes: str
    do: str
    shown: str = ""
    none: str = ""

    def fits(self, line: dict[str, Any], hint: bool = False) -> bool:
        """Whether one of its lines is like this one of a log."""
        return any(_fits(words.lstrip("?").split(), line) for words in self.lines if words.startswith("?") == hint)


def _fits(words: Sequence[str], line: dict[str, Any]) -> bool:
    event, *rest = words
    if line.get("event") != event:
        return False
    found = {**line.get("info", {}), **line}
    if event == "clock":
        found["way"] = "back" if instant(line["to"]) < instant(line["at"]) else "forward"
    return all(_is(word, name, found.get(name)) for word, name in zip(rest, _SAID.get(event, ()), strict=False))


def _is(word: str, name: str, value: object) -> bool:
    """Whether a field has the value of the word: a number or a range of OBs, else hexadecimal, or the word itself."""
    if value is None or name in ("type", "way"):
        return value is None or value == word
    if name == "ob":
        first, _, last = word.partition("-")
        return int(first) <= int(str(value)) <= int(last or first)
    text = str(value)
    return (int(text.rpartition("#")[2], 16) if "#" in text else int(text)) == int(word, 16)


@cache
def differences(family: str) -> tuple[Difference, ...]:
    """Those of a family. Raises KeyError, OSError, and ValueError for a text that is not of the format."""
    return tuple(read(RULES / FAMILIES[family]))


def read(file: Path) -> list[Difference]:
    """The differences of a file. Raises OSError and ValueError."""
    found = []
    for block in file.read_text(encoding="utf-8").split("\n== ")[1:]:
        heading, was, becomes, do, *rest = [*block.rstrip().split("\n"), "", "", ""]
        told = _HEADING.fullmatch(f"== {heading}")
        shown = "\n".join(rest).rstrip()
        texts = [text.partition(": ") for text in (was, becomes, do)]
        if told is None or [name for name, _, _ in texts] != ["was", "is", "do"] or not shown:
            raise ValueError(f"{file}: {heading}: expected a heading, was, is, do, and a log or none")
        (_, _, was), (_, _, becomes), (_, _, do) = texts
        found.append(
            Difference(
                id=told[1],
                area=told[2],
                trust=told[3],
                old=tuple(told[4].split()),
                new=tuple(told[5].split()),
                lines=tuple(told[6].split(", ")) if told[6] else (),
                was=was,
                becomes=becomes,
                do=do,
                shown="" if shown.startswith("none: ") else shown,
                none=shown.removeprefix("none: ") if shown.startswith("none: ") else "",
            )
        )
    return found
