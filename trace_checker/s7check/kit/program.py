"""A program of the kit: a CPU, start events from outside, and the bodies of its OBs (``s7-interrupt-program/1``).

The engine reads it.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from heapq import merge
from itertools import count
from pathlib import Path
from typing import Any

from s7check.engine import pool
from s7check.log.errors import UnusableLogError

FORMAT = "s7-interrupt-program/1"

OF_S7_1500 = ("zone", "classes", "queue")
"""Fields of a header that an S7-1500 alone has."""

HEADER_FIELDS = ("cpu", "obs", "clock", "mode", "cycle", "priority", "step7", *OF_S7_1500)
"""Fields of a log's header that a program gives; the others are the implementation's own."""


@dataclass(frozen=True)
class Body:
    """The steps of an OB when it is started for the ``run``-th time; ``run`` 0: every time that has no body of its own.

    A step is an object as the file has it: a ``call`` with its operands, a ``wait`` in ms, an ``event`` (``clock`` or
    ``state``) that the program itself brings about, or ``end``.
    """

    ob: int
    run: int
    steps: tuple[dict[str, Any], ...]


@dataclass(frozen=True)
class Program:
    """A program that was read. Values are spelled as in the file, and every one has been checked.

    ``reaches`` are the requirements that decided something when the program was run; empty where that is not known.
    ``header`` has some of ``HEADER_FIELDS``; ``duration`` is in ms; ``outside`` are the events from outside as in the
    file, in the order in which they come: by ``after``, those of one moment in the order of the file. ``plain`` is
    ``raw`` with one spelling for each value: words and TIMEs are integers, dates ``2026-11-21T06:00:00.000``.
    """

    name: str
    about: str
    requirements: tuple[str, ...]
    reaches: tuple[str, ...]
    catches: str
    header: dict[str, Any]
    duration: int
    outside: tuple[dict[str, Any], ...]
    bodies: tuple[Body, ...]
    raw: dict[str, Any]
    plain: dict[str, Any]

    def line(self) -> bytes:
        """The program as one line of JSON, without the end of the line."""
        return _as_line(self.raw)

    def plain_line(self) -> bytes:
        """The same in one spelling: an adapter then has no spellings of S7 to read, nor what the program reaches."""
        return _as_line({name: value for name, value in self.plain.items() if name != "reaches"})


def _as_line(raw: dict[str, Any]) -> bytes:
    return json.dumps(raw, ensure_ascii=False, separators=(",", ":")).encode()


def bodies_of(raw: dict[str, Any]) -> tuple[Body, ...]:
    """The bodies of a program's object."""
    return tuple(Body(body["ob"], body.get("run", 0), tuple(body["steps"])) for body in raw["bodies"])


def _outside(raw: dict[str, Any]) -> list[dict[str, Any]]:
    return sorted(raw.get("outside", []), key=lambda event: int(event["after"]))


def outside_events(program: Program) -> list[tuple[int, dict[str, Any]]]:
    """The events from outside with their times, in ms since the program began, up to its end, in order."""

    def times(event: dict[str, Any], place: int) -> Iterator[tuple[int, int, dict[str, Any]]]:
        for after in count(event["after"], event["every"]) if "every" in event else [event["after"]]:
            if after >= program.duration:
                return
            yield after, place, event

    every = (times(event, place) for place, event in enumerate(program.outside))
    return [(after, event) for after, _, event in merge(*every, key=lambda one: one[:2])]


def read_program(text: bytes | str) -> Program:
    """The program in ``text``, one JSON object on any number of lines.

    Raises EngineError and UnusableLogError: ``field`` is the path of the wrong field, elements of lists by their place
    from 1 (``bodies.1.steps.2.sdt``); ``line`` is set only where the text is no JSON.
    """
    text = text.encode() if isinstance(text, str) else text
    raw = _decoded(text)
    with pool.engine() as engine:
        plain = engine.checked("program", text)
    return Program(
        name=raw["name"],
        about=raw["about"],
        requirements=tuple(raw["requirements"]),
        reaches=tuple(raw.get("reaches", {}).get("requirements", ())),
        catches=raw.get("catches", ""),
        header=raw["header"],
        duration=raw["duration"],
        outside=tuple(_outside(raw)),
        bodies=bodies_of(raw),
        raw=raw,
        plain=plain | {"outside": _outside(plain)},
    )


def _decoded(text: bytes) -> Any:
    """The object; None where the engine says what is wrong. Raises UnusableLogError with the line that is no JSON."""
    try:
        return json.loads(text)
    except json.JSONDecodeError as error:
        found = f"{error.msg[:1].lower()}{error.msg[1:]} at column {error.colno}"
        raise UnusableLogError("a JSON object", found, line=error.lineno) from error
    except (ValueError, RecursionError):
        return None  # not UTF-8 or nested too deep


def read_programs(file: Path) -> Iterator[Program]:
    """The programs of a file: one object, or with the ending ``.ndjson`` one a line, blank lines ignored.

    Raises EngineError, UnusableLogError, with its line in a file of lines, and OSError.
    """
    content = file.read_bytes()
    if file.suffix != ".ndjson":
        yield read_program(content)
        return
    for number, line in enumerate(content.splitlines(), 1):
        if not line.strip():
            continue
        try:
            yield read_program(line)
        except UnusableLogError as error:
            error.line = number
            raise
