"""A program of the kit: a CPU, start events from outside, and the bodies of its OBs (``s7-interrupt-program/1``)."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from s7check.log import header as log_header
from s7check.log import tables
from s7check.log.errors import UnusableLogError, quote
from s7check.log.events import FIELDS, OPERANDS, check_fault
from s7check.log.fields import OWN, Fields, Reader, list_of
from s7check.log.jsonline import decode_object
from s7check.log.values import byte, choice, date_components, duration, instant_moment, integer, word

FORMAT = "s7-interrupt-program/1"

HEADER_FIELDS = ("cpu", "obs", "clock", "mode", "cycle", "priority", "step7")
"""Fields of a log's header that a program gives; the others are the implementation's own."""

_LONGEST = 100 * 366 * 86_400_000
"""Milliseconds: the years that the CPU clock can show."""

_elapsed = integer(0, _LONGEST)
_span = integer(1, _LONGEST)
_jump = integer(-_LONGEST, _LONGEST)
_ob = integer(tables.OB_NUMBERS.start, tables.OB_NUMBERS.stop - 1)

_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,99}")
_REQUIREMENT = re.compile(r"[A-Z]{2,5}-[0-9]{2}")


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
    file, in the order in which they come: by ``after``, those of one moment in the order of the file.
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

    def log_header(self, **own: object) -> dict[str, Any]:
        """The header of this program's log, normalised; ``own`` are the implementation's fields, as ``latency_ms``."""
        return log_header.read_header({"format": log_header.FORMAT, **self.header, **own})

    def line(self) -> bytes:
        """The program as one line of JSON, without the end of the line."""
        return _as_line(self.raw)

    def plain_line(self) -> bytes:
        """The same with one spelling for each value: words and TIMEs are integers, dates ``2026-11-21T06:00:00.000``.

        An adapter then has no spellings of S7 to read. ``reaches`` is none of its business.
        """
        header = {**self.raw["header"], "clock": _date(self.raw["header"]["clock"])}
        bodies = [{**body, "steps": [_plain(step) for step in body["steps"]]} for body in self.raw["bodies"]]
        outside = [_plain(event) for event in self.outside]
        plain = {**self.raw, "header": header, "outside": outside, "bodies": bodies}
        return _as_line({name: value for name, value in plain.items() if name != "reaches"})


def _as_line(raw: dict[str, Any]) -> bytes:
    return json.dumps(raw, ensure_ascii=False, separators=(",", ":")).encode()


def _date(value: object) -> str:
    parts = date_components(value)
    return "{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}.{ms:03}".format(**parts)


_PLAIN: dict[str, Reader] = {
    **dict.fromkeys(("period", "sign"), word),
    **dict.fromkeys(("mode", "flt_id"), byte),
    **dict.fromkeys(("sdt", "to"), _date),
    "dtime": duration,
}
"""Operand or field -> its value in the one spelling."""


def _plain(step: dict[str, Any]) -> dict[str, Any]:
    return {name: _PLAIN[name](value) if name in _PLAIN else value for name, value in step.items()}


def _text(value: object) -> str:
    if isinstance(value, str) and value.strip() and "\n" not in value:
        return value
    raise UnusableLogError("a text of one line", quote(value))


def _matching(pattern: re.Pattern[str], expected: str) -> Callable[[object], str]:
    def read(value: object) -> str:
        if isinstance(value, str) and pattern.fullmatch(value):
            return value
        raise UnusableLogError(expected, quote(value))

    return read


def _each(reader: Reader) -> Callable[[object], list[Any]]:
    """A reader of lists; an error names the place of the element, from 1."""

    def read(value: object) -> list[Any]:
        if not isinstance(value, list):
            raise UnusableLogError("a list", quote(value))
        elements = []
        for place, element in enumerate(value, 1):
            try:
                elements.append(reader(element))
            except UnusableLogError as error:
                error.inside(str(place))
                raise
        return elements

    return read


def _header(value: object) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise UnusableLogError("an object", quote(value))
    for name in value:
        if name not in HEADER_FIELDS and not name.startswith(OWN):
            raise UnusableLogError(f"one of {', '.join(HEADER_FIELDS)}", "an unknown field", field=name)
    log_header.read_header({"format": log_header.FORMAT, **value})
    return value


_TWO_WAYS: Mapping[str, Reader] = {"to": instant_moment, "by": _jump}
_EVENTS: dict[str, tuple[Mapping[str, Reader], Mapping[str, Reader]]] = {
    "clock": ({}, _TWO_WAYS),
    "interrupt": ({"ob": FIELDS["interrupt"]["ob"]}, {"flt_id": FIELDS["interrupt"]["flt_id"]}),
    "load": (FIELDS["load"], {}),
    "delete": (FIELDS["delete"], {}),
    "restart": (FIELDS["restart"], {}),
    "stop": ({}, {}),
    "hold": ({}, {}),
    "release": ({}, {}),
    "state": ({"ob": _ob}, {}),
}
"""Event from outside -> its required and its optional fields."""

OUTSIDE = tuple(_EVENTS)
"""The events from outside."""

_NAMED: dict[str, Reader] = {"event": lambda name: name}
_OUTSIDE = {
    name: Fields(f"outside event {name}", {"after": _elapsed, **_NAMED, **required}, {"every": _span, **optional})
    for name, (required, optional) in _EVENTS.items()
}
_OWN_EVENTS = {
    name: Fields(f"step {name}", {**_NAMED, **_EVENTS[name][0]}, _EVENTS[name][1]) for name in ("clock", "state")
}
_CALLS = {
    name: Fields(f"call of {name}", {"call": lambda name: name, **operands}, {}) for name, operands in OPERANDS.items()
}
_WAIT = Fields("step wait", {"wait": _elapsed}, {})


def _end(value: object) -> bool:
    if value is True:
        return value
    raise UnusableLogError("true", quote(value))


_END = Fields("step end", {"end": _end}, {})


def _known(raw: dict[str, object], field: str, kinds: Mapping[str, Fields]) -> Fields:
    name = raw.get(field)
    if isinstance(name, str) and name in kinds:
        return kinds[name]
    raise UnusableLogError(" or ".join(kinds), quote(name) if field in raw else "none", field=field)


def _checked(event: dict[str, Any]) -> None:
    if event["event"] == "clock" and ("to" in event) == ("by" in event):
        raise UnusableLogError("one of to and by", "both" if "to" in event else "none")
    if event["event"] == "interrupt":
        check_fault(event)


def _outside(value: object) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise UnusableLogError("an object", quote(value))
    _checked(_known(value, "event", _OUTSIDE).read(value))
    return value


def _step(value: object) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise UnusableLogError("an object", quote(value))
    if "call" in value:
        _known(value, "call", _CALLS).read(value)
    elif "event" in value:
        _checked(_known(value, "event", _OWN_EVENTS).read(value))
    elif "wait" in value:
        _WAIT.read(value)
    elif "end" in value:
        _END.read(value)
    else:
        raise UnusableLogError("a step with call, wait, event or end", "none of them")
    return value


_BODY = Fields("body", {"ob": _ob, "steps": _each(_step)}, {"run": integer(1, 0x7FFF_FFFF)})


def _body(value: object) -> Body:
    read = _BODY.nested(value)
    steps: Any = read["steps"]
    for step in steps[:-1]:
        if "end" in step:
            raise UnusableLogError("end as the last step", "steps behind it", field="steps")
    ob, run = read["ob"], read.get("run", 0)
    assert isinstance(ob, int)
    assert isinstance(run, int)
    return Body(ob, run, tuple(steps))


def _bodies(value: object) -> list[Body]:
    bodies = _each(_body)(value)
    for place, body in enumerate(bodies):
        if any((body.ob, body.run) == (other.ob, other.run) for other in bodies[:place]):
            which = f"run {body.run}" if body.run else "every other run"
            raise UnusableLogError("one body for each OB and run", f"two of OB {body.ob}, {which}")
    return bodies


_REQUIREMENTS = list_of(_matching(_REQUIREMENT, 'a requirement such as "AIRT-03"'))
_REACHES = Fields("reaches", {"requirements": _REQUIREMENTS, "guards": list_of(_text)}, {})

_PROGRAM = Fields(
    "program",
    {
        "format": choice(FORMAT),
        "name": _matching(_NAME, "a name of letters, digits, '.', '_' and '-'"),
        "about": _text,
        "requirements": _REQUIREMENTS,
        "header": _header,
        "duration": _span,
        "bodies": _bodies,
    },
    {"reaches": _REACHES.nested, "catches": _text, "seed": integer(0, (1 << 63) - 1), "outside": _each(_outside)},
)


def read_program(text: bytes) -> Program:
    """The program in ``text``, one JSON object on any number of lines.

    Raises UnusableLogError: ``field`` is the path of the wrong field, elements of lists by their place from 1
    (``bodies.1.steps.2.sdt``); ``line`` is set only where the text is no JSON.
    """
    _refuse_broken(text)
    raw = decode_object(text.strip())
    if "format" not in raw or not isinstance(raw["format"], str):
        raise UnusableLogError(f'a program, with "format": "{FORMAT}"', "none", field="format")
    read: dict[str, Any] = _PROGRAM.read(raw)
    return Program(
        name=read["name"],
        about=read["about"],
        requirements=tuple(read["requirements"]),
        reaches=tuple(read.get("reaches", {}).get("requirements", ())),
        catches=read.get("catches", ""),
        header=read["header"],
        duration=read["duration"],
        outside=tuple(sorted(read.get("outside", []), key=lambda event: int(event["after"]))),
        bodies=tuple(read["bodies"]),
        raw=raw,
    )


def _refuse_broken(text: bytes) -> None:
    """Raises UnusableLogError with the line where ``text``, which may have several, is no JSON."""
    try:
        json.loads(text)
    except json.JSONDecodeError as error:
        found = f"{error.msg[:1].lower()}{error.msg[1:]} at column {error.colno}"
        raise UnusableLogError("a JSON object", found, line=error.lineno) from error
    except (ValueError, RecursionError):
        return  # not UTF-8 or nested too deep: the reader of objects says so


def read_programs(file: Path) -> Iterator[Program]:
    """The programs of a file: one object, or with the ending ``.ndjson`` one a line, blank lines ignored.

    Raises UnusableLogError, with its line in a file of lines, and OSError.
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
