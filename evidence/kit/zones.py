"""Changes of local time on an S7-1500: a start point that is skipped or comes again, and what is in its way.

Every pair of levels of two factors is in a program.
"""

from __future__ import annotations

from collections.abc import Iterator
from random import Random

from evidence.kit.building import MINUTE, SECOND, at, body, call, header, program, wait
from evidence.kit.covering import Choice, covering
from s7check.kit.from_log import Json

_CLOCK, _ZONE = "2027-03-28T00:50:00", 60
_CHANGE = 10 * MINUTE
"""When local time is 02:00."""

_FACTORS = {
    "start": ("STEP 7, local", "SET_TINTL, local", "SET_TINTL"),
    "period": ("once", "minute", "daily"),
    "point": ("before", "behind", "far"),
    "change": ("ahead by daylight saving", "back by daylight saving", "ahead", "back", "ahead and back"),
    "by": ("outside", "OB 1", "OB 10"),
    "hindrance": ("none", "delayed", "hold", "stop", "disabled", "missing"),
    "OB 80": ("there", "missing"),
}
_POINTS = {"before": "01:58", "behind": "02:02", "far": "05:30"}
_CODES = {"once": 0x0000, "minute": 0x0201, "daily": 0x1001}
_MASKS = {
    "delayed": (call("DIS_AIRT"), call("EN_AIRT")),
    "disabled": (call("DIS_IRT", mode=0x02, ob=10), call("EN_IRT", mode=0x02, ob=10)),
}


def programs(seed: int) -> Iterator[Json]:
    """The programs that the seed gives."""
    for number, choice in enumerate(covering(_FACTORS, 2, _fits, Random(seed)), 1):  # noqa: S311
        yield {**_program(choice, number), "seed": seed}


def _fits(choice: Choice) -> bool:
    return choice["by"] != "OB 10" or (choice["period"] == "minute" and choice["hindrance"] == "none")


def _changes(change: str) -> list[tuple[int, Json]]:
    """How long after the change local time is set, and to what."""
    daylight = change.endswith("saving")
    by = (60 if daylight else 5) * (-1 if change.startswith("back") else 1)
    first = {"zone": _ZONE + by, "reason": "daylight" if daylight else "zone"}
    return [(0, first), *([(MINUTE, {"zone": _ZONE, "reason": "zone"})] if change == "ahead and back" else [])]


def _program(choice: Choice, number: int) -> Json:
    changes = _changes(choice["change"])
    steps = [{"event": "zone", **one} for _, one in changes]
    local = choice["start"].endswith("local")
    start = f"2027-03-28T{_POINTS[choice['point']]}" if local else "2027-03-28T01:02"
    more: Json = {"zone": _ZONE}
    own: list[Json] = []
    if choice["start"] == "STEP 7, local":
        given = {"execution": choice["period"], "start": start, "active": True, "local": True}
        more["step7"] = {"tod": {"10": given}}
    else:
        own.append(call("SET_TINTL", ob=10, sdt=start, local=local, period=_CODES[choice["period"]], activate=True))
    begin, end = ([one] if one else [] for one in _MASKS.get(choice["hindrance"], ({}, {})))
    own += [wait(_CHANGE - 3 * MINUTE), *begin, wait(3 * MINUTE), *(steps if choice["by"] == "OB 1" else [])]
    own += [wait(6 * MINUTE), *end, call("QRY_TINT", ob=10)]
    outside = [at(_CHANGE + later, "zone", **one) for later, one in changes] if choice["by"] == "outside" else []
    if choice["hindrance"] == "hold":
        outside += [at(_CHANGE - MINUTE, "hold"), at(_CHANGE + 3 * MINUTE, "release")]
    elif choice["hindrance"] == "stop":
        outside += [at(_CHANGE - MINUTE, "stop"), at(_CHANGE + 3 * MINUTE, "restart", type="warm")]
    about = ", ".join(f"{name}: {level}" for name, level in choice.items() if level != "none")
    return program(
        f"T15-zone-{number:03}",
        f"Local time is set. {about}.",
        ["T15-96", "T15-97", "T15-98", "T15-99"],
        header("S7-1500", _CLOCK, "RUN", _obs(choice), **more),
        90 * MINUTE,
        [body(1, own, 1), *([body(10, [wait(SECOND), *steps, wait(SECOND)], 2)] if choice["by"] == "OB 10" else [])],
        outside,
    )


def _obs(choice: Choice) -> tuple[int, ...]:
    missing = {10} if choice["hindrance"] == "missing" else set()
    return tuple(sorted({1, 10, 80, 100} - missing - ({80} if choice["OB 80"] == "missing" else set())))
