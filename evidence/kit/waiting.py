"""Two calls after each other, each for an interrupt that waits: a CPU answers both by the same reading."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from evidence.kit.building import MINUTE, SECOND, at, body, call, header, later, program, set_tint, wait
from s7check.kit.from_log import Json

_CLOCK = "2026-11-21T05:59:30"
_CPUS = ("S7-300", "S7-400", "CPU 318")


def _delay_calls() -> dict[str, list[Json]]:
    return {
        "cancel": [call("CAN_DINT", ob=20)],
        "start": [call("SRT_DINT", ob=20, dtime=3 * SECOND, sign="16#0002")],
        "query": [call("QRY_DINT", ob=20)],
        "cancel-start": [call("CAN_DINT", ob=20), call("SRT_DINT", ob=20, dtime=3 * SECOND, sign="16#0003")],
    }


def _once_calls(start: str) -> dict[str, list[Json]]:
    return {
        "cancel": [call("CAN_TINT", ob=10)],
        "set": [set_tint(10, start, "16#0000")],
        "activate": [call("ACT_TINT", ob=10)],
        "query": [call("QRY_TINT", ob=10)],
    }


def programs() -> Iterator[Json]:
    """A program for each pair of calls, with the interrupt held back by SFC 41 or by an OB of a higher class."""
    kinds = {"delay": _delay_calls(), "once": _once_calls(later(_CLOCK, 30 * SECOND))}
    for kind, calls in kinds.items():
        for number, ((first, one), (second, two)) in enumerate(product(calls.items(), repeat=2)):
            for held in ("delayed", "interrupted"):
                cpu = _CPUS[number % 3]
                steps: list[Json] = []
                outside: list[Json] = []
                for place, now in enumerate((one, two)):
                    begin = place * MINUTE
                    start = later(_CLOCK, begin + 30 * SECOND)
                    setting = [call("SRT_DINT", ob=20, dtime=30 * SECOND, sign=f"16#001{place}")]
                    if kind == "once":
                        setting = [set_tint(10, start, "16#0000"), call("ACT_TINT", ob=10)]
                    if held == "delayed":
                        around = [call("DIS_AIRT"), wait(20 * SECOND), *now, wait(SECOND), call("EN_AIRT")]
                        steps += [*setting, wait(20 * SECOND), *around, wait(19 * SECOND)]
                    else:
                        steps += [*setting, wait(20 * SECOND), wait(20 * SECOND)]
                        outside.append(at(begin + 25 * SECOND, "interrupt", ob=40))
                bodies = [body(1, steps, 1)]
                if held == "interrupted":
                    bodies += [body(40, [wait(10 * SECOND), *now], run) for run, now in ((1, one), (2, two))]
                yield program(
                    f"{'DINT' if kind == 'delay' else 'TINT'}-waiting-{held}-{first}-then-{second}",
                    f"An interrupt that waits, {held}: {first}, and the next time {second}.",
                    ["DINT-14", "DINT-15"] if kind == "delay" else ["TINT-53", "TINT-31"],
                    header(cpu, _CLOCK),
                    3 * MINUTE,
                    bodies,
                    outside,
                )
