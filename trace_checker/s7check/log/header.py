"""The header: the first line of a log."""

from typing import Any

from s7check.log import tables
from s7check.log.errors import UnusableLogError, quote, ranges
from s7check.log.fields import Fields, Reader, list_of, mapping
from s7check.log.values import choice, instant_moment, integer, minute_number, truth

FORMAT = "s7-interrupt-log/1"

NO_START = -1
"""Normalised ``start`` of an interrupt to which STEP 7 gives no date."""

KINDS = ("call", "ob", "clock", "mode", "interrupt", "load", "diag", "state")
_DEFAULT_KINDS = tuple(kind for kind in KINDS if kind not in ("diag", "state"))

CPUS = ("S7-300", "S7-400", "CPU 318")
"""Families of CPUs that a header may name."""

PROFILES = ("1997", "2006", "2010", "1997ru", "2006ru", "2010zh")
"""Editions of the manual, and their translations, whose readings a header may ask for together."""

_EXECUTIONS = (
    *("none", "once", "minute", "hourly", "daily"),
    *("weekly", "monthly", "yearly", "end_of_month"),
)

_TIME_OF_DAY = Fields(
    "a time-of-day interrupt",
    {},
    {
        "execution": choice(*_EXECUTIONS),
        "start": minute_number,
        "active": truth,
        "deselected": truth,
    },
)


def _time_of_day(value: object) -> dict[str, object]:
    """STEP 7's parameters of one time-of-day interrupt, defaults filled in."""
    given = _TIME_OF_DAY.nested(value)
    normalised = {"execution": "none", "start": NO_START, "active": False, "deselected": False}
    normalised |= given
    if normalised["execution"] != "none" and "start" not in given:
        raise UnusableLogError(f"with execution {quote(normalised['execution'])}", "none", field="start")
    return normalised


def _priority_of(ob: int) -> Reader:
    classes = tables.SETTABLE_PRIORITIES[ob]
    expected = f"a class {classes.start}..{classes.stop - 1} or {tables.DESELECTED} (deselected)"

    def read(value: object) -> object:
        if type(value) is int and (value in classes or value == tables.DESELECTED):
            return value
        raise UnusableLogError(expected, quote(value))

    return read


_priorities = mapping(
    f"an OB whose class can be set, {ranges(tables.SETTABLE_PRIORITIES)},",
    {str(ob): _priority_of(ob) for ob in tables.SETTABLE_PRIORITIES},
)
_readings = mapping(
    f'an ambiguity "{min(tables.READINGS)}".."{max(tables.READINGS)}"',
    {ambiguity: choice(*letters) for ambiguity, letters in tables.READINGS.items()},
)
_tod = mapping(f"an OB {ranges(tables.TIME_OF_DAY_OBS)}", {str(ob): _time_of_day for ob in tables.TIME_OF_DAY_OBS})

_HEADER = Fields(
    "header",
    {
        "format": choice(FORMAT),
        "cpu": choice(*CPUS),
        "obs": list_of(integer(tables.OB_NUMBERS.start, tables.OB_NUMBERS.stop - 1)),
        "clock": instant_moment,
    },
    {
        "mode": choice("STOP", "STARTUP", "RUN"),
        "latency_ms": integer(0, 0x7FFF_FFFF),
        "records": list_of(choice(*KINDS)),
        "cycle": truth,
        "priority": _priorities,
        "step7": mapping("the field tod", {"tod": _tod}),
        "readings": _readings,
        "profile": choice(*PROFILES),
    },
)


def read_header(raw: dict[str, object]) -> dict[str, Any]:
    """The normalised header of the object in a log's first line, every default filled in.

    Maps become lists of pairs, ``step7`` a list of records with their ``ob``. Raises UnusableLogError,
    without its line.
    """
    if "format" not in raw and "event" in raw:
        raise UnusableLogError("the header in the first line", f"the event {quote(raw['event'])}")
    given: dict[str, Any] = _HEADER.read(raw)
    if "priority" in given and given["cpu"] not in tables.PRIORITY_CPUS:
        raise UnusableLogError("on S7-400 and CPU 318 only", f"on {given['cpu']}", field="priority")
    time_of_day = given.get("step7", {}).get("tod", {})
    return {
        "cpu": given["cpu"],
        "obs": sorted(given["obs"]),
        "clock": given["clock"],
        "mode": given.get("mode", "STOP"),
        "latency": given.get("latency_ms", 10),
        "cycle": given.get("cycle", False),
        "priority": [[int(ob), level] for ob, level in given.get("priority", {}).items()],
        "step7": [{"ob": int(ob), **parameters} for ob, parameters in time_of_day.items()],
        "readings": [[ambiguity, letter] for ambiguity, letter in given.get("readings", {}).items()],
        "profile": given.get("profile", ""),
        "records": given.get("records", list(_DEFAULT_KINDS)),
    }
