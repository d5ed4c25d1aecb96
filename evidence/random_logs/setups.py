"""CPUs drawn at random, as scenarios of the soft PLC: settings and a random program."""

from __future__ import annotations

from datetime import datetime, timedelta
from random import Random

from s7check.log import tables

FAMILIES = ("S7-300", "S7-400", "318")
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


def scenario(random: Random) -> str:
    """The text of a scenario: any family, OBs, classes, STEP 7 parameters, a clock close to a turn, 9 to 59 events."""
    family = random.choice(FAMILIES)
    loaded = [ob for ob in USUAL if random.random() < 0.9] + [ob for ob in OTHERS if random.random() < 0.4]
    clock = _clock(random)
    settings = [
        f"cpu {family}",
        f"obs {' '.join(map(str, [1, *loaded]))}",
        f"clock {_spelled(clock)}",
        f"mode {random.choices(('RUN', 'STOP', 'STARTUP'), (5, 3, 2))[0]}",
        f"latency {random.choice((0, 1, 10, 10, 10, 50))}ms",
        f"cycle_time {random.choice((1, 10, 500))}ms",
        f"buffer {random.choice((1, 2, 3, 16, 64))}",
        *(["log_cycle on"] if random.random() < 0.2 else []),
        *(["log_diag on"] if random.random() < 0.35 else []),
        *(_classes(random) if family != "S7-300" and random.random() < 0.7 else []),
        *_step7(random, clock, loaded),
        f"random {random.randrange(1 << 31)} events {random.randint(_FEWEST, _MOST)}",
    ]
    return "".join(line + "\n" for line in settings)


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


def _classes(random: Random) -> list[str]:
    """Some of them shared."""
    shared = random.randint(2, 23)
    settings = []
    for ob in random.sample((10, 11, 12, 13, 20, 21, 22, 30, 35, 40, 41, 81, 82, 85), 5):
        classes = tables.SETTABLE_PRIORITIES[ob]
        given = shared if random.random() < 0.5 and shared in classes else random.choice(classes)
        settings.append(f"priority {ob} {given}")
    return settings


def execution(random: Random) -> str:
    """When an interrupt with STEP 7 parameters is executed."""
    return random.choices(list(EXECUTIONS), list(EXECUTIONS.values()))[0]


def _step7(random: Random, clock: datetime, loaded: list[int]) -> list[str]:
    """Some time-of-day interrupts with parameters; deselected ones are hardly ever loaded."""
    settings = []
    for ob in tables.TIME_OF_DAY_OBS:
        chance = random.random()
        if chance < 0.1 and (ob not in loaded or random.random() < 0.1):
            settings.append(f"step7 {ob} deselected")
        elif chance < 0.35:
            start = clock + timedelta(minutes=random.choice((-1440, -60, -5, 0, 1, 2, 5, 1440)))
            chosen = execution(random)
            if chosen == "monthly":
                start = start.replace(day=min(start.day, 28))
            active = " active" if random.random() < 0.8 else ""
            settings.append(f"step7 {ob} {chosen} {max(start, FIRST).isoformat(timespec='minutes')}{active}")
    return settings
