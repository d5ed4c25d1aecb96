"""From normalised events back to the lines of a log."""

import re
from typing import Any

from s7check.engine.answer import Moment
from s7check.log.calls import OPERANDS
from s7check.log.values import MS_PER_MINUTE, NOT_LOGGED, iso

_WORDS = frozenset({"period", "sign", "ret", "status", "cause", "id", "error_info", "ev"})
_BYTES = frozenset({"mode", "flt_id", "strt_info"})
_TRUTHS = frozenset({"active", "blocked", "loaded", "entries_off", "local", "activate"})
_UNSAID = {"ob": 0, "dtime": -1}
"""Operands that the engine does not tell, since a line without them has the same number."""

_WHOLE = re.compile(r"(?::00)?\.000$")
_OF_THE_ENGINE = frozenset({"line", "step", "counter"})


def iso_of(moment: Moment | dict[str, int]) -> str:
    """A moment as a log spells it, with seconds and milliseconds."""
    if isinstance(moment, Moment):
        return iso(moment.min * MS_PER_MINUTE + moment.ms)
    return iso(moment["min"] * MS_PER_MINUTE + moment["ms"])


def passed_date(components: dict[str, int]) -> str:
    """A date and time that a program has passed, which need not exist, with seconds and milliseconds."""
    return "{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}.{ms:03}".format_map(components)


def short(text: str) -> str:
    """A date and time without seconds and milliseconds that are 0."""
    return _WHOLE.sub("", text)


def as_line(event: dict[str, Any], at: Moment | None = None) -> dict[str, Any]:
    """The object of a log's line for a normalised event, which may lack fields.

    ``at`` is its time, if the event has none. A call that has no ``ret`` gets null.
    """
    line: dict[str, Any] = {} if at is None else {"at": iso_of(at)}
    for name, value in event.items():
        if name not in _OF_THE_ENGINE:
            line[name] = _spelled(name, value)
    if event["event"] in OPERANDS:
        for name in _UNSAID.keys() & OPERANDS[event["event"]]:
            line.setdefault(name, _UNSAID[name])
        line.setdefault("ret", None)
    return line


def _spelled(name: str, value: Any) -> Any:
    if name == "info":
        return {
            field: _spelled(field, each)
            for field, each in value.items()
            if each != NOT_LOGGED and each != {"min": NOT_LOGGED, "ms": 0}
        }
    if name == "up":
        return value["min"] * MS_PER_MINUTE + value["ms"]
    if name == "sdt":
        return short(passed_date(value))
    if isinstance(value, dict):
        return iso_of(value)
    if name in _TRUTHS:
        return bool(value)
    if name == "ret" and value == NOT_LOGGED:
        return None
    if name in _WORDS:
        return f"W#16#{value & 0xFFFF:04X}"
    if name in _BYTES:
        return f"B#16#{value & 0xFF:02X}"
    return value


def spelled(line: dict[str, Any]) -> str:
    """A line's object without its time in one short text, such as ``SET_TINT ob=10 period=W#16#0201``."""
    fields = (f"{name}={_short(value)}" for name, value in line.items() if name not in ("event", "at", "up"))
    return " ".join([str(line["event"]), *fields])


def _short(value: Any) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{name}={_short(each)}" for name, each in value.items()) + "}"
    if isinstance(value, bool):
        return str(value).lower()
    return "null" if value is None else str(value)
