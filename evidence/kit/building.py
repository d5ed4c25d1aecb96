"""Building blocks of programs."""

from __future__ import annotations

from datetime import datetime, timedelta

from s7check.kit.from_log import Json
from s7check.kit.program import FORMAT

SECOND = 1_000
MINUTE = 60 * SECOND
HOUR = 60 * MINUTE
DAY = 24 * HOUR

USUAL_OBS = (1, 10, 11, 20, 21, 35, 40, 80, 82, 85, 100, 102)

PERIODS = {
    "once": "16#0000",
    "minute": "16#0201",
    "hourly": "16#0401",
    "daily": "16#1001",
    "weekly": "16#1202",
    "weekly 1201": "16#1201",
    "monthly": "16#1401",
    "yearly": "16#1801",
    "end of month": "16#2001",
}


def call(name: str, **operands: object) -> Json:
    """A step that calls an SFC."""
    return {"call": name, **operands}


def set_tint(ob: int, start: str, period: str) -> Json:
    """A call of SFC 28."""
    return call("SET_TINT", ob=ob, sdt=start, period=period)


def wait(ms: int) -> Json:
    """A step of work."""
    return {"wait": ms}


def body(ob: int, steps: list[Json], run: int = 0) -> Json:
    """The body of an OB, of every run where none is given."""
    return {"ob": ob, **({"run": run} if run else {}), "steps": steps}


def at(after: int, event: str, **fields: object) -> Json:
    """An event from outside."""
    return {"after": after, "event": event, **fields}


def spelled(time: datetime) -> str:
    """A time as programs have it, to the second."""
    return time.isoformat(timespec="seconds")


def later(clock: str, ms: int) -> str:
    """The time that the clock shows so much later."""
    return spelled(datetime.fromisoformat(clock) + timedelta(milliseconds=ms))


def program(
    name: str,
    about: str,
    requirements: list[str],
    header: Json,
    duration: int,
    bodies: list[Json],
    outside: list[Json] | None = None,
) -> Json:
    """A program; bodies without steps are left out, events from outside put in the order of their times."""
    events = sorted(outside or [], key=lambda event: int(event["after"]))
    return {
        "format": FORMAT,
        "name": name,
        "about": about,
        "requirements": requirements,
        "header": header,
        "duration": duration,
        **({"outside": events} if events else {}),
        "bodies": [one for one in bodies if one["steps"]],
    }


def header(cpu: str, clock: str, mode: str = "RUN", obs: tuple[int, ...] = USUAL_OBS, **more: object) -> Json:
    """The header of a program."""
    return {"cpu": cpu, "obs": list(obs), "clock": clock, "mode": mode, **more}
