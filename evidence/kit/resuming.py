"""Hot restarts of an S7-400: what was at work, waited, was blocked or delayed at the STOP goes on after it."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

from evidence.kit.building import MINUTE, SECOND, USUAL_OBS, at, body, call, header, later, program, set_tint, wait
from evidence.kit.covering import Choice, covering
from s7check.kit.from_log import Json

_CLOCK = "2026-11-21T05:59:30"
_STOP, _GO = 10 * SECOND, 40 * SECOND

_FACTORS = {
    "source": ("none", "delay", "late delay", "minute", "once", "process", "hardware", "diagnostic"),
    "at work": ("OB 1", "OB 40", "OB 40 in OB 35", "OB 121 in OB 35", "OB 80"),
    "delayed": ("no", "by OB 1", "by each OB"),
    "blocked": ("nothing", "all", "class", "OB, silent"),
    "stop": ("switch", "no OB 122", "hold"),
    "in STOP": ("nothing", "clock forward", "clock back", "interrupt", "delete", "load"),
    "OB 101": ("idle", "missing", "busy", "calls"),
    "then": ("nothing", "hot again", "hot from STARTUP", "warm"),
}
_OWN_OB = {"delay": 20, "late delay": 20, "minute": 10, "once": 10, "process": 35, "hardware": 40, "diagnostic": 82}
_MODES = {"all": 0x00, "class": 0x01, "OB, silent": 0x82}


def programs(seed: int) -> Iterator[Json]:
    """Every pair of levels is in a program."""
    for number, choice in enumerate(covering(_FACTORS, 2, lambda _: True, Random(seed)), 1):  # noqa: S311
        yield {**_program(number, choice), "seed": seed}


def _program(number: int, choice: Choice) -> Json:
    ob = _OWN_OB.get(choice["source"], 35)
    obs = {*USUAL_OBS, 101, 121} - ({101} if choice["OB 101"] == "missing" else set())
    about = ", ".join(f"{name}: {level}" for name, level in choice.items())
    return program(
        f"OBS-resuming-{number:03}",
        f"A hot restart meets what STOP has interrupted; {about}.",
        ["OBS-52", "OBS-53", "OBS-54"],
        header("S7-400", _CLOCK, obs=tuple(sorted(obs))),
        4 * MINUTE,
        _bodies(choice, ob),
        [*_until_stop(choice, ob), *_in_stop(choice, ob), *_restarts(choice, ob)],
    )


def _bodies(choice: Choice, ob: int) -> list[Json]:
    source = {
        "delay": [call("SRT_DINT", ob=20, dtime=20 * SECOND, sign="16#0011")],
        "late delay": [call("SRT_DINT", ob=20, dtime=50 * SECOND, sign="16#0011")],
        "minute": [set_tint(10, later(_CLOCK, 30 * SECOND), "16#0201"), call("ACT_TINT", ob=10)],
        "once": [set_tint(10, later(_CLOCK, 30 * SECOND), "16#0000"), call("ACT_TINT", ob=10)],
    }.get(choice["source"], [])
    query = {20: [call("QRY_DINT", ob=20)], 10: [call("QRY_TINT", ob=10)]}.get(ob, [])
    mode = _MODES.get(choice["blocked"], 0)
    masked = call("DIS_IRT", mode=mode, ob={0x00: 0, 0x01: ob // 10 * 10}.get(mode, ob))
    blocked = [] if choice["blocked"] == "nothing" else [masked]
    released = [call("EN_AIRT"), wait(SECOND), call("EN_AIRT")]
    own = [call("DIS_AIRT")] if choice["delayed"] == "by each OB" else []
    first = [*source, *blocked, wait(6 * SECOND), *([] if choice["delayed"] == "no" else [call("DIS_AIRT")])]
    last = [wait(12 * SECOND), *query, *released, call("EN_IRT", mode=0, ob=0), wait(30 * SECOND), *query]
    startup = {"busy": [wait(8 * SECOND)], "calls": [*query, call("DIS_AIRT"), *released, *query, wait(100)]}
    above = [body(one, [*own, wait(8 * SECOND), *query, *released]) for one in (35, 40, 80, 121)]
    return [body(1, [*first, *last], 1), *above, body(101, startup.get(choice["OB 101"], []))]


def _until_stop(choice: Choice, ob: int) -> Iterator[Json]:
    began = {"OB 80": 80, "OB 40": 40}.get(choice["at work"], 35)
    if choice["at work"] != "OB 1":
        yield at(5 * SECOND, "interrupt", ob=began, **({"flt_id": "16#01"} if began == 80 else {}))
    if choice["at work"].endswith("in OB 35"):
        yield at(5 * SECOND + 300, "interrupt", ob=int(choice["at work"].split()[1]))
    if choice["source"] in ("process", "hardware", "diagnostic"):
        yield at(8 * SECOND, "interrupt", ob=ob)
    if choice["stop"] == "hold":
        yield at(_STOP - SECOND, "hold")
    yield at(_STOP, "interrupt", ob=122) if choice["stop"] == "no OB 122" else at(_STOP, "stop")


def _in_stop(choice: Choice, ob: int) -> Iterator[Json]:
    jumps = {"clock forward": 5 * MINUTE, "clock back": -2 * MINUTE}
    if choice["in STOP"] in jumps:
        yield at(20 * SECOND, "clock", by=jumps[choice["in STOP"]])
    elif choice["in STOP"] != "nothing":
        yield at(20 * SECOND, choice["in STOP"], ob=35 if choice["in STOP"] == "interrupt" else ob)


def _restarts(choice: Choice, ob: int) -> Iterator[Json]:
    yield at(_GO, "restart", type="hot")
    if choice["OB 101"] == "busy" and ob in (35, 40, 82):
        yield at(_GO + 2 * SECOND, "interrupt", ob=ob)
    if choice["then"] == "hot from STARTUP":
        yield from (at(_GO + 3 * SECOND, "stop"), at(_GO + 5 * SECOND, "restart", type="hot"))
    elif choice["then"] != "nothing":
        kind = choice["then"].split()[0]
        yield from (at(_GO + 14 * SECOND, "stop"), at(_GO + 60 * SECOND, "restart", type=kind))
