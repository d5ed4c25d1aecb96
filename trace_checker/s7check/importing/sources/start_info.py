"""The start information of an OB, bytes 1 and 4 to 11, as the fields of ``info``.

Its layout is that of table 7.2 of the requirements. Bytes whose meaning no source tells are left out.
"""

from typing import Any

_TIME_OF_DAY = range(10, 18)
_TIME_DELAY = range(20, 24)
_WITH_FAULT = frozenset({70, 72, 73, *range(80, 89), 121, 122})
"""OBs of which byte 1 is a fault id."""

_ERROR_INFO = {80: frozenset({0x01, 0x02, 0x05, 0x06, 0x07, 0x08, 0x09, 0x0A}), 85: frozenset({0xA1, 0xA2})}
"""OB -> its faults of which bytes 6-7 are an ERROR_INFO."""

_CAUSE = {80: frozenset({0x01, 0x02, 0x07, 0x0B}), 85: frozenset({0xA1, 0xA2})}
"""OB -> its faults of which bytes 8-11 name an event and an OB."""


def start_info(ob: int, number: int, info_1: int, info_2: int) -> dict[str, Any]:
    """The fields of ``ob``'s start information.

    ``number`` is byte 1, ``info_1`` the word of bytes 6-7, ``info_2`` the double word of bytes 8-11.
    """
    fields: dict[str, Any] = {}
    if ob in _CAUSE:
        fields["flt_id"] = byte(number)
        if number in _ERROR_INFO[ob]:
            fields["error_info"] = word(info_1)
        if number in _CAUSE[ob]:
            fields["ev"] = word(info_2 >> 16)
            fields["ev_ob"] = info_2 & 0xFF
    elif ob not in _WITH_FAULT:
        fields["strt_info"] = byte(number)
    if ob in _TIME_OF_DAY:
        fields["period"] = word(info_1)
    if ob in _TIME_DELAY:
        fields["sign"] = word(info_1)
        fields["dtime"] = duration(info_2)
    return fields


def byte(value: int) -> str:
    """A byte as a log spells it."""
    return f"B#16#{value:02X}"


def word(value: int) -> str:
    """A word as a log spells it."""
    return f"W#16#{value & 0xFFFF:04X}"


def duration(value: int) -> int:
    """The milliseconds of a TIME, whose 32 bits are signed."""
    return value - (1 << 32) if value >> 31 else value
