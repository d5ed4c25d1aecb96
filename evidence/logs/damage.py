"""Logs changed so that they can still be read, and may or may not still be explained."""

from __future__ import annotations

import copy
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta
from random import Random
from typing import Any

from evidence.logs.setups import OTHERS, USUAL, execution
from s7check.engine.answer import Alternatives

ANSWERS = ("16#0000", "16#0001", "16#0002", "16#8080", "16#8090", "16#8091", "16#8092", "16#80A0", "16#80A1", "16#80A2")
LATENCIES = (0, 1, 2, 9, 11, 50, 1000)
DELAYS = (1, 2, 9, 10, 11, 12, 49, 51, 400, 1001, 30_000, 60_000)
"""Milliseconds; many about a latency."""
JUMPS = (-172_800, -86_400, -3_600, -120, -60, -1, 1, 30, 60, 120, 3_600, 86_400, 172_800)
"""Seconds by which a clock is set."""
TIMES = ("at", "up")
SIBLINGS = (
    ("DIS_AIRT", "EN_AIRT"),
    ("DIS_IRT", "EN_IRT"),
    ("CAN_TINT", "ACT_TINT"),
    ("hold", "release", "run"),
    ("load", "delete"),
    ("start", "end"),
)
"""Events with the same required fields."""

Event = dict[str, Any]


@dataclass
class Log:
    """A log as its JSON objects, as they are spelled in the lines."""

    header: Event
    events: list[Event]


@dataclass(frozen=True)
class Damage:
    """A change of a log: its name, how often it is chosen beside the others, and the function.

    `do` may find nothing to change.
    """

    what: str
    weight: int
    do: Callable[[Random, Log, Alternatives], None]


def _pick(random: Random, events: Sequence[Event], *names: str) -> Event:
    """An event with one of these fields, or an event that is in no log."""
    having = [event for event in events if any(name in event for name in names)]
    return random.choice(having) if having else {}


def _answer(random: Random, log: Log, _: Alternatives) -> None:
    event = _pick(random, log.events, "ret")
    if event.get("event") in ("QRY_TINT", "QRY_DINT") and random.random() < 0.5 and "status" in event:
        event["status"] = f"16#{int(event['status'].removeprefix('16#'), 16) ^ 1 << random.randrange(6):04X}"
    else:
        event["ret"] = random.choice(ANSWERS)


def _drop(random: Random, log: Log, _: Alternatives) -> None:
    """A value that is not given: an answer, a field of `info`, all of it, the cause of a STOP."""
    event = _pick(random, log.events, "ret", "info", "cause", "up")
    if "info" in event and random.random() < 0.7:
        del event["info"][random.choice(list(event["info"]))]
    elif "ret" in event:
        event["ret"] = None
    else:
        for name in ("info", "cause"):
            event.pop(name, None)


def _delete(random: Random, log: Log, _: Alternatives) -> None:
    del log.events[random.randrange(len(log.events))]


def _double(random: Random, log: Log, _: Alternatives) -> None:
    place = random.randrange(len(log.events))
    log.events.insert(place, copy.deepcopy(log.events[place]))


def _swap(random: Random, log: Log, _: Alternatives) -> None:
    """Two lines that follow each other change places; the times stay."""
    if len(log.events) < 2:
        return
    place = random.randrange(len(log.events) - 1)
    one, other = log.events[place : place + 2]
    times = [{name: event[name] for name in TIMES if name in event} for event in (one, other)]
    log.events[place : place + 2] = [other | times[0], one | times[1]]


def _other_ob(random: Random, log: Log, _: Alternatives) -> None:
    event = _pick(random, log.events, "ob")
    near = [other["ob"] for other in log.events if "ob" in other]
    event["ob"] = random.choice([*near, *near, *USUAL, *OTHERS])


def _other_class(random: Random, log: Log, _: Alternatives) -> None:
    event = _pick(random, [e["info"] for e in log.events if "info" in e], "priority")
    event["priority"] = random.choice((2, 3, 16, 23, 24, 25, 26, 28))


def _other_value(random: Random, log: Log, _: Alternatives) -> None:
    """A field of a line, or of its start information, with the value that another line has there."""
    inside = [event["info"] for event in log.events if "info" in event]
    where = inside if inside and random.random() < 0.6 else log.events
    event = random.choice(where)
    names = [name for name in event if name not in ("event", *TIMES)]
    if names:
        name = random.choice(names)
        event[name] = copy.deepcopy(random.choice([other[name] for other in where if name in other]))


def _other_event(random: Random, log: Log, _: Alternatives) -> None:
    """The event of another name with the same fields."""
    siblings = random.choice(SIBLINGS)
    having = [event for event in log.events if event["event"] in siblings]
    if having:
        event = random.choice(having)
        event["event"] = random.choice([name for name in siblings if name != event["event"]])
        if event["event"] == "end":
            event.pop("info", None)


def _insert(random: Random, log: Log, words: Alternatives) -> None:
    """A line of its own at a time that another line has."""
    place = random.randrange(len(log.events))
    ob = random.choice([other["ob"] for other in log.events if "ob" in other] or [35])
    outside = random.choice(sorted(set(words.external) - set(words.faulty)))
    new: Event = random.choice(
        (
            *({"event": name} for name in ("hold", "release", "run", "stop")),
            *({"event": "restart", "type": kind} for kind in ("warm", "cold")),
            *({"event": name, "ob": max(ob, 1)} for name in ("start", "end", "load", "delete")),
            {"event": "interrupt", "ob": outside},
            {"event": "interrupt", "ob": random.choice((80, 85)), "flt_id": random.choice((1, 3, 9, 0xA3))},
            {"event": "DIS_AIRT", "ret": random.choice((None, 1))},
            {"event": "diag", "id": random.choice((0x3502, 0x3505, 0x35A1, 0x35A2, 0x4568, 0x456D, 0x5380))},
        )
    )
    log.events.insert(place, new | {name: log.events[place][name] for name in TIMES if name in log.events[place]})


def _at(event: Event) -> datetime:
    return datetime.fromisoformat(event["at"])


def _spelled(time: datetime) -> str:
    return time.isoformat(timespec="milliseconds")


def _delay_from(log: Log, place: int, by: timedelta, *, elapsed: bool) -> None:
    """Put off the clock from this event to its next change, and elapsed time to the end."""
    clock = True
    for event in log.events[place:]:
        if clock:
            event["at"] = _spelled(_at(event) + by)
        if elapsed and "up" in event:
            event["up"] += by // timedelta(milliseconds=1)
        clock = clock and event["event"] != "clock"


def elapses(log: Log) -> timedelta:
    """The longest time that passes on the clock from one event to the next, unless a line sets it."""
    longest, shown = timedelta(), None
    for event in log.events:
        longest = max(longest, _at(event) - (shown or _at(event)))
        shown = datetime.fromisoformat(event["to"] if "to" in event else event["at"])
    return longest


def _later(random: Random, log: Log, _: Alternatives) -> None:
    _delay_from(
        log,
        random.randrange(len(log.events)),
        timedelta(milliseconds=random.choice(DELAYS)),
        elapsed=random.random() < 0.9,
    )


def _jump(random: Random, log: Log, _: Alternatives) -> None:
    """The clock is set, with a line that says so."""
    place = random.randrange(len(log.events))
    by = timedelta(seconds=random.choice(JUMPS))
    was = log.events[place]
    to = (_at(was) + by).replace(microsecond=random.choice((0, 0, 250_000)))
    by = to - _at(was)
    line = {"event": "clock", "at": was["at"], "to": _spelled(to)} | ({"up": was["up"]} if "up" in was else {})
    _delay_from(log, place, by, elapsed=False)
    log.events.insert(place, line)


def _loaded(random: Random, log: Log, _: Alternatives) -> None:
    obs = set(log.header["obs"]) ^ {random.choice((*USUAL, *OTHERS))}
    log.header["obs"] = sorted(obs)


def _family(random: Random, log: Log, words: Alternatives) -> None:
    log.header["cpu"] = random.choice(words.classic)
    if log.header["cpu"] not in words.settable:
        log.header.pop("priority", None)


def _latency(random: Random, log: Log, _: Alternatives) -> None:
    log.header["latency_ms"] = random.choice(LATENCIES)


def _cycle(_: Random, log: Log, __: Alternatives) -> None:
    log.header["cycle"] = not log.header.get("cycle", False)


def _mode(random: Random, log: Log, _: Alternatives) -> None:
    log.header["mode"] = random.choice(("STOP", "STARTUP", "RUN"))


def _classes(random: Random, log: Log, words: Alternatives) -> None:
    if log.header["cpu"] in words.settable:
        ob, classes = random.choice(dict(words.classes)[log.header["cpu"]])
        given = log.header.setdefault("priority", {})
        given[str(ob)] = random.choice(classes)


def _step7(random: Random, log: Log, words: Alternatives) -> None:
    tod = log.header.setdefault("step7", {}).setdefault("tod", {})
    start = (datetime.fromisoformat(log.header["clock"]) + timedelta(minutes=random.randint(-2, 3))).replace(
        second=0, microsecond=0
    )
    tod[str(random.choice(words.tod_obs))] = {
        "execution": execution(random),
        "active": random.random() < 0.7,
        "start": _spelled(start),
    }


DAMAGES = (
    Damage("another answer", 8, _answer),
    Damage("a value dropped", 4, _drop),
    Damage("a line deleted", 6, _delete),
    Damage("a line doubled", 3, _double),
    Damage("two lines swapped", 6, _swap),
    Damage("another OB", 5, _other_ob),
    Damage("another class", 3, _other_class),
    Damage("another value", 6, _other_value),
    Damage("another event", 4, _other_event),
    Damage("a line put in", 5, _insert),
    Damage("later", 7, _later),
    Damage("clock set", 6, _jump),
    Damage("header: OBs", 4, _loaded),
    Damage("header: CPU", 2, _family),
    Damage("header: latency", 3, _latency),
    Damage("header: cycle", 1, _cycle),
    Damage("header: mode", 1, _mode),
    Damage("header: classes", 3, _classes),
    Damage("header: STEP 7", 4, _step7),
)


def ask_for_readings(random: Random, log: Log, words: Alternatives) -> None:
    """One to four of the specification's readings."""
    log.header["readings"] = {
        ambiguity: random.choice(known) for ambiguity, known in random.sample(words.letters, random.randint(1, 4))
    }


def ask_for_profile(random: Random, log: Log, words: Alternatives) -> None:
    """The readings of an edition."""
    log.header["profile"] = random.choice(words.profiles)


SHORT, SHORTEST = 20, 8
"""Events of a log that leaves out kinds, and of a log that leaves out calls, OBs or modes: the longer, the more ways to
explain it."""

KINDS = {
    **dict.fromkeys(("start", "end"), "ob"),
    **dict.fromkeys(("restart", "run", "stop", "hold", "release"), "mode"),
    **dict.fromkeys(("load", "delete"), "load"),
    **{kind: kind for kind in ("clock", "interrupt", "diag")},
    "zone": "clock",
}
"""The kind of an event that is not a call."""


def leave_out(random: Random, log: Log) -> None:
    """One or two kinds of event are not recorded, and few of their lines or none are there. The log becomes short.

    What the clock shows is recorded unless the lines have `up`: time would elapse in its place, days of it.
    """
    timed = all("up" in event for event in log.events)
    kinds = [kind for kind in log.header["records"] if kind != "diag" and (timed or kind != "clock")]
    gone = set(random.sample(kinds, random.choice((1, 1, 1, 2))))
    log.header["records"] = [kind for kind in log.header["records"] if kind not in gone]
    length = SHORTEST if gone & {"call", "ob", "mode"} else SHORT
    stays = random.choice((0, 0, 0.2))
    log.events = [
        event for event in log.events if KINDS.get(event["event"], "call") not in gone or random.random() < stays
    ][:length]
