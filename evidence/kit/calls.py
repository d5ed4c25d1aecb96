"""Every call with every class of operands, from every place a call can come from."""

from __future__ import annotations

from collections.abc import Iterator

from evidence.kit.building import MINUTE, SECOND, at, body, call, header, program, set_tint, wait
from s7check.kit.from_log import Json

_CLOCK = "2028-02-28T05:59:30"
_PAST, _NEXT = "2028-02-28T05:58", "2028-02-28T06:05"


def _time_of_day() -> list[Json]:
    """Before anything is set, wrong operands, set, active, cancelled, past."""
    wrong_obs = (9, 18, 0, -1, 99, 32767)
    dates = (
        "2028-02-30T06:00",
        "2027-02-29T06:00",
        "2028-13-01T06:00",
        "2028-00-10T06:00",
        "2028-01-00T06:00",
        "2028-04-31T06:00",
        "2028-02-28T24:00",
        "2028-02-28T06:60",
        "1989-12-31T06:00",
        "2090-01-01T00:00",
        "2028-02-28T06:05:60",
    )
    periods = ("16#0200", "16#0202", "16#1203", "16#1402", "16#2002", "16#FFFF", "16#0001", "16#8201")
    return [
        call("QRY_TINT", ob=10),
        call("ACT_TINT", ob=10),
        call("CAN_TINT", ob=10),
        *(set_tint(ob, _NEXT, "16#0201") for ob in wrong_obs),
        *(call(name, ob=ob) for name in ("CAN_TINT", "ACT_TINT", "QRY_TINT") for ob in (9, 18, 20, -1)),
        *(set_tint(10, date, "16#0201") for date in dates),
        *(set_tint(10, _NEXT, period) for period in periods),
        *(set_tint(10, f"2028-03-{day:02}T06:00", "16#1401") for day in (28, 29, 31)),
        set_tint(10, _PAST, "16#0000"),
        set_tint(10, _PAST, "16#0201"),
        call("QRY_TINT", ob=10),
        call("ACT_TINT", ob=10),
        call("ACT_TINT", ob=10),
        call("QRY_TINT", ob=10),
        call("CAN_TINT", ob=10),
        call("CAN_TINT", ob=10),
        call("QRY_TINT", ob=10),
        set_tint(10, _NEXT, "16#0000"),
        call("QRY_TINT", ob=10),
        call("ACT_TINT", ob=10),
        set_tint(10, _NEXT, "16#0201"),
        call("QRY_TINT", ob=10),
        set_tint(17, _NEXT, "16#0401"),
        call("ACT_TINT", ob=17),
        call("QRY_TINT", ob=17),
        call("CAN_TINT", ob=17),
        {"event": "clock", "by": MINUTE},
        set_tint(11, "2028-02-28T06:02", "16#0000"),
        {"event": "clock", "by": 10 * MINUTE},
        call("QRY_TINT", ob=11),
        call("ACT_TINT", ob=11),
        call("QRY_TINT", ob=11),
        call("CAN_TINT", ob=11),
    ]


def _delay() -> list[Json]:
    times = (0, -1, -2147483648, 60_001, 2147483647, "T#1m1ms")
    return [
        call("QRY_DINT", ob=20),
        call("CAN_DINT", ob=20),
        *(call("SRT_DINT", ob=ob, dtime=1000, sign="16#0001") for ob in (19, 24, 0, -1, 99)),
        *(call(name, ob=ob) for name in ("CAN_DINT", "QRY_DINT") for ob in (19, 24, 10)),
        *(call("SRT_DINT", ob=20, dtime=time, sign="16#0001") for time in times),
        call("SRT_DINT", ob=20, dtime=60_000, sign="16#FFFF"),
        call("QRY_DINT", ob=20),
        call("SRT_DINT", ob=20, dtime=1, sign="16#0002"),
        call("SRT_DINT", ob=21, dtime=500, sign="16#0003"),
        wait(100),
        call("QRY_DINT", ob=20),
        call("QRY_DINT", ob=21),
        call("CAN_DINT", ob=21),
        call("CAN_DINT", ob=21),
        call("SRT_DINT", ob=22, dtime=200, sign=-1),
        wait(300),
        call("QRY_DINT", ob=22),
        call("SRT_DINT", ob=23, dtime=3, sign=0),
    ]


def _masks() -> list[Json]:
    modes = (0x00, 0x01, 0x02, 0x80, 0x81, 0x82, 0x03, 0x83, 0x7F, 0xFF)
    obs = (1, 10, 17, 20, 30, 35, 40, 55, 60, 70, 80, 81, 85, 87, 88, 100, 102, 121, 0, 99)
    return [
        *(call("EN_IRT", mode=mode, ob=10) for mode in modes),
        *(
            step
            for mode in modes
            for step in (call("DIS_IRT", mode=mode, ob=0), call("EN_IRT", mode=mode & 0x7F, ob=0))
        ),
        *(call("DIS_IRT", mode=mode, ob=ob) for mode in (0x01, 0x02, 0x82) for ob in obs),
        *(call("EN_IRT", mode=mode, ob=ob) for mode in (0x01, 0x02) for ob in obs),
        call("EN_IRT", mode=0, ob=0),
    ]


def _counted() -> list[Json]:
    return [
        call("EN_AIRT"),
        *(call(name) for name in ["DIS_AIRT"] * 3 + ["EN_AIRT"] * 4),
        call("DIS_AIRT"),
        wait(20),
        call("DIS_AIRT"),
        wait(20),
        call("EN_AIRT"),
        wait(20),
        call("EN_AIRT"),
        call("EN_AIRT"),
        call("DIS_AIRT"),
        wait(20),
    ]


_SUITES = {
    "TINT": (_time_of_day, ["TINT-30", "TINT-35", "TINT-36", "TINT-51", "TINT-61", "TINT-70", "TINT-71"]),
    "DINT": (_delay, ["DINT-03", "DINT-04", "DINT-14", "DINT-16"]),
    "IRT": (_masks, ["IRT-04", "IRT-05", "IRT-06", "IRT-24"]),
    "AIRT": (_counted, ["AIRT-03", "AIRT-04", "AIRT-06", "AIRT-07"]),
}

_PLACES = {
    "OB 1": (1, "RUN", []),
    "OB 1 of a later cycle": (1, "RUN", []),
    "warm STARTUP": (100, "STOP", [at(1 * SECOND, "restart", type="warm")]),
    "cold STARTUP": (102, "STOP", [at(1 * SECOND, "restart", type="cold")]),
    "OB 10": (10, "RUN", []),
    "OB 20": (20, "RUN", []),
    "OB 35": (35, "RUN", [at(2 * SECOND, "interrupt", ob=35)]),
    "OB 40": (40, "RUN", [at(2 * SECOND, "interrupt", ob=40)]),
    "OB 80": (80, "RUN", [at(2 * SECOND, "interrupt", ob=80, flt_id="16#01")]),
    "OB 82": (82, "RUN", [at(2 * SECOND, "interrupt", ob=82)]),
    "OB 85": (85, "RUN", [at(2 * SECOND, "interrupt", ob=47)]),
}

_CPUS = ("S7-300", "S7-400", "CPU 318")


def programs() -> Iterator[Json]:
    """A program for each area of calls, place and family."""
    for area, (steps, requirements) in _SUITES.items():
        for place, (ob, mode, outside) in _PLACES.items():
            for cpu in _CPUS:
                first: list[Json] = []
                if place == "OB 10":
                    first = [set_tint(10, "2028-02-28T06:00", "16#0000"), call("ACT_TINT", ob=10)]
                elif place == "OB 20":
                    first = [call("SRT_DINT", ob=20, dtime=2 * SECOND, sign="16#0010")]
                run = 2 if "later" in place else 1
                bodies = [body(1, first, 1), body(ob, steps(), run)] if first or run == 2 else [body(ob, steps(), run)]
                name = f"{area}-calls-{place.replace(' ', '-')}-{cpu.replace(' ', '-')}"
                about = f"Right and wrong calls in {place}; CPU: {cpu}."
                yield program(name, about, requirements, header(cpu, _CLOCK, mode), 3 * MINUTE, bodies, outside)
        yield from _alone(area, steps(), requirements)


def _alone(area: str, steps: list[Json], requirements: list[str]) -> Iterator[Json]:
    """The operands of each call by itself, for a CPU that offers no other call."""
    for called in dict.fromkeys(step["call"] for step in steps if "call" in step):
        for cpu in _CPUS:
            own = [step for step in steps if step.get("call") == called]
            name = f"{area}-{called.replace('_', '-')}-alone-{cpu.replace(' ', '-')}"
            about = f"Right and wrong operands of {called}, and of no other call; CPU: {cpu}."
            yield program(name, about, requirements, header(cpu, _CLOCK), 3 * MINUTE, [body(1, own, 1)])
