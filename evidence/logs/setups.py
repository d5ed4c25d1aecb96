"""CPUs drawn at random, as programs of the soft PLC: settings and a random program."""

from __future__ import annotations

import json
from datetime import datetime, timedelta
from random import Random
from typing import Any

from s7check.engine.answer import Alternatives
from s7check.kit.program import FORMAT

EXECUTIONS = {
    "once": 40,
    "minute": 60,
    "hourly": 40,
    "daily": 40,
    "weekly": 20,
    "monthly": 2,
    "yearly": 2,
    "end_of_month": 1,
}
"""How often a log begins with one: TLC takes seconds for each of the last three, which programs set as well."""
USUAL = (10, 11, 12, 20, 21, 35, 80, 85, 100, 102)
OTHERS = (13, 14, 15, 16, 17, 22, 23, 30, 32, 38, 40, 41, 47, 55, 57, 60, 70, 72, 81, 82, 83, 84, 86, 87)

FIRST = datetime(1990, 1, 1)
_TURNS = ((2, 28), (2, 29), (3, 1), (4, 30), (6, 30), (10, 31), (12, 31), (1, 1))
"""Months and days around whose end calendars go wrong."""
_YEARS = (1990, 1999, 2000, 2026, 2027, 2028, 2088)
_FEWEST, _MOST = 9, 59
"""Events of a log."""


_EVER = 36525 * 86_400_000
"""Milliseconds that no program lasts."""


def scenario(random: Random, words: Alternatives, events: int | None = None) -> str:
    """The text of a program: a family, OBs, classes, STEP 7 parameters, a clock close to a turn, so many events.

    By default 9 to 59.
    """
    family = random.choice(words.families)
    drawn = [ob for ob in USUAL if random.random() < 0.9] + [ob for ob in OTHERS if random.random() < 0.4]
    loaded = [ob for ob in drawn if ob not in dict(words.unknown)[family]]
    clock = _clock(random)
    header: dict[str, Any] = {
        "cpu": family,
        "obs": [1, *loaded],
        "clock": _spelled(clock),
        "mode": random.choices(("RUN", "STOP", "STARTUP"), (5, 3, 2))[0],
    }
    own: dict[str, Any] = {
        "latency_ms": random.choice((0, 1, 10, 10, 10, 50)),
        "cycle_ms": random.choice((1, 10, 500)),
        "buffer": random.choice((1, 2, 3, 16, 64)),
    }
    header["cycle"] = random.random() < 0.2
    own["diag"] = random.random() < 0.35
    if family in words.settable and random.random() < 0.7:
        header["priority"] = _classes(random, words, family)
    header["step7"] = {"tod": _step7(random, words, clock, loaded, deselects=family in words.classic)}
    own["random"] = {"seed": random.randrange(1 << 31), "events": events or random.randint(_FEWEST, _MOST)}
    program = {
        "format": FORMAT,
        "name": "random",
        "about": "A random program.",
        "requirements": [],
        "header": header,
        "duration": _EVER,
        "x_soft_plc": own,
        "bodies": [],
    }
    return json.dumps(program)


def _clock(random: Random) -> datetime:
    if random.random() < 0.2:
        day = datetime(2026, 11, 21)
    else:
        month, number = random.choice(_TURNS)
        year = random.choice(_YEARS)
        leap = year % 4 == 0  # 2000 too
        day = datetime(year, month, 28 if (month, number) == (2, 29) and not leap else number)
    seconds = random.choice((0, random.randrange(60)))
    time = day + timedelta(hours=23, minutes=random.randint(55, 59), seconds=seconds)
    return time + timedelta(milliseconds=random.choice((0, 0, 250, 999)))


def _spelled(time: datetime) -> str:
    return time.isoformat(timespec="milliseconds")


def _classes(random: Random, words: Alternatives, family: str) -> dict[str, int]:
    """Some of them shared."""
    shared = random.randint(2, 23)
    classes, all_settable = {}, dict(dict(words.classes)[family])
    of_family = [ob for ob in (10, 11, 12, 13, 20, 21, 22, 30, 35, 40, 41, 81, 82, 85) if ob in all_settable]
    for ob in random.sample(of_family, 5):
        settable = [level for level in all_settable[ob] if level]  # 0 deselects
        classes[str(ob)] = shared if random.random() < 0.5 and shared in settable else random.choice(settable)
    return classes


def execution(random: Random) -> str:
    """When an interrupt with STEP 7 parameters is executed."""
    return random.choices(list(EXECUTIONS), list(EXECUTIONS.values()))[0]


def _step7(
    random: Random, words: Alternatives, clock: datetime, loaded: list[int], *, deselects: bool
) -> dict[str, dict[str, object]]:
    """Some time-of-day interrupts with parameters; deselected ones are hardly ever loaded."""
    parameters: dict[str, dict[str, object]] = {}
    for ob in words.tod_obs:
        chance = random.random()
        if chance < 0.1 and deselects and (ob not in loaded or random.random() < 0.1):
            parameters[str(ob)] = {"deselected": True}
        elif chance < 0.35:
            start = clock + timedelta(minutes=random.choice((-1440, -60, -5, 0, 1, 2, 5, 1440)))
            chosen = execution(random)
            if chosen == "monthly":
                start = start.replace(day=min(start.day, 28))
            parameters[str(ob)] = {
                "execution": chosen,
                "active": random.random() < 0.8,
                "start": max(start, FIRST).isoformat(timespec="minutes"),
            }
    return parameters
