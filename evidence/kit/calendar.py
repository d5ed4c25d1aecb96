"""Start points at the turns of the calendar, for every PERIOD and every execution of STEP 7."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import datetime

from evidence.kit.building import DAY, HOUR, MINUTE, PERIODS, SECOND, body, call, header, later, program, set_tint
from s7check.kit.from_log import Json

_TURNS = {
    "plain": "2026-11-21T05:59:30",
    "year end": "2026-12-31T23:58:30",
    "century": "1999-12-31T23:58:30",
    "leap century": "2000-02-28T23:58:30",
    "leap": "2028-02-28T23:58:30",
    "leap day": "2028-02-29T23:58:30",
    "common": "2027-02-28T23:58:30",
    "thirty": "2027-04-30T23:58:30",
    "thirty-one": "2027-01-31T23:58:30",
    "last monthly day": "2027-01-28T23:58:30",
    "first": "1990-01-01T00:00:30",
    "last": "2089-12-31T23:55:30",
}

_LENGTHS = {
    "once": 3 * MINUTE,
    "minute": 4 * MINUTE,
    "hourly": 3 * HOUR,
    "daily": 3 * DAY,
    "weekly": 22 * DAY,
    "weekly 1201": 22 * DAY,
    "monthly": 190 * DAY,
    "yearly": 5 * 366 * DAY,
    "end of month": 400 * DAY,
}
_EXECUTIONS = {"weekly 1201": "weekly", "end of month": "end_of_month"}
_LAST = datetime.fromisoformat("2089-12-31T23:59:59")


def programs() -> Iterator[Json]:
    """For each turn and period a program by SFC, and one by STEP 7."""
    for number, (turn, clock) in enumerate(_TURNS.items()):
        for place, (period, code) in enumerate(PERIODS.items()):
            cpu = ("S7-300", "S7-400", "CPU 318")[(number + place) % 3]
            left = int((_LAST - datetime.fromisoformat(clock)).total_seconds()) * SECOND
            duration = min(_LENGTHS[period], left)
            start = later(clock, 30 * SECOND)
            about = f"{period.capitalize()} from {start} on, {duration / MINUTE:g} minutes long."
            name = f"TINT-calendar-{turn}-{period}".replace(" ", "-")
            calls = [set_tint(10, start, code), call("ACT_TINT", ob=10), call("QRY_TINT", ob=10)]
            further = [set_tint(11, later(clock, 59 * SECOND), code), call("ACT_TINT", ob=11)]
            requirements = ["TINT-05", "TINT-33", "TINT-11"]
            yield program(
                f"{name}-sfc", about, requirements, header(cpu, clock), duration, [body(1, [*calls, *further], 1)]
            )
            step7 = {
                "execution": _EXECUTIONS.get(period, period),
                "start": start,
                "active": True,
            }
            if period == "weekly 1201":
                continue
            if period == "monthly" and datetime.fromisoformat(start).day > 28:
                continue
            yield program(
                f"{name}-step7",
                f"STEP 7: {about[0].lower()}{about[1:]}",
                ["TINT-04", "TINT-33", "OBS-56"],
                header(cpu, clock, step7={"tod": {"10": step7}}),
                duration,
                [body(10, [call("QRY_TINT", ob=10)])],
            )
