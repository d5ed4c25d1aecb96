"""The log of a program up to the end of the program: what had to come by then is owed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import msgspec

from s7check.engine.answer import Content
from s7check.engine.client import Engine
from s7check.kit.adapter import Ran
from s7check.kit.program import Program
from s7check.log.values import MS_PER_MINUTE, NOT_LOGGED, instant, iso

_LAST = instant("2089-12-31T23:59:59.999")
"""The last reading of a CPU clock."""


@dataclass(frozen=True)
class Whole:
    """The lines of a log, ``done`` the last of them; ``content`` has them normalised, ``until`` is when the log ends,
    in ms of elapsed time.
    """

    lines: tuple[bytes, ...]
    content: Content
    until: int


def whole(engine: Engine, program: Program, ran: Ran) -> Whole:
    """The log with its ``done``: the adapter's own if it is at the end of the program or later, else one at that end.

    An adapter that falls silent, or says that its log ends sooner, owes what had to come until the program ends. A log
    that cannot be read stays as it is: the verdict says where.
    """
    lines = (*ran.log, *([ran.done] if ran.done else []))
    content = engine.read(b"\n".join(lines))
    if content.unusable is not None or content.header is None:
        return Whole(lines, content, program.duration)
    last = content.events[-1] if content.events else {"event": "", "at": content.header["clock"]}
    up = _ms(last["up"]) if content.events else 0
    if last["event"] == "done" and up >= program.duration:
        return Whole(lines, content, up)
    rest = max(0, program.duration - up)
    clock = _ms(last["to"] if last["event"] == "clock" else last["at"])
    mark: dict[str, Any] = {"event": "done", "at": iso(min(clock + rest, _LAST))}
    if any(_has_up(event) for event in content.events):
        mark["up"] = up + rest
    return Whole((*ran.log, msgspec.json.encode(mark)), content, up + rest)


def as_it_is(engine: Engine, lines: Sequence[bytes]) -> Whole:
    """A log that was written so far: it ends with its last line."""
    content = engine.read(b"\n".join(lines))
    return Whole(tuple(lines), content, elapsed(content.events[-1]) if content.events else 0)


def _ms(moment: dict[str, int]) -> int:
    return moment["min"] * MS_PER_MINUTE + moment["ms"]


def _has_up(event: dict[str, Any]) -> bool:
    return "counter" in event and event["counter"]["min"] != NOT_LOGGED


def elapsed(event: dict[str, Any]) -> int:
    """The milliseconds of a normalised event since the log began."""
    return _ms(event["up"])
