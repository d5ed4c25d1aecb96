"""The spellings of single values. Each reader takes a decoded JSON value and returns the
normalised one, or raises UnusableLogError without field and line.
"""

import re
from collections.abc import Callable
from datetime import datetime, timedelta

from s7check.log.errors import UnusableLogError, quote

Moment = dict[str, int]
"""A point in time for the engine: ``{"min": minutes, "ms": milliseconds in the minute}``."""

MS_PER_MINUTE = 60_000
_EPOCH = datetime(1990, 1, 1)
_YEARS = range(1990, 2090)
_CACHED = 4096


def moment(milliseconds: int) -> Moment:
    """Milliseconds since any zero, as a moment."""
    minutes, rest = divmod(milliseconds, MS_PER_MINUTE)
    return {"min": minutes, "ms": rest}


def integer(low: int, high: int) -> Callable[[object], int]:
    """A reader of JSON integers from ``low`` to ``high``."""
    expected = f"an integer {low}..{high}"

    def read(value: object) -> int:
        # `type`, since True is an int for isinstance, and 1.0 is no JSON integer here.
        if type(value) is int and low <= value <= high:
            return value
        raise UnusableLogError(expected, quote(value))

    return read


def choice(*allowed: str) -> Callable[[object], str]:
    """A reader of one of the strings ``allowed``."""
    among = frozenset(allowed)
    expected = " or ".join(f'"{name}"' for name in allowed)

    def read(value: object) -> str:
        if type(value) is str and value in among:
            return value
        raise UnusableLogError(expected, quote(value))

    return read


def truth(value: object) -> bool:
    """``true`` or ``false``."""
    if type(value) is bool:
        return value
    raise UnusableLogError("true or false", quote(value))


# S7 writes its constants in either case; only ASCII letters count as its letters.
_CASELESS = re.IGNORECASE | re.ASCII

_WORD = re.compile(r"(?:(?:W#)?16#([0-9A-F]{1,4})|B#16#([0-9A-F]{1,2}))", _CASELESS)


_OF_C = re.compile(r"0x([0-9A-F]{1,4})", _CASELESS)
"""A common spelling that the format does not have."""


def _hexadecimal(low: int, high: int, expected: str) -> Callable[[object], int]:
    """A reader of integers from ``low`` to ``high`` and S7's hexadecimal spellings up to it."""
    known: dict[str, int] = {}

    def read(value: object) -> int:
        if type(value) is int and low <= value <= high:
            return value & 0xFFFF
        if type(value) is str:
            number = known.get(value)
            if number is not None:
                return number
            match = _WORD.fullmatch(value)
            if match is not None:
                number = int(match[1] or match[2], 16)
                if number <= high:
                    if len(known) < _CACHED:
                        known[value] = number
                    return number
            match = _OF_C.fullmatch(value)
            if match is not None and int(match[1], 16) <= high:
                digits = 2 if high == 0xFF else 4
                raise UnusableLogError(f'the spelling "16#{int(match[1], 16):0{digits}X}"', quote(value))
        raise UnusableLogError(expected, quote(value))

    return read


_WORD_EXPECTED = 'a word such as "W#16#8090" or an integer -32768..65535'

word = _hexadecimal(-0x8000, 0xFFFF, _WORD_EXPECTED)
"""Reader of a word, 0..65535; signed integers are taken as their 16 bits."""

byte = _hexadecimal(0, 0xFF, 'a byte such as "B#16#80" or an integer 0..255')
"""Reader of a byte, 0..255."""

NOT_LOGGED = -1
"""Stands for ``null`` in normalised events."""


def word_or_null(value: object) -> int:
    """A word, or NOT_LOGGED for ``null``."""
    if value is None:
        return NOT_LOGGED
    try:
        return word(value)
    except UnusableLogError as error:
        error.expected += ", or null"
        raise


_UNITS = {"d": 86_400_000, "h": 3_600_000, "m": 60_000, "s": 1000, "ms": 1}
_DURATION = re.compile(
    r"T(?:IME)?#(?P<sign>-?)(?=[0-9])(?:(?P<d>[0-9]{1,10})D_?)?(?:(?P<h>[0-9]{1,10})H_?)?"
    r"(?:(?P<m>[0-9]{1,10})M_?(?!S))?(?:(?P<s>[0-9]{1,10})S_?)?(?:(?P<ms>[0-9]{1,10})MS)?(?<!_)",
    _CASELESS,
)


def duration(value: object) -> int:
    """A TIME: milliseconds in signed 32 bits, or S7's spelling such as ``T#-1m_30s``."""
    number = value if type(value) is int else None
    if type(value) is str and (match := _DURATION.fullmatch(value)):
        number = sum(int(match[unit] or 0) * ms for unit, ms in _UNITS.items())
        number = -number if match["sign"] else number
    if number is not None and -0x8000_0000 <= number < 0x8000_0000:
        return number
    raise UnusableLogError(
        'a duration such as "T#1s500ms" or an integer -2147483648..2147483647 of milliseconds',
        quote(value),
    )


_ISO = re.compile(r"([0-9]{4})-([0-9]{2})-([0-9]{2})T([0-9]{2}):([0-9]{2})(?::([0-9]{2})(?:\.([0-9]{1,3}))?)?")
_S7 = re.compile(
    r"(?:DT|DATE_AND_TIME)#([0-9]{4})-([0-9]{1,2})-([0-9]{1,2})-([0-9]{1,2}):([0-9]{1,2})"
    r"(?::([0-9]{1,2})(?:\.([0-9]{1,3}))?)?",
    _CASELESS,
)
_DATE_EXPECTED = 'a date and time such as "2026-11-21T06:00:00.000"'


def date_components(value: object) -> dict[str, int]:
    """The numbers of a date and time that need not exist, by ``year month day hour minute second
    ms``; this is how a program may have passed it.
    """
    match = None
    if type(value) is str:
        match = _ISO.fullmatch(value) or _S7.fullmatch(value)
    if match is None:
        raise UnusableLogError(_DATE_EXPECTED, quote(value))
    year, month, day, hour, minute, second, fraction = match.groups("0")
    return {
        "year": int(year),
        "month": int(month),
        "day": int(day),
        "hour": int(hour),
        "minute": int(minute),
        "second": int(second),
        "ms": int(fraction.ljust(3, "0")),
    }


# The parts of ISO dates are looked up: most lines of a log lie in the same few minutes.
_minutes: dict[str, int] = {}
_SECONDS: dict[str, int] = {"": 0, **{f":{second:02}": second * 1000 for second in range(60)}}
_FRACTIONS: dict[str, int] = {"": 0} | {
    f".{number:0{digits}}": number * 10 ** (3 - digits) for digits in (1, 2, 3) for number in range(10**digits)
}


def instant(value: object) -> int:
    """A date and time that exists, 1990 to 2089, as milliseconds since 1990-01-01T00:00."""
    if type(value) is str:
        try:
            return _minutes[value[:16]] + _SECONDS[value[16:19]] + _FRACTIONS[value[19:]]
        except KeyError:
            pass
    return _new_instant(value)


def _new_instant(value: object) -> int:
    year, month, day, hour, minute, second, ms = date_components(value).values()
    if year not in _YEARS:
        raise UnusableLogError("a date and time from 1990-01-01 to 2089-12-31", quote(value))
    try:
        exact = datetime(year, month, day, hour, minute, second)
    except ValueError as error:
        raise UnusableLogError("a date and time that exists", quote(value)) from error
    since = exact - _EPOCH
    seconds = since.days * 86_400 + since.seconds
    if _ISO.fullmatch(str(value)):
        if len(_minutes) >= _CACHED:
            _minutes.clear()
        _minutes[str(value)[:16]] = seconds // 60 * MS_PER_MINUTE
    return seconds * 1000 + ms


INSTANTS = (0, (datetime(_YEARS.stop, 1, 1) - _EPOCH) // timedelta(milliseconds=1) - 1)
"""The least and the largest of what ``instant`` gives."""


def step(text: str) -> int:
    """The milliseconds of the unit in which a date and time that ``instant`` can read is written."""
    if "." in text:
        return 1
    return 1000 if text.count(":") > 1 else MS_PER_MINUTE


def iso(milliseconds: int) -> str:
    """Milliseconds since 1990-01-01T00:00 as a log spells them, ``2026-11-21T06:00:00.000``."""
    return (_EPOCH + timedelta(milliseconds=milliseconds)).isoformat(timespec="milliseconds")


def instant_moment(value: object) -> Moment:
    """A date and time that exists, as a moment."""
    return moment(instant(value))


def minute_number(value: object) -> int:
    """A date and time that exists, as whole minutes since 1990-01-01T00:00."""
    return instant(value) // MS_PER_MINUTE
