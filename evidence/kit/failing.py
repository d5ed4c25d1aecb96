"""Synchronous errors: OB 121 and OB 122 on top of the OB that fails, whatever SFC 39 and 41 say."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

from evidence.kit.building import SECOND, USUAL_OBS, at, body, call, header, program, set_tint, wait
from evidence.kit.covering import Choice, covering
from s7check.kit.from_log import Json

_CLOCK = "2026-11-21T05:59:30"
_ERROR = 8 * SECOND

_FACTORS = {
    "cpu": ("S7-300", "S7-400", "CPU 318"),
    "error OB": ("121", "122"),
    "fails": ("OB 1", "OB 10", "OB 35", "OB 80", "OB 85", "OB 100"),
    "block": ("there", "missing", "deleted", "loaded"),
    "hindrance": ("none", "delayed", "all disabled", "all silent", "OB disabled"),
    "meanwhile": ("nothing", "higher class", "same class", "lower class", "time error", "stop", "hold"),
    "second": ("none", "the same", "the other", "the other missing"),
    "calls": ("nothing", "one more delay", "delay released"),
}
_MASKS = {"all disabled": (0x00, 0), "all silent": (0x80, 0), "OB disabled": (0x02, 40)}
_CHANGED = {"deleted": "delete", "loaded": "load"}
_NAMED = {"higher class": 82, "same class": 36, "lower class": 33}


def programs(seed: int) -> Iterator[Json]:
    """Every pair of levels is in a program."""
    for number, choice in enumerate(covering(_FACTORS, 2, lambda _: True, Random(seed)), 1):  # noqa: S311
        yield {**_program(number, choice), "seed": seed}


def _program(number: int, choice: Choice) -> Json:
    ob, fails = int(choice["error OB"]), int(choice["fails"].split()[1])
    other = 243 - ob
    obs = {*USUAL_OBS, 33, 36, 121, 122}
    obs -= ({ob} if choice["block"] in ("missing", "loaded") else set()) | (
        {other} if choice["second"] == "the other missing" else set()
    )
    requirements = ["OBS-61", "OBS-62", *(["OBS-27", "OBS-63"] if {121, 122} - obs else [])]
    requirements += {"none": [], "delayed": ["AIRT-10"]}.get(choice["hindrance"], ["IRT-05", "IRT-23"])
    return program(
        f"OBS-failing-{number:03}",
        f"An instruction fails; {', '.join(f'{name}: {level}' for name, level in choice.items())}.",
        requirements,
        header(choice["cpu"], _CLOCK, "STARTUP" if fails == 100 else "RUN", tuple(sorted(obs))),
        60 * SECOND,
        _bodies(choice, ob, fails),
        [*_begun(fails), *_events(choice, ob, other)],
    )


def _bodies(choice: Choice, ob: int, fails: int) -> list[Json]:
    hindered = {"none": [], "delayed": [call("DIS_AIRT")]}.get(choice["hindrance"])
    if hindered is None:
        mode, named = _MASKS[choice["hindrance"]]
        hindered = [call("DIS_IRT", mode=mode, ob=named)]
    steps = [wait(4 * SECOND), *hindered, wait(8 * SECOND), call("EN_AIRT"), wait(SECOND), call("EN_AIRT")]
    calls = {"one more delay": [call("DIS_AIRT")], "delay released": [call("EN_AIRT")]}.get(choice["calls"], [])
    setting = [set_tint(10, "2026-11-21T05:59", "16#0201"), call("ACT_TINT", ob=10)]
    bodies = [body(ob, [wait(500), *calls, wait(2 * SECOND)]), body(243 - ob, [*calls, wait(300)])]
    if fails != 1:
        bodies.append(body(1, [*(setting if fails == 10 else []), wait(40 * SECOND)], 1))
    return [*bodies, body(fails, steps, 1)]


def _begun(fails: int) -> Iterator[Json]:
    """The OB that fails is at work from about the second second on."""
    fault = {80: {"flt_id": "16#01"}, 85: {"flt_id": "16#A3"}}.get(fails, {})
    if fails == 10:
        yield at(SECOND, "clock", to="2026-11-21T05:59:58")
    elif fails not in (1, 100):
        yield at(2 * SECOND, "interrupt", ob=fails, **fault)


def _events(choice: Choice, ob: int, other: int) -> Iterator[Json]:
    if choice["block"] in _CHANGED:
        yield at(_ERROR - SECOND, _CHANGED[choice["block"]], ob=ob)
    yield at(_ERROR, "interrupt", ob=ob)
    if choice["second"] != "none":
        yield at(_ERROR + 1500, "interrupt", ob=ob if choice["second"] == "the same" else other)
    meanwhile = choice["meanwhile"]
    if meanwhile in _NAMED:
        yield at(_ERROR + SECOND, "interrupt", ob=_NAMED[meanwhile])
    elif meanwhile == "time error":
        yield at(_ERROR + SECOND, "interrupt", ob=80, flt_id="16#01")
    elif meanwhile == "stop":
        yield from (at(_ERROR + SECOND, "stop"), at(_ERROR + 4 * SECOND, "restart", type="warm"))
    elif meanwhile == "hold":
        yield from (at(_ERROR + SECOND, "hold"), at(_ERROR + 4 * SECOND, "release"))
