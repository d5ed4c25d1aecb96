"""Logs in the notation of the case files, from their lines: the other way round than ``cases``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from textwrap import wrap
from typing import Any

from evidence.common.cases import BYTES, EVENTS, INTEGERS, MOMENTS, QUEUE, WORDS

WIDTH = 110
"""Columns of a line."""

_SHORT = {event: (short, operands) for short, (event, operands) in EVENTS.items()}
"""Event -> its short name and operands."""


def shorthand(lines: Sequence[Mapping[str, Any]]) -> list[str]:
    """The header and the events of a log in short; a header has a clock."""
    header, *events = lines
    clock, at, parts = str(header["clock"]), "", []
    for event in events:
        time = "" if event["at"] == at else f"{_moment(event['at'], clock)} "
        at = event["at"]
        parts.append(time + " ".join(_words(event, clock)))
    return [*_wrapped(" ".join(_fields(header)), " "), *_wrapped("; ".join(parts), "; ")]


def _wrapped(text: str, between: str) -> list[str]:
    """Lines that end at `between`; each but the first line of events begins with a space, so that it goes on."""
    held = text.replace(" ", "\N{NO-BREAK SPACE}").replace(between.replace(" ", "\N{NO-BREAK SPACE}"), between)
    return [line.replace("\N{NO-BREAK SPACE}", " ") for line in wrap(held, WIDTH, subsequent_indent="  ")]


def _fields(header: Mapping[str, Any]) -> Iterator[str]:
    """The header as words FIELD=VALUE."""
    for name, value in header.items():
        if name == "readings":
            yield from (f"{question}={letter}" for question, letter in value.items())
        elif name in ("priority", "classes"):
            yield from (f"{name}.{ob}={one}" for ob, one in value.items())
        elif name == "queue":
            for ob, one in value.items():
                yield f"queue.{ob}={','.join(str(one.get(each, '-')).lower() for each in QUEUE)}"
        elif name == "step7":
            for obs in value.values():
                yield from (f"step7.{ob}={_parameters(one)}" for ob, one in obs.items())
        elif isinstance(value, list):
            yield f"{name}={','.join(map(str, value))}"
        elif name != "format":
            yield f"{name}={str(value).lower() if isinstance(value, bool) else str(value).replace(' ', '_')}"


def _parameters(one: Mapping[str, Any]) -> str:
    return ",".join(name if value is True else str(value) for name, value in one.items() if value is not False)


def _words(event: Mapping[str, Any], clock: str) -> Iterator[str]:
    """The event as words: its short name, its operands, the fields of `info` by name."""
    short, names = _SHORT[event["event"]]
    yield short
    known = [name for name in names if name in event]
    for name in names[: names.index(known[-1]) + 1 if known else 0]:
        yield _value(name, event[name], clock) if name in event else "-"
    yield from (f"{name}={_value(name, value, clock)}" for name, value in event.get("info", {}).items())


def _value(name: str, value: Any, clock: str) -> str:
    if value is None:
        return "null"
    if name in INTEGERS:
        return str(value)
    if name in (*BYTES, *WORDS):
        number = value if isinstance(value, int) else int(value.rpartition("#")[2], 16)
        return f"{number:02X}" if name in BYTES else f"{number:04X}"
    return _moment(value, clock) if name in MOMENTS else str(value)


def _moment(text: str, clock: str) -> str:
    """A date and time, by the hour or the day of the header's clock where it is the same."""
    if text[:10] != clock[:10]:
        return text
    seconds = text[14:].rstrip("0").rstrip(".") if "." in text else text[14:]
    minutes, _, rest = seconds.partition(":")
    rest = f"{rest}{'0' * (2 - len(rest))}" if "." not in rest else rest
    short = f"{int(minutes)}:{rest}"
    return short if text[:13] == clock[:13] else f"{int(text[11:13])}:{minutes}:{rest}"
