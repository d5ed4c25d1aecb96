"""The calls and settings of a program are looked for in its log."""

from typing import Any

import pytest

from s7check.kit.program import Program, bodies_of
from s7check.kit.turns import calls_departure

ZONE = {"event": "zone", "zone": 120, "reason": "zone"}
CLOCK = {"event": "clock", "to": "2026-11-21T06:00:00.000"}
PLAIN = {"bodies": [{"ob": 1, "run": 1, "steps": [{"wait": 1000}, CLOCK, ZONE, {"call": "DIS_AIRT"}, {"wait": 1000}]}]}
PROGRAM = Program(
    name="T15-zone",
    about="OB 1 sets local time.",
    requirements=("T15-103",),
    reaches=(),
    catches="",
    header={"cpu": "S7-1500", "obs": [1], "clock": "2026-11-21T05:59:30", "mode": "RUN"},
    duration=5000,
    outside=(),
    bodies=bodies_of(PLAIN),
    raw=PLAIN,
    plain=PLAIN,
)
CALL = {"event": "DIS_AIRT", "ret": 1}


def departure(*events: tuple[int, dict[str, Any]]) -> str:
    """What is wrong with a log of these events with their elapsed time."""
    lines = [{"line": place, "up": {"min": 0, "ms": up}, **event} for place, (up, event) in enumerate(events, 2)]
    return calls_departure(PROGRAM, 10, lines, 5000)[0]


@pytest.mark.parametrize(
    ("events", "wrong"),
    [
        ([(1000, CLOCK), (1000, ZONE), (1000, CALL)], ""),
        ([(1000, ZONE), (1000, CALL)], ""),
        ([(1000, CALL)], "line 2: expected the next call of the program"),
        ([(1000, ZONE)], "at its end: expected DIS_AIRT"),
        ([(1000, CLOCK)], "at its end: expected zone of OB 1, when it has been at work for 1000 ms"),
        ([(1000, CLOCK), (1000, ZONE | {"zone": 60})], "at its end: expected zone"),
        ([(1000, CLOCK), (1000, ZONE | {"reason": "daylight"})], "at its end: expected zone"),
        ([(500, CLOCK), (500, ZONE)], "at its end: expected"),
    ],
)
def test_a_step_that_sets_the_zone(events: list[tuple[int, dict[str, Any]]], wrong: str) -> None:
    """It is owed as a call is, with its values; a clock before it may have been right."""
    assert departure(*events).startswith(wrong)
    assert bool(departure(*events)) == bool(wrong)
