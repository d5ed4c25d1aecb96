"""Lines of a log and their times in short texts."""

from typing import Any

from s7check.engine.answer import Moment
from s7check.log.values import MS_PER_MINUTE, iso


def iso_of(moment: Moment) -> str:
    """A moment as a log spells it, with seconds and milliseconds."""
    return iso(moment.min * MS_PER_MINUTE + moment.ms)


def passed_date(components: dict[str, int]) -> str:
    """A date and time that a program has passed, which need not exist, with seconds and milliseconds."""
    return "{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}.{ms:03}".format_map(components)


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
