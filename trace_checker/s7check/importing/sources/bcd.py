"""DATE_AND_TIME: eight bytes of BCD, ``yy mm dd hh mi ss ms ms|weekday``."""

from datetime import datetime

LENGTH = 8

_FIRST_YEAR = 90
"""Two-digit years from here on are of the 20th century."""


def digits(raw: bytes) -> str:
    """The date and time of ``raw`` as a log spells it, whether it exists or not.

    A program may pass any date; the weekday is not looked at. Raises ValueError if a half-byte is
    no decimal digit, which no spelling can express.
    """
    text = raw.hex()
    if len(raw) != LENGTH or not text[:15].isdecimal():
        raise ValueError(raw)
    year, month, day, hour, minute, second = (text[at : at + 2] for at in range(0, 12, 2))
    century = "19" if int(year) >= _FIRST_YEAR else "20"
    return f"{century}{year}-{month}-{day}T{hour}:{minute}:{second}.{text[12:15]}"


def instant(raw: bytes) -> str:
    """The date and time of ``raw``, which has to exist; raises ValueError if it does not."""
    text = digits(raw)
    datetime.fromisoformat(text)
    return text


def spaced(raw: bytes) -> str:
    """Bytes as people write them, two at a time: ``3502 1A50 C358``."""
    return raw.hex(" ", -2).upper()
