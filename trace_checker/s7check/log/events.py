"""The events: every line of a log but the first."""

from itertools import chain
from typing import Any

from s7check.log import tables
from s7check.log.errors import UnusableLogError, quote, ranges
from s7check.log.fields import Fields, Reader
from s7check.log.values import (
    INSTANTS,
    byte,
    choice,
    date_components,
    duration,
    instant,
    instant_moment,
    integer,
    step,
    truth,
    word,
    word_or_null,
)

_LONGEST_UP = 100 * 366 * 86_400_000
"""Milliseconds; no log outlasts the years that the CPU clock can show."""

_up = integer(0, _LONGEST_UP)
_passed_ob = integer(-0x8000, 0x7FFF)
_block = integer(tables.OB_NUMBERS.start, tables.OB_NUMBERS.stop - 1)
_LONGEST_LEFT = 0x7FFF_FFFF
_left = integer(0, _LONGEST_LEFT)
_external_obs = f"an OB {ranges(tables.EXTERNAL_OBS)}"


def _external_ob(value: object) -> int:
    if type(value) is int and value in tables.EXTERNAL_OBS:
        return value
    raise UnusableLogError(_external_obs, quote(value))


def _truth_number(value: object) -> int:
    """1 for ``true``, 0 for ``false``; a field that is not given has another number."""
    return int(truth(value))


_INFO: dict[str, Reader] = {
    "strt_info": byte,
    "flt_id": byte,
    "priority": byte,
    "period": word,
    "sign": word,
    "dtime": duration,
    "error_info": word,
    "ev": word,
    "ev_ob": byte,
    "time": instant_moment,
}
_info = Fields("info", {}, _INFO).nested

_ANY: dict[str, Reader] = {"event": lambda name: name, "at": instant}
_OB = {"ob": _passed_ob}
_RET = {"ret": word_or_null}
_CALL_OF_OB: dict[str, Reader] = {**_OB, **_RET}
_CALL_WITH_MODE: dict[str, Reader] = {"mode": byte, **_OB, **_RET}
_STATUS: dict[str, Reader] = {"status": word}
_BLOCK: dict[str, Reader] = {"ob": _block}

_TABLE: dict[str, tuple[dict[str, Reader], dict[str, Reader]]] = {
    "SET_TINT": ({**_OB, "sdt": date_components, "period": word, **_RET}, {}),
    "CAN_TINT": (_CALL_OF_OB, {}),
    "ACT_TINT": (_CALL_OF_OB, {}),
    "QRY_TINT": (_CALL_OF_OB, _STATUS),
    "SRT_DINT": ({**_OB, "dtime": duration, "sign": word, **_RET}, {}),
    "CAN_DINT": (_CALL_OF_OB, {}),
    "QRY_DINT": (_CALL_OF_OB, _STATUS),
    "DIS_IRT": (_CALL_WITH_MODE, {}),
    "EN_IRT": (_CALL_WITH_MODE, {}),
    "DIS_AIRT": ({**_RET}, {}),
    "EN_AIRT": ({**_RET}, {}),
    "start": (_BLOCK, {"info": _info}),
    "end": (_BLOCK, {}),
    "clock": ({"to": instant_moment}, {}),
    "restart": ({"type": choice("warm", "cold")}, {}),
    "run": ({}, {}),
    "stop": ({}, {"cause": word}),
    "hold": ({}, {}),
    "release": ({}, {}),
    "interrupt": ({"ob": _external_ob}, {"flt_id": byte}),
    "load": (_BLOCK, {}),
    "delete": (_BLOCK, {}),
    "diag": ({"id": word}, {"ob": byte, "priority": byte, "info": _info}),
    "state": (
        _BLOCK,
        {**dict.fromkeys(("active", "blocked", "loaded", "entries_off"), _truth_number), "left": _left},
    ),
}
"""Event -> its required and its optional fields, without the fields of every event."""

OPERANDS: dict[str, dict[str, Reader]] = {
    name: {field: reader for field, reader in required.items() if field != "ret"}
    for name, (required, _) in _TABLE.items()
    if "ret" in required
}
"""SFC -> its operands, without RET_VAL and STATUS."""

FIELDS: dict[str, dict[str, Reader]] = {
    name: {**required, **optional} for name, (required, optional) in _TABLE.items() if name not in OPERANDS
}
"""Event that is no call -> the fields of its own, required and optional."""

_EVENTS = {
    name: Fields(name, {**_ANY, **required}, {"up": _up, **optional}) for name, (required, optional) in _TABLE.items()
}


_VARYING: dict[Reader, tuple[str, int, int]] = {
    instant: ("date", *INSTANTS),
    instant_moment: ("date", *INSTANTS),
    _up: ("number", 0, _LONGEST_UP),
    _left: ("number", 0, _LONGEST_LEFT),
}

VARYING: dict[str, tuple[str, int, int]] = {
    path: _VARYING[reader]
    for path, reader in chain(
        *(fields.items() for of_event in _TABLE.values() for fields in of_event),
        *(_ANY.items(), {"up": _up}.items(), ((f"info.{name}", reader) for name, reader in _INFO.items())),
    )
    if reader in _VARYING
}
"""Path of a field whose value is another one in most lines -> its plain form, its least and largest value.

A plain date is the form of ISO 8601, a plain number is written in digits alone.
"""


def _check_status(event: dict[str, Any]) -> None:
    if event["ret"] == 0 and "status" not in event:
        raise UnusableLogError('where "ret" is 0', "none", field="status")


def check_fault(event: dict[str, Any]) -> None:
    """Raises UnusableLogError unless a start event of OB 80 or 85, and no other, has its ``flt_id``."""
    if (event["ob"] in tables.OBS_WITH_FAULT) == ("flt_id" in event):
        return
    if "flt_id" in event:
        raise UnusableLogError("for OB 80 and 85 only", f"for OB {event['ob']}", field="flt_id")
    raise UnusableLogError(f"for OB {event['ob']}", "none", field="flt_id")


_CHECKS = {"QRY_TINT": _check_status, "QRY_DINT": _check_status, "interrupt": check_fault}


def read_event(raw: dict[str, object]) -> dict[str, Any]:
    """The normalised event of a line's object.

    Points in time are moments but for ``at``, which stays milliseconds since 1990-01-01T00:00, and
    ``sdt``, which is its components. ``step`` is the unit in which ``at`` is written, if that is not
    a millisecond. Raises UnusableLogError, without its line.
    """
    name = raw.get("event")
    if not isinstance(name, str) or name not in _EVENTS:
        raise _no_event(raw)
    event = _EVENTS[name].read(raw)
    unit = step(str(raw["at"]))
    if unit > 1:
        event["step"] = unit
    check = _CHECKS.get(name)
    if check is not None:
        check(event)
    return event


def _no_event(raw: dict[str, object]) -> UnusableLogError:
    if "event" in raw:
        return UnusableLogError("the name of an event", quote(raw["event"]), field="event")
    if "format" in raw:
        return UnusableLogError("an event", "a second header")
    return UnusableLogError("in every line but the header", "none", field="event")
