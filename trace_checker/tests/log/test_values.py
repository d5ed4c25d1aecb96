"""The spellings of single values."""

import json
from collections.abc import Callable
from datetime import datetime, timedelta
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from s7check.log.errors import UnusableLogError
from tests.log.reading import content, read_value
from tests.logs import HEADER, event, log_text

EARLY = HEADER | {"clock": "1990-01-01T00:00"}


def word(value: object) -> Any:
    """The number of a word."""
    return read_value("stop", "cause", value)


def word_or_null(value: object) -> Any:
    """The number of a word that may not have been logged."""
    return read_value("DIS_AIRT", "ret", value)


def byte(value: object) -> Any:
    """The number of a byte."""
    return read_value("DIS_IRT", "mode", value, ob=10, ret=0)


def duration(value: object) -> Any:
    """The milliseconds of a TIME."""
    return read_value("SRT_DINT", "dtime", value, ob=20, sign=0, ret=0)


def instant(value: object) -> Any:
    """The moment of a date and time."""
    return read_value("clock", "to", value)


def date_components(value: object) -> Any:
    """The numbers of a date and time."""
    return read_value("SET_TINT", "sdt", value, ob=10, period=0, ret=0)


@pytest.mark.parametrize(
    ("value", "number"),
    [
        ("W#16#0201", 0x0201),
        ("16#0201", 0x0201),
        ("w#16#80a1", 0x80A1),
        ("B#16#80", 0x80),
        ("16#8", 8),
        (-32768, 0x8000),
        (-32607, 0x80A1),
        (-1, 0xFFFF),
        (0, 0),
        (65535, 0xFFFF),
    ],
)
def test_word(value: object, number: int) -> None:
    """Every spelling of a word gives its 16 bits."""
    assert word(value) == number


@pytest.mark.parametrize(
    "value",
    [-32769, 65536, True, 1.0, None, [], {}, "", "0201", "16#", "16#00201", "W#16#G", "B#16#080", "16#0201 ", "16#٣"],
)
def test_no_word(value: object) -> None:
    """What is no word is refused with an example of one."""
    with pytest.raises(UnusableLogError, match=r"a word such as .* or an integer -32768\.\.65535; found"):
        word(value)


@pytest.mark.parametrize(
    ("read", "value", "spelling"),
    [
        (word, "0x8090", "16#8090"),
        (word, "0XA1", "16#00A1"),
        (byte, "0x5", "16#05"),
        (word_or_null, "0x8090", "16#8090"),
    ],
)
def test_hexadecimal_numbers_of_c(read: Callable[[object], int], value: str, spelling: str) -> None:
    """They are refused, and the message has the number as S7 spells it."""
    with pytest.raises(UnusableLogError) as caught:
        read(value)
    assert caught.value.expected.startswith(f'the spelling "{spelling}"')


@pytest.mark.parametrize(("value", "number"), [("B#16#A2", 0xA2), ("W#16#00A2", 0xA2), ("16#5", 5), (255, 255), (0, 0)])
def test_byte(value: object, number: int) -> None:
    """A byte is spelled like a word."""
    assert byte(value) == number


@pytest.mark.parametrize("value", [-1, 256, "16#0100", "W#16#FFFF", "0x100", True, 2.0, None])
def test_no_byte(value: object) -> None:
    """Bytes have no sign and 8 bits."""
    with pytest.raises(UnusableLogError, match="a byte such as"):
        byte(value)


def test_null_where_a_word_was_not_logged() -> None:
    """Only ``word_or_null`` takes null, and says so when it refuses something."""
    assert word_or_null(None) == -1
    assert word_or_null(-32607) == 0x80A1
    with pytest.raises(UnusableLogError, match='65535, or null; found "abc"'):
        word_or_null("abc")


@pytest.mark.parametrize(
    ("value", "milliseconds"),
    [
        (1500, 1500),
        (-5, -5),
        ("T#1s500ms", 1500),
        ("t#1S_500MS", 1500),
        ("T#-5ms", -5),
        ("TIME#2m", 120_000),
        ("T#1h1ms", 3_600_001),
        ("T#90s", 90_000),
        ("T#24d20h31m23s647ms", 0x7FFF_FFFF),
        ("T#-24d_20h_31m_23s_648ms", -0x8000_0000),
    ],
)
def test_duration(value: object, milliseconds: int) -> None:
    """A TIME is a number of milliseconds or S7's own spelling."""
    assert duration(value) == milliseconds


@pytest.mark.parametrize(
    "value",
    [
        *(0x8000_0000, -0x8000_0001, True, 1.5, None, "", "1s", "T#", "T#-", "T#5", "T#s", "T#1s_", "T#_1s"),
        *("T#1s1m", "T#1s1s", "T#1 s", "T#24d20h31m23s648ms", "T#--1s", "T#1ſ", "T#99999999999s"),
    ],
)
def test_no_duration(value: object) -> None:
    """Other orders, units and sizes are refused."""
    with pytest.raises(UnusableLogError, match="a duration such as"):
        duration(value)


@pytest.mark.parametrize(
    ("value", "minutes", "ms"),
    [
        ("1990-01-01T00:00", 0, 0),
        ("1990-01-01T00:01:02.003", 1, 2003),
        ("1990-01-02T00:00:00.5", 1440, 500),
        ("1990-01-01T00:00:59.99", 0, 59_990),
        ("DT#1990-01-01-00:01:02.003", 1, 2003),
        ("dt#1990-1-1-0:1:2.3", 1, 2300),
        ("DATE_AND_TIME#1990-1-1-0:1", 1, 0),
        ("2089-12-31T23:59:59.999", 52_595_999, 59_999),
        ("2024-02-29T12:00", 17_967_600, 0),
    ],
)
def test_instant(value: str, minutes: int, ms: int) -> None:
    """Both spellings count minutes since 1990 and milliseconds in the minute."""
    assert instant(value) == {"min": minutes, "ms": ms}


@pytest.mark.parametrize(
    "value",
    [
        *("1989-12-31T23:59", "2090-01-01T00:00", "2026-02-29T00:00", "2026-13-01T00:00", "2026-01-00T00:00"),
        *("2026-01-01T24:00", "2026-01-01T00:60", "2026-01-01T00:00:60", "DT#2026-02-30-00:00:00"),
    ],
)
def test_instant_must_exist(value: str) -> None:
    """Dates that have the shape but do not exist are refused, and are fine where a program passed them."""
    with pytest.raises(UnusableLogError, match="a date and time"):
        instant(value)
    assert date_components(value)


@pytest.mark.parametrize("read", [instant, date_components])
@pytest.mark.parametrize(
    "value",
    [
        *("", "2026-11-21", "2026-11-21 06:00", "2026-11-21T06", "2026-11-21T06:00Z", "2026-11-21T06:00:00+01:00"),
        *(
            "2026-11-21T06:00:00.",
            "2026-11-21T06:00:00.0000",
            "2026-11-21T06:00:0",
            "2026-1-21T06:00",
            "26-11-21T06:00",
        ),
        *("2026-11-21T06:00.5", "2026-11-21T6:00", "DT#2026-11-21T06:00", " 2026-11-21T06:00", "２026-11-21T06:00"),
        *("2026-11-21T06:00:00.000\n", 20261121, None, True, ["2026-11-21T06:00"]),
    ],
)
def test_no_date(read: Callable[[object], object], value: object) -> None:
    """What does not have the shape of a date is none."""
    with pytest.raises(UnusableLogError, match='a date and time such as "2026'):
        read(value)


def test_passed_date_is_taken_apart() -> None:
    """A date that a program passed is only its components."""
    assert date_components("2026-02-30T25:61:62.5") == {
        "year": 2026,
        "month": 2,
        "day": 30,
        "hour": 25,
        "minute": 61,
        "second": 62,
        "ms": 500,
    }


@given(st.datetimes(min_value=datetime(1990, 1, 1), max_value=datetime(2089, 12, 31)))
def test_instants(date: datetime) -> None:
    """Every day of the calendar has its number."""
    since = date - datetime(1990, 1, 1)
    minutes, rest = divmod(since, timedelta(minutes=1))
    expected = {"min": minutes, "ms": rest // timedelta(milliseconds=1)}
    assert instant(date.isoformat(timespec="milliseconds")) == expected


@given(st.datetimes(min_value=datetime(1990, 1, 1, 1), max_value=datetime(2089, 12, 31)))
def test_instants_keep_their_spelling(date: datetime) -> None:
    """Reading and writing a time are inverse: a message has the time that the log has."""
    text = date.isoformat(timespec="milliseconds")
    setting = json.dumps({"event": "clock", "at": "1990-01-01T00:00", "to": text})
    late = content(log_text(setting, event("run", at="1990-01-01T00:00"), header=EARLY)).unusable
    assert late is not None
    assert (late.field, late.expected) == ("at", f"no time before {text}, the clock's last reading")


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        ("a\x1b[31m\n", r'"a\u001b[31m\n"'),
        ("\u202e", r'"\u202e"'),
        ("x" * 100, '"' + "x" * 60 + '..."'),
        (True, "true"),
        (None, "null"),
        (1.0, "1.0, not an integer"),
        (0.5, "0.5"),
        ({"a": 1}, "an object"),
        ([1], "a list"),
        (10**80, "1" + "0" * 59 + "..."),
    ],
)
def test_quote(value: object, shown: str) -> None:
    """Values in messages are short and cannot move a terminal's cursor."""
    with pytest.raises(UnusableLogError) as caught:
        read_value("run", "up", value)
    assert caught.value.found == shown
