"""Counts to every depth and one beyond, and each interrupt against each other of its kind."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

from evidence.kit.building import MINUTE, SECOND, at, body, call, header, later, program, set_tint, wait
from s7check.kit.from_log import Json

_CLOCK = "2026-11-21T05:59:30"
_CPUS = ("S7-300", "S7-400", "CPU 318")

_DEPTHS = (*range(1, 10), 15, 16, 17, 31, 32, 33, 127, 128, 129, 255, 256, 257)
"""Each small one, and those around which a counter may be too narrow."""


def programs() -> Iterator[Json]:
    """For each depth a program by CPU; for each pair of OBs of a kind a program by what one does to the other."""
    for number, depth in enumerate(_DEPTHS):
        yield from _depth(depth, _CPUS[number % 3])
    for number, (one, other) in enumerate(permutations((20, 21, 22, 23), 2)):
        yield from _delays(one, other, _CPUS[number % 3])
    for number, (one, other) in enumerate(permutations((10, 11, 13, 17), 2)):
        yield from _points(one, other, _CPUS[number % 3])
    for cpu in _CPUS:
        yield from _no_startup_ob(cpu)


def _depth(depth: int, cpu: str) -> Iterator[Json]:
    """So many delays, all taken back one by one, with a start event that waits, and one taken back too many."""
    down = [call("DIS_AIRT") for _ in range(depth)]
    up = [step for _ in range(depth) for step in (call("EN_AIRT"), wait(1))]
    yield program(
        f"AIRT-nesting-{depth:03}",
        f"{depth} DIS_AIRT, as many EN_AIRT and one more: OB 35 starts after the last of them.",
        ["AIRT-03", "AIRT-06", "AIRT-07"],
        header(cpu, _CLOCK),
        10 * SECOND,
        [body(1, [*down, wait(2 * SECOND), *up, call("EN_AIRT")], 1)],
        [at(SECOND, "interrupt", ob=35)],
    )
    yield program(
        f"AIRT-nesting-{depth:03}-left",
        f"{depth} DIS_AIRT in OB 35, none taken back: the end of OB 35 ends them.",
        ["AIRT-04", "AIRT-06"],
        header(cpu, _CLOCK),
        10 * SECOND,
        [body(1, [wait(3 * SECOND), call("EN_AIRT")], 1), body(35, [*down, wait(SECOND)], 1)],
        [at(SECOND, "interrupt", ob=35), at(SECOND + 500, "interrupt", ob=40)],
    )


def _delays(one: int, other: int, cpu: str) -> Iterator[Json]:
    """A delay runs while another is started, started again, cancelled, or elapses."""
    obs = (1, 20, 21, 22, 23, 35, 80, 85, 100)
    started = call("SRT_DINT", ob=other, dtime=20 * SECOND, sign="16#0002")
    query = [call("QRY_DINT", ob=one), call("QRY_DINT", ob=other)]
    steps = {
        "start": [started, *query],
        "again": [started, wait(SECOND), started, *query],
        "cancel": [started, wait(SECOND), call("CAN_DINT", ob=other), *query],
        "elapse": [call("SRT_DINT", ob=other, dtime=2 * SECOND, sign="16#0002"), wait(3 * SECOND), *query],
    }
    for name, taken in steps.items():
        first = call("SRT_DINT", ob=one, dtime=10 * SECOND, sign="16#0001")
        yield program(
            f"DINT-beside-{one}-{other}-{name}",
            f"OB {one} waits for its delay, and OB {other} does its own: {name}.",
            ["DINT-01", "DINT-03"],
            header(cpu, _CLOCK, obs=obs),
            MINUTE,
            [body(1, [first, wait(2 * SECOND), *taken, wait(15 * SECOND), *query], 1)],
        )


def _points(one: int, other: int, cpu: str) -> Iterator[Json]:
    """A time-of-day interrupt is active while another one is set, activated and cancelled."""
    obs = (1, 10, 11, 13, 17, 80, 85, 100)
    query = [call("QRY_TINT", ob=one), call("QRY_TINT", ob=other)]
    setting = [set_tint(other, later(_CLOCK, 90 * SECOND), "16#0201"), *query, call("ACT_TINT", ob=other), *query]
    cancel = [call("CAN_TINT", ob=other), *query]
    first = [set_tint(one, later(_CLOCK, 30 * SECOND), "16#0201"), call("ACT_TINT", ob=one)]
    yield program(
        f"TINT-beside-{one}-{other}",
        f"OB {one} comes every minute while OB {other} is set, activated and cancelled.",
        ["TINT-01", "TINT-33"],
        header(cpu, _CLOCK, obs=obs),
        5 * MINUTE,
        [body(1, [*first, wait(SECOND), *setting, wait(100 * SECOND), *cancel, wait(70 * SECOND), *query], 1)],
    )


def _no_startup_ob(cpu: str) -> Iterator[Json]:
    """STARTUP without the OB that it calls."""
    obs = (1, 10, 35, 80, 85)
    for mode, outside in (("STARTUP", []), ("STOP", [at(SECOND, "restart", type="warm")])):
        yield program(
            f"OBS-no-startup-OB-{cpu.replace(' ', '-')}-{mode}",
            f"STARTUP from {mode} without OB 100: RUN follows at once.",
            ["OBS-42"],
            header(cpu, _CLOCK, mode, obs),
            10 * SECOND,
            [body(1, [call("DIS_AIRT"), wait(SECOND), call("EN_AIRT")], 1)],
            [*outside, at(3 * SECOND, "interrupt", ob=35)],
        )
