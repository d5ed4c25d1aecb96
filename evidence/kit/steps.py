"""Small steps: of the clock over a point, of the low byte of PERIOD, from month to month."""

from __future__ import annotations

from collections.abc import Iterator

from evidence.kit.building import DAY, MINUTE, PERIODS, SECOND, at, body, call, header, program, set_tint, wait
from s7check.kit.from_log import Json

_CPUS = ("S7-300", "S7-400", "CPU 318")
_CLOCK = "2026-11-21T05:59:30"
_LOW_BYTES = (0x00, 0x02, 0x03, 0x10, 0xFF)
_HIGH_BYTES = 16
"""High bytes of PERIOD in a program; each call takes room in the L-stack of some implementations."""


def programs() -> Iterator[Json]:
    """Every program of this module."""
    yield from _clock_steps()
    yield from _period_codes()
    yield from _months()


def _clock_steps() -> Iterator[Json]:
    """Each minute the clock is set over the next point, by 1 to 19 s; the point is in the middle of the step."""
    for cpu in _CPUS:
        for first in (1, 7, 13):
            steps = range(first, min(first + 6, 19) + 1)
            # What the clock has gained so far makes the next point come sooner.
            events, gained = [], 0
            for number, seconds in enumerate(steps, 1):
                point = number * MINUTE + 30 * SECOND - gained
                events.append(at(point - seconds * SECOND // 2, "clock", by=seconds * SECOND))
                gained += seconds * SECOND
            yield program(
                f"CLK-step-{steps[0]}-to-{steps[-1]}-s-{cpu}".replace(" ", "-"),
                f"The clock is set forward over a point by {steps[0]} to {steps[-1]} s, a second more each time.",
                ["CLK-02", "CLK-03"],
                header(cpu, _CLOCK),
                (len(steps) + 3) * MINUTE,
                [body(1, [set_tint(10, "2026-11-21T06:00", PERIODS["minute"]), call("ACT_TINT", ob=10)], 1)],
                events,
            )


def _period_codes() -> Iterator[Json]:
    """SFC 28 with PERIODs of every high byte whose low byte is not 01."""
    for place, first in enumerate(range(0, 0x100, _HIGH_BYTES)):
        codes = [f"16#{high:02X}{low:02X}" for high in range(first, first + _HIGH_BYTES) for low in _LOW_BYTES]
        steps = [set_tint(10, "2026-11-21T07:00", code) for code in codes]
        last = first + _HIGH_BYTES - 1
        yield program(
            f"TINT-period-codes-{first:02X}-to-{last:02X}",
            f"PERIODs with the high bytes {first:02X} to {last:02X} and low bytes other than 01.",
            ["TINT-33", "TINT-35"],
            header(_CPUS[place % 3], _CLOCK),
            2 * SECOND,
            [body(1, [*steps, call("QRY_TINT", ob=10), wait(SECOND)], 1)],
        )


def _months() -> Iterator[Json]:
    """Thirteen months in a row, each with its point; once the months elapse, once the clock is set up to each point."""
    ends = (31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31, 31)
    for period, days in {"monthly": [15] * 13, "end of month": ends}.items():
        dates = [(2027 + month // 12, month % 12 + 1, day) for month, day in enumerate(days)]
        points = [f"{year}-{month:02}-{day:02}T06:00" for year, month, day in dates]
        ob_1 = body(1, [set_tint(10, points[0], PERIODS[period]), call("ACT_TINT", ob=10)], 1)
        name, requirements = (
            f"TINT-months-{period}".replace(" ", "-"),
            ["TINT-18" if period == "monthly" else "TINT-19"],
        )
        yield program(
            f"{name}-elapse",
            f"{period.capitalize()} for 13 months, December among them: each month has its point.",
            requirements,
            header("S7-400", "2027-01-01T00:00:00"),
            396 * DAY,
            [ob_1],
        )
        sets = [at(MINUTE * n, "clock", to=f"{point[:11]}05:59:50") for n, point in enumerate(points)]
        yield program(
            f"{name}-by-clock",
            f"{period.capitalize()} for 13 months; the clock is set to ten seconds before each point.",
            requirements,
            header("S7-300", "2027-01-01T00:00:00"),
            MINUTE * (len(points) + 1),
            [ob_1],
            [{**event, "after": event["after"] + 5 * SECOND} for event in sets],
        )
