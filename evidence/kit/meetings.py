"""Requirements that meet: a start event, a hindrance, a change of the clock, calls meanwhile, missing OBs.

Every pair of levels of two factors is in a program. A program is about the requirements of its levels; which it
reaches is measured.
"""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

from evidence.kit.building import (
    DAY,
    HOUR,
    MINUTE,
    PERIODS,
    SECOND,
    USUAL_OBS,
    at,
    body,
    call,
    header,
    later,
    program,
    set_tint,
    wait,
)
from evidence.kit.covering import Choice, covering
from s7check.kit.from_log import Json

_DUE = 30 * SECOND
"""The moment of the start event, with hindrances around it."""

_CLOCKS = {
    "plain": "2026-11-21T05:59:30",
    "year": "2026-12-31T23:59:30",
    "leap": "2028-02-28T23:59:30",
    "month": "2027-01-31T23:58:30",
}

_FACTORS = {
    "cpu": ("S7-300", "S7-400", "CPU 318"),
    "begin": ("run", "warm", "cold", "startup"),
    "source": (
        *PERIODS,
        "step7 once",
        "step7 minute",
        "step7 hourly",
        "step7 past one-shot interrupt",
        "not activated",
        "delay",
        "delay again",
        "process",
        "hardware",
        "burst",
        "error 82",
        "error 83",
        "time error",
    ),
    "block": ("there", "missing", "deleted", "loaded"),
    "errors": ("80 and 85", "no 80", "no 85", "neither"),
    "hindrance": (
        "none",
        "delayed",
        "delayed twice",
        "delayed by OB 35",
        "higher OB",
        "itself",
        "all disabled",
        "class disabled",
        "OB disabled",
        "OB silent",
        "OB 80 disabled",
        "OB 85 disabled",
        "hold",
        "stop",
        "startup",
    ),
    "clock": ("untouched", "forward over", "forward onto", "far", "back", "back early", "forward meanwhile", "twice"),
    "calls": ("none", "cancel", "set", "activate", "cancel and set", "once more", "query"),
    "where": ("meanwhile", "afterwards", "in the OB", "in OB 80", "in OB 85"),
    "classes": ("default", "higher", "shared"),
}

_OWN_OB = {"delay": 20, "delay again": 20, "process": 35, "hardware": 40, "burst": 35, "error 82": 82, "error 83": 83}
_FROM, _UNTIL = 25 * SECOND, 45 * SECOND
"""The time of a hindrance."""
_MASKS = {
    "all disabled": (0x00, 0),
    "class disabled": (0x01, None),
    "OB disabled": (0x02, None),
    "OB silent": (0x82, None),
    "OB 80 disabled": (0x02, 80),
    "OB 85 disabled": (0x82, 85),
}


_ABOUT: dict[str, dict[str, tuple[str, ...]]] = {
    "source": {
        **dict.fromkeys(PERIODS, ("TINT-23", "TINT-33")),
        **{f"step7 {kind}": ("TINT-04", "TINT-25") for kind in ("once", "minute", "hourly")},
        "step7 past one-shot interrupt": ("OBS-56",),
        "not activated": ("TINT-05",),
        "delay": ("DINT-03",),
        "delay again": ("DINT-07",),
        "burst": ("OBS-08",),
        "error 82": ("OBS-23",),
        "error 83": ("OBS-23",),
        "time error": ("OBS-22", "OBS-26"),
    },
    "block": dict.fromkeys(("missing", "deleted", "loaded"), ("OBS-20",)),
    "errors": {"no 80": ("OBS-22",), "no 85": ("OBS-21",), "neither": ("OBS-21", "OBS-22")},
    "hindrance": {
        "delayed": ("AIRT-01", "AIRT-02"),
        "delayed twice": ("AIRT-03",),
        "delayed by OB 35": ("AIRT-04",),
        "higher OB": ("OBS-01", "OBS-03"),
        "itself": ("OBS-02",),
        "all disabled": ("IRT-06",),
        "class disabled": ("IRT-07",),
        "OB disabled": ("IRT-08",),
        "OB silent": ("IRT-09",),
        "OB 80 disabled": ("OBS-33",),
        "OB 85 disabled": ("IRT-09",),
        "hold": ("OBS-45", "OBS-46"),
        "stop": ("OBS-41", "OBS-50"),
        "startup": ("OBS-42", "OBS-44"),
    },
    "clock": {
        **dict.fromkeys(("forward over", "forward onto", "far", "forward meanwhile"), ("CLK-02", "CLK-03")),
        **dict.fromkeys(("back", "back early", "twice"), ("CLK-09", "CLK-10")),
    },
}
"""The requirements that a level is about."""


def programs(seed: int) -> Iterator[Json]:
    """The programs that the seed gives."""
    random = Random(seed)  # noqa: S311
    for number, choice in enumerate(covering(_FACTORS, 2, _fits, random), 1):
        yield _Meeting(choice).program(number, seed)


def _fits(choice: Choice) -> bool:
    if choice["cpu"] == "S7-300" and choice["classes"] != "default":
        return False
    if choice["source"] in ("error 83", "time error", "burst") and choice["calls"] not in ("none", "query"):
        return False
    if choice["hindrance"] == "startup" and choice["begin"] == "run":
        return False
    return choice["source"] not in ("time error", "burst") or choice["block"] == "there"


class _Meeting:
    def __init__(self, choice: Choice) -> None:
        self._choice = choice
        self._clock = _CLOCKS[("plain", "year", "leap", "month")[sum(map(len, choice.values())) % 4]]
        self._ob = _OWN_OB.get(choice["source"], 80 if choice["source"] == "time error" else 10)
        self._start = later(self._clock, _DUE)
        self._code = PERIODS.get(choice["source"], "16#0201")

    def program(self, number: int, seed: int) -> Json:
        choice = self._choice
        about = ", ".join(f"{name}: {level}" for name, level in choice.items() if level not in ("none", "default"))
        area = "DINT" if self._ob == 20 else "TINT" if self._ob == 10 else "OBS"
        made = program(
            f"{area}-meeting-{number:04}",
            f"{choice['source'].capitalize()} meets {choice['hindrance']}; {about}.",
            self._requirements(),
            self._header(),
            4 * MINUTE,
            self._bodies(),
            self._outside(),
        )
        return {**made, "seed": seed}

    def _requirements(self) -> list[str]:
        named = (_ABOUT[name].get(level, ()) for name, level in self._choice.items() if name in _ABOUT)
        return list(dict.fromkeys(one for names in named for one in names))

    def _header(self) -> Json:
        choice = self._choice
        obs = {*USUAL_OBS, self._ob}
        if choice["block"] in ("missing", "loaded"):
            obs.discard(self._ob)
        obs -= {"no 80": {80}, "no 85": {85}, "neither": {80, 85}}.get(choice["errors"], set())
        mode = {"run": "RUN", "startup": "STARTUP"}.get(choice["begin"], "STOP")
        more: Json = {}
        if choice["classes"] == "higher" and self._ob in (10, 20, 35, 40):
            more["priority"] = {str(self._ob): 20}
        elif choice["classes"] == "shared":
            more["priority"] = {"10": 9, "20": 9, "35": 9}
        if choice["source"].startswith("step7"):
            kind = choice["source"].removeprefix("step7 ")
            start = later(self._clock, -DAY) if kind == "past one-shot interrupt" else self._start
            execution = "once" if kind == "past one-shot interrupt" else kind
            more["step7"] = {"tod": {"10": {"execution": execution, "start": start, "active": True}}}
        return header(choice["cpu"], self._clock, mode, tuple(sorted(obs)), **more)

    def _setting(self) -> list[Json]:
        """The steps that bring about the start event at its moment."""
        source = self._choice["source"]
        if source in PERIODS:
            return [set_tint(10, self._start, self._code), call("ACT_TINT", ob=10)]
        if source == "not activated":
            return [set_tint(10, self._start, self._code)]
        if source == "delay":
            return [call("SRT_DINT", ob=20, dtime=_DUE - 2 * SECOND, sign="16#0011")]
        if source == "delay again":
            return [
                call("SRT_DINT", ob=20, dtime=5 * SECOND, sign="16#0011"),
                call("SRT_DINT", ob=20, dtime=_DUE - 2 * SECOND, sign="16#0012"),
            ]
        return []

    def _calls(self) -> list[Json]:
        kind, ob = self._choice["calls"], self._ob
        if ob == 20:
            start = [call("SRT_DINT", ob=20, dtime=10 * SECOND, sign="16#0022")]
            cancel, query = [call("CAN_DINT", ob=20)], [call("QRY_DINT", ob=20)]
            activate: list[Json] = []
        elif ob == 10:
            start = [set_tint(10, self._start, self._code)]
            cancel, query = [call("CAN_TINT", ob=10)], [call("QRY_TINT", ob=10)]
            activate = [call("ACT_TINT", ob=10)]
        else:
            start = cancel = query = [call("DIS_IRT", mode=0x02, ob=ob), call("EN_IRT", mode=0x02, ob=ob)]
            activate = []
        return {
            "none": [],
            "cancel": [*query, *cancel],
            "set": start,
            "activate": activate,
            "cancel and set": [*cancel, *start, *activate],
            "once more": [*start, *activate],
            "query": query,
        }[kind]

    def _bodies(self) -> list[Json]:
        choice = self._choice
        calls = {where: self._calls() if choice["where"] == where else [] for where in _FACTORS["where"]}
        startup = {"warm": 100, "startup": 100, "cold": 102}.get(choice["begin"])
        first: list[Json] = self._setting()
        main = [wait(2 * SECOND)] if startup else [*first, wait(2 * SECOND)]
        before, after = self._around()
        main += [wait(_FROM - 4 * SECOND), *before, wait(8 * SECOND), *calls["meanwhile"], wait(12 * SECOND)]
        main += [*after, wait(10 * SECOND), *calls["afterwards"]]
        bodies = [body(1, main, 1)]
        if startup:
            busy = [wait(_UNTIL)] if choice["hindrance"] == "startup" else []
            bodies.append(body(startup, [*first, *busy], 1))
        own = [*calls["in the OB"], wait(70 * SECOND if choice["hindrance"] == "itself" else 20)]
        bodies.append(body(self._ob, own, 1))
        if self._ob != 80:
            bodies.append(body(80, [*calls["in OB 80"], wait(15)]))
        bodies.append(body(85, [*calls["in OB 85"], wait(10)]))
        if choice["hindrance"] == "delayed by OB 35" and self._ob != 35:
            bodies.append(body(35, [call("DIS_AIRT"), wait(12 * SECOND), call("DIS_AIRT"), wait(SECOND)], 1))
        if choice["hindrance"] == "higher OB":
            bodies.append(body(86, [wait(12 * SECOND)], 1))
        return bodies

    def _around(self) -> tuple[list[Json], list[Json]]:
        """Calls of OB 1 that begin and end the hindrance."""
        hindrance = self._choice["hindrance"]
        if hindrance == "delayed":
            return [call("DIS_AIRT")], [call("EN_AIRT")]
        if hindrance == "delayed twice":
            twice = [call("EN_AIRT"), wait(SECOND), call("EN_AIRT"), call("EN_AIRT")]
            return [call("DIS_AIRT"), call("DIS_AIRT")], twice
        if hindrance in _MASKS:
            mode, ob = _MASKS[hindrance]
            masked = self._ob if ob is None else ob
            return [call("DIS_IRT", mode=mode, ob=masked)], [call("EN_IRT", mode=mode & 0x7F, ob=masked)]
        return [], []

    def _outside(self) -> list[Json]:
        return [*self._begin(), *self._event(), *self._block(), *self._hindrance(), *self._clock_set()]

    def _begin(self) -> list[Json]:
        kind = self._choice["begin"]
        return [at(SECOND, "restart", type=kind)] if kind in ("warm", "cold") else []

    def _event(self) -> list[Json]:
        source = self._choice["source"]
        number = {"burst": 20, "time error": 2}.get(source, 1)
        if source == "time error":
            return [at(_DUE + 1000 * place, "interrupt", ob=80, flt_id="16#01") for place in range(number)]
        if source in ("process", "hardware", "burst", "error 82", "error 83"):
            return [at(_DUE + place, "interrupt", ob=self._ob) for place in range(number)]
        return []

    def _block(self) -> list[Json]:
        kind = self._choice["block"]
        if kind == "deleted":
            return [at(_DUE - 2 * SECOND, "delete", ob=self._ob), at(100 * SECOND, "load", ob=self._ob)]
        return [at(_DUE - 2 * SECOND, "load", ob=self._ob)] if kind == "loaded" else []

    def _hindrance(self) -> list[Json]:
        kind = self._choice["hindrance"]
        if kind == "hold":
            return [at(_FROM, "hold"), at(_UNTIL, "release")]
        if kind == "stop":
            return [at(_FROM, "stop"), at(_UNTIL, "restart", type="warm")]
        if kind == "delayed by OB 35":
            return [at(_FROM, "interrupt", ob=35)]
        if kind == "higher OB":
            return [at(_FROM, "load", ob=86), at(_FROM + 1, "interrupt", ob=86)]
        if kind == "itself" and self._ob in (35, 40):
            return [at(_DUE + 20 * SECOND, "interrupt", ob=self._ob)]
        return []

    def _clock_set(self) -> list[Json]:
        """Beside changes of the clock a look at the next point of a long period."""
        kind = self._choice["clock"]
        jumps = {
            "untouched": [],
            "forward over": [(10 * SECOND, 2 * MINUTE)],
            "far": [(10 * SECOND, 40 * DAY + 3 * HOUR)],
            "back": [(60 * SECOND, -45 * SECOND)],
            "back early": [(10 * SECOND, -3 * MINUTE)],
            "forward meanwhile": [(35 * SECOND, 5 * MINUTE)],
            "twice": [(35 * SECOND, 10 * MINUTE), (50 * SECOND, -12 * MINUTE)],
            "forward onto": [],
        }[kind]
        made = [at(after, "clock", by=by) for after, by in jumps]
        if kind == "forward onto":
            made.append(at(12 * SECOND, "clock", to=self._start))
        length = {"hourly": HOUR, "daily": DAY, "weekly": 7 * DAY, "monthly": 31 * DAY, "yearly": 365 * DAY}.get(
            self._choice["source"].removeprefix("step7 ")
        )
        if length is not None and kind == "untouched":
            made.append(at(100 * SECOND, "clock", by=length - 100 * SECOND))
        return made
