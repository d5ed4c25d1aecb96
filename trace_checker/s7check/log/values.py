"""Times as a log spells them. The engine reads them; here they are told, or taken from lines that it has taken."""

import re
from datetime import datetime, timedelta

MS_PER_MINUTE = 60_000
_EPOCH = datetime(1990, 1, 1)

NOT_LOGGED = -1
"""Stands for ``null`` in normalised events."""


def instant(text: str) -> int:
    """Milliseconds since 1990-01-01T00:00 of a date and time that the engine has taken, in either spelling."""
    year, month, day, hour, minute, *rest = re.split("[-T:.]", text.rpartition("#")[2])
    second, fraction = (*rest, "0", "0")[:2]
    exact = datetime(int(year), int(month), int(day), int(hour), int(minute), int(second))
    return (exact - _EPOCH) // timedelta(milliseconds=1) + int(fraction.ljust(3, "0"))


def iso(milliseconds: int) -> str:
    """Milliseconds since 1990-01-01T00:00 as a log spells them, ``2026-11-21T06:00:00.000``."""
    return (_EPOCH + timedelta(milliseconds=milliseconds)).isoformat(timespec="milliseconds")
