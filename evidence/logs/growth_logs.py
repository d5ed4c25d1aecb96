"""Logs that leave much open: many start events at once, few kinds recorded, years between two lines.

Each is what some plant or its recording may give, and once cost far more than its length.
"""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from datetime import datetime, timedelta

from evidence.common.checkout import ROOT, SOFT_PLC_PROGRAM
from evidence.logs.damage import Event, Log
from evidence.logs.drop import EVERY_KIND, without

BEGIN = datetime(2026, 11, 21, 5, 59, 30)
MINUTE = 60_000
LONG = 10_000
"""Events of a long log."""

PLANT = ROOT / "bench" / "plant.json"
TIME_OF_DAY = range(10, 18)
DELAYS = range(20, 24)
CYCLIC = range(30, 39)
HARDWARE = range(40, 48)
ERRORS = range(81, 88)
RIGHT = "16#0000"
EACH_MINUTE = "16#0201"
EACH_HOUR = "16#0401"


class Book:
    """A log that is being written; ``now`` is the time since its header in milliseconds."""

    def __init__(self, *obs: int, **header: object) -> None:
        self.now = 0
        self.header: Event = {
            "format": "s7-interrupt-log/1", "cpu": "S7-300", "obs": sorted({1, 100, *obs}), "clock": _spelled(0),
            "mode": "RUN", **header,
        }  # fmt: skip
        self.events: list[Event] = []

    def add(self, name: str, **fields: object) -> None:
        """An event happens now."""
        self.events.append({"event": name, "at": _spelled(self.now), **fields})

    def set_clock(self, by: int) -> None:
        """The clock is set."""
        self.add("clock", to=_spelled(self.now + by))
        self.now += by

    def call(self, name: str, ret: str = RIGHT, **fields: object) -> None:
        """OB 1, or the OB that runs, calls a system function."""
        self.add(name, ret=ret, **fields)

    def run(self, ob: int) -> None:
        """An OB starts and ends."""
        self.add("start", ob=ob)
        self.add("end", ob=ob)

    def each_minute(self, ob: int) -> None:
        """A time-of-day interrupt comes each minute from now on."""
        self.call("SET_TINT", ob=ob, sdt="2026-11-21T05:00", period=EACH_MINUTE)
        self.call("ACT_TINT", ob=ob)

    @property
    def log(self) -> Log:
        """The log as it stands."""
        return Log(self.header, self.events)


def _spelled(milliseconds: int) -> str:
    return (BEGIN + timedelta(milliseconds=milliseconds)).isoformat(timespec="milliseconds")


def text(log: Log) -> str:
    """The lines of a log."""
    return "".join(json.dumps(entry) + "\n" for entry in (log.header, *log.events))


def small(_: int) -> Log:
    """Ten lines of a program that sets and queries interrupts: the measure of the others."""
    book = Book(10, 20, 80, 85)
    book.each_minute(10)
    book.now = 30_000
    book.run(10)
    book.call("SRT_DINT", ob=20, dtime=500, sign=1)
    book.now = 30_500
    book.run(20)
    book.call("QRY_TINT", ob=10, status="16#0014")
    book.call("CAN_TINT", ob=10)
    return book.log


def blocked_for_years(years: int) -> Log:
    """A minute interrupt is blocked, and unblocked years later."""
    book = Book(10, 80, 85)
    book.each_minute(10)
    book.call("DIS_IRT", mode=2, ob=10)
    book.now = years * 365 * 1440 * MINUTE
    book.call("EN_IRT", mode=2, ob=10)
    book.now += 30_010
    book.add("start", ob=10)
    return book.log


def delayed_for_years(years: int) -> Log:
    """A minute interrupt of an S7-400, which remembers served points, waits for years."""
    book = Book(10, 80, 85, cpu="S7-400")
    book.each_minute(10)
    book.call("DIS_AIRT", ret="16#0001")
    book.now = years * 365 * 1440 * MINUTE
    book.call("EN_AIRT")
    book.add("start", ob=10)
    return book.log


def behind_its_time_error(years: int) -> Log:
    """An hourly interrupt waits for years behind the OB 80 for its point in HOLD."""
    book = Book(10, 80, 85)
    book.call("SET_TINT", ob=10, sdt="2026-11-21T06:00", period=EACH_HOUR)
    book.call("ACT_TINT", ob=10)
    book.add("hold")
    book.now = MINUTE
    book.add("release")
    book.add("start", ob=80, info={"flt_id": "16#06"})
    book.now = years * 365 * 1440 * MINUTE
    book.add("end", ob=80)
    return book.log


def passed_in_startup(days: int) -> Log:
    """Eight minute interrupts that STEP 7 sets, on an S7-400 that stays in STARTUP for days."""
    each_minute = {"execution": "minute", "start": "2026-11-21T05:00", "active": True}
    tods = {str(ob): each_minute for ob in TIME_OF_DAY}
    book = Book(*TIME_OF_DAY, 80, 85, cpu="S7-400", mode="STARTUP", step7={"tod": tods})
    book.now = days * 1440 * MINUTE
    book.add("run")
    book.run(10)
    return book.log


def passed_for_years(years: int) -> Log:
    """A minute interrupt whose points all pass in STARTUP, for years."""
    book = Book(10, 80, 85, mode="STARTUP")
    book.each_minute(10)
    book.now = years * 365 * 1440 * MINUTE
    book.add("run")
    book.run(10)
    return book.log


def errors_at_once(count: int) -> Log:
    """So many asynchronous errors in one millisecond, then their OBs."""
    book = Book(80, *ERRORS, cpu="S7-400")
    obs = [ERRORS[number % len(ERRORS)] for number in range(count)]
    obs = [ob if ob != 85 else 86 for ob in obs]
    for ob in obs:
        book.add("interrupt", ob=ob)
    for ob in obs:
        book.run(ob)
    return book.log


def one_class_at_once(count: int) -> Log:
    """So many OBs of one priority class are requested in one millisecond, each once."""
    obs = [*CYCLIC, *HARDWARE][:count]
    book = Book(80, *obs, cpu="S7-400", priority={str(ob): 20 for ob in obs})
    for ob in obs:
        book.add("interrupt", ob=ob)
    for ob in obs:
        book.run(ob)
    return book.log


def all_at_once(most: int) -> Log:
    """Time-of-day, delay, cyclic and hardware interrupts, at most so many of a kind, in one millisecond."""
    tods, dints, external = TIME_OF_DAY[:most], DELAYS[:most], [*CYCLIC[:most], *HARDWARE[:most]]
    book = Book(*tods, *dints, *external, 80, 85)
    for ob in tods:
        book.each_minute(ob)
    for ob in dints:
        book.call("SRT_DINT", ob=ob, dtime=30_000, sign=ob)
    book.now = 30_000
    for ob in external:
        book.add("interrupt", ob=ob)
    for ob in (*HARDWARE[:most][::-1], *CYCLIC[:most][::-1], *dints[::-1], *tods):
        book.run(ob)
    return book.log


def wrong_at_the_end(count: int) -> Log:
    """So many OBs at once, and then a wrong answer: it is looked for in all other readings."""
    book = Book(10, 11, 12, 20, 21, 35, 40, 80, 85)
    for ob in (10, 11, 12):
        book.each_minute(ob)
    book.call("SRT_DINT", ob=20, dtime=30_000, sign=1)
    book.call("SRT_DINT", ob=21, dtime=30_000, sign=1)
    book.now = 30_000
    book.add("interrupt", ob=35)
    book.add("interrupt", ob=40)
    for ob in (40, 35, 21, 20, 10, 11, 12)[:count]:
        book.run(ob)
    book.call("CAN_DINT", ob=20)
    return book.log


def held(count: int) -> Log:
    """A hardware interrupt each second of HOLD."""
    book = Book(40, 80, 85)
    book.add("hold")
    for _ in range(count):
        book.now += 1000
        book.add("interrupt", ob=40)
    book.add("release")
    book.run(40)
    return book.log


def in_startup(count: int) -> Log:
    """Hardware interrupts while the startup OB runs."""
    book = Book(40, 80, 85, mode="STARTUP")
    for _ in range(count):
        book.now += 10
        book.add("interrupt", ob=40)
    book.add("run")
    book.run(40)
    return book.log


def waiting(minutes: int) -> Log:
    """A minute interrupt is delayed for hours, with a line a minute."""
    book = Book(10, 80, 85)
    book.each_minute(10)
    book.call("DIS_AIRT", ret="16#0001")
    book.now = 5_000
    for _ in range(minutes):
        book.now += MINUTE
        book.call("QRY_TINT", ob=10, status="16#0014")
    book.call("EN_AIRT", ret=RIGHT)
    book.run(10)
    return book.log


def plant(events: int) -> Log:
    """A plant in operation, with every kind of event; the logs without some kinds are made of it."""
    done = subprocess.run(
        [str(SOFT_PLC_PROGRAM), str(PLANT), "--events", str(events)], capture_output=True, text=True, check=True
    )
    header, *lines = map(json.loads, done.stdout.splitlines())
    return Log(header, lines)


def recorded(*kinds: str) -> Callable[[int], Log]:
    """The plant, where only these kinds are recorded."""

    def some(events: int) -> Log:
        return without(plant(events), set(EVERY_KIND) - set(kinds))

    some.__doc__ = f"A plant of which only {', '.join(kinds) or 'nothing'} is recorded."
    return some


def synchronised(events: int) -> Log:
    """The clock is set back over a point that was served, and ahead again, each minute."""
    book = Book(10, 11, 35, 80, 85, cpu="S7-400")
    book.each_minute(10)
    book.each_minute(11)
    while len(book.events) < events:
        book.now += MINUTE - (book.now + 30_000) % MINUTE
        book.run(10)
        book.run(11)
        book.now += 300
        book.set_clock(-400)
        for _ in range(4):
            book.now += 1000
            book.add("interrupt", ob=35)
            book.run(35)
        book.set_clock(400)
    return book.log


def overruns(count: int) -> Log:
    """Nine cyclic OBs are requested over and over, and may start up to a minute later."""
    book = Book(80, 85, *CYCLIC, latency_ms=MINUTE)
    for _ in range(count):
        book.now += 100
        for ob in CYCLIC:
            book.add("interrupt", ob=ob)
    return book.log


def missing_time_error_ob(count: int) -> Log:
    """Two OBs are requested over and over, may start up to a minute later, and OB 80 is missing."""
    book = Book(35, 40, 85, latency_ms=MINUTE)
    for number in range(count):
        book.now += 5
        book.add("interrupt", ob=(40, 35)[number % 2])
    return book.log


def set_in_startup(count: int) -> Log:
    """The clock of an S7-400 is set a day to and fro in STARTUP."""
    book = Book(10, 80, 85, mode="STARTUP", cpu="S7-400")
    book.each_minute(10)
    for number in range(count):
        book.now += 1000
        book.set_clock((-1) ** number * 1440 * MINUTE)
    book.add("run")
    return book.log


def missing_again(count: int) -> Log:
    """OB 85 reports OB 20, which is missing, and starts its delay again."""
    book = Book(80, 85)
    book.call("SRT_DINT", ob=20, dtime=500, sign=1)
    for _ in range(count):
        book.now += 500
        book.add("start", ob=85)
        book.call("SRT_DINT", ob=20, dtime=500, sign=1)
        book.add("end", ob=85)
    return book.log


def missing_at_once(apart: int, *obs: int) -> Callable[[int], Log]:
    """Start events of OBs that are missing, so many ms apart, then as many OB 85."""

    def log(count: int) -> Log:
        book = Book(80, 85, cpu="S7-400")
        for number in range(count):
            book.add("interrupt", ob=obs[number % len(obs)])
            book.now += apart
        for _ in range(count):
            book.run(85)
        return book.log

    return log


def missing_due(count: int) -> Log:
    """Time-of-day and delay OBs that are missing and due in one moment, then as many OB 85."""
    tods, dints = TIME_OF_DAY[: count - count // 3], DELAYS[: count // 3]
    book = Book(80, 85)
    for ob in tods:
        book.each_minute(ob)
    for ob in dints:
        book.call("SRT_DINT", ob=ob, dtime=30_000, sign=ob)
    book.now = 30_000
    for _ in range(count):
        book.run(85)
    return book.log


def missing_later(before: str, after: str, **fields: object) -> Callable[[int], Log]:
    """Start events of two OBs that are missing, of which none is noticed before a line; then one OB 85."""

    def log(count: int) -> Log:
        book = Book(80, 85)
        book.add(before, **(fields and {"ret": "16#0001"}))
        for number in range(count):
            book.now += 500
            book.add("interrupt", ob=(40, 35)[number % 2])
        book.add(after, **fields)
        book.run(85)
        return book.log

    return log


def errors_delayed(count: int) -> Log:
    """Asynchronous errors while SFC 41 delays them, then their OBs."""
    obs = [(82, 83, 86)[number % 3] for number in range(count)]
    book = Book(80, 82, 83, 85, 86, cpu="S7-400")
    book.call("DIS_AIRT", ret="16#0001")
    for ob in obs:
        book.now += 5
        book.add("interrupt", ob=ob)
    book.call("EN_AIRT")
    for ob in obs:
        book.run(ob)
    return book.log


def buffered(count: int) -> Log:
    """Start events of OBs of one class in one millisecond, each of which is kept or overflows the buffer (AMB-18 b)."""
    obs = [CYCLIC[number % len(CYCLIC)] for number in range(count)]
    classes = {str(ob): 20 for ob in CYCLIC}
    book = Book(80, 85, *CYCLIC, cpu="S7-400", priority=classes, readings={"AMB-18": "b"})
    for ob in obs:
        book.add("interrupt", ob=ob)
    for ob in obs:
        book.run(ob)
    return book.log


def at_their_end(events: int) -> Log:
    """Four delays are started again at their exact end, over and over."""
    book = Book(*DELAYS, 80, 85)
    for ob in DELAYS:
        book.call("SRT_DINT", ob=ob, dtime=1000, sign=ob)
    while len(book.events) < events:
        book.now += 1000
        for ob in DELAYS:
            book.call("SRT_DINT", ob=ob, dtime=1000, sign=ob)
    return book.log


@dataclass(frozen=True)
class Kind:
    """A way to write logs of any size, with two sizes: for a test, and as large as a plant may make it.

    ``log`` gives the log of a size; ``long`` logs may cost twenty small logs, the others ten. ``states``: so many
    explain it at a time, on the way from line to line too; ``followed``: so often for each event a state is followed to
    its successors.
    """

    name: str
    log: Callable[[int], Log]
    little: int
    large: int
    states: int
    followed: int
    long: bool = False
    rejected: bool = False


def kinds() -> Iterator[Kind]:
    """All of them."""
    yield Kind("ten lines", small, 1, 1, 2, 3)
    yield Kind("minute interrupt blocked, unblocked years later", blocked_for_years, 1, 16, 2, 3)
    yield Kind("S7-400, minute interrupt delayed by SFC 41 for years", delayed_for_years, 1, 5, 8, 20)
    yield Kind("hourly interrupt behind OB 80 for years", behind_its_time_error, 1, 16, 2, 20)
    yield Kind("S7-400, 8 minute interrupts in STARTUP for days", passed_in_startup, 1, 30, 8, 20)
    yield Kind("minute interrupt in STARTUP for years", passed_for_years, 1, 16, 8, 9)
    yield Kind("asynchronous errors in one millisecond", errors_at_once, 8, 16, 260, 20)
    yield Kind("OBs of one class in one millisecond", one_class_at_once, 8, 17, 260, 40)
    yield Kind("8 time-of-day, 4 delay, 9 cyclic, 8 hardware OBs in one millisecond", all_at_once, 3, 9, 4, 3)
    yield Kind("26 lines, the last one wrong", wrong_at_the_end, 7, 7, 4, 4, rejected=True)
    yield Kind("HOLD, an interrupt a second", held, 50, 800, 8, 3)
    yield Kind("interrupts in STARTUP", in_startup, 50, 400, 130, 130)
    yield Kind("OB 10 waits, a line a minute", waiting, 30, 240, 8, 12)
    yield Kind("recorded: call, ob", recorded("call", "ob"), 1000, LONG, 8, 9, long=True)
    for kind in EVERY_KIND:
        others = [other for other in EVERY_KIND if other != kind]
        yield Kind(f"recorded: all but {kind}", recorded(*others), 1000, LONG, 1200, 20, long=True)
    yield Kind("recorded: call", recorded("call"), 1000, LONG, 8, 9, long=True)
    yield Kind("recorded: interrupt", recorded("interrupt"), 1000, LONG, 8, 9, long=True)
    yield Kind("recorded: nothing", recorded(), 1000, LONG, 8, 9, long=True)
    yield Kind("S7-400, clock synchronised once a minute", synchronised, 1000, LONG, 8, 9, long=True)
    yield Kind("latency of a minute, 9 cyclic OBs again and again", overruns, 4, 33, 8, 3)
    yield Kind("latency of a minute, OB 80 missing", missing_time_error_ob, 30, 120, 200, 30)
    yield Kind("S7-400, clock set a day to and fro in STARTUP", set_in_startup, 20, 60, 90, 80)
    yield Kind("missing OB 20, started again by OB 85", missing_again, 50, 100, 8, 9)
    yield Kind("a missing OB in one millisecond", missing_at_once(0, 40), 4, 16, 260, 40)
    yield Kind("a missing OB each millisecond", missing_at_once(1, 40), 4, 9, 300, 50)
    yield Kind("missing OBs of 17 numbers in one millisecond", missing_at_once(0, *CYCLIC, *HARDWARE), 4, 17, 1100, 80)
    # Nobody can follow so many: definite facts are left.
    yield Kind("missing OBs, due in one moment", missing_due, 4, 8, 20_020, 240)
    yield Kind("missing OBs, delayed by SFC 41", missing_later("DIS_AIRT", "EN_AIRT", ret=RIGHT), 4, 12, 200, 140)
    yield Kind("missing OBs in HOLD", missing_later("hold", "release"), 4, 64, 130, 4)
    yield Kind("asynchronous errors, delayed by SFC 41", errors_delayed, 8, 32, 200, 20)
    yield Kind("AMB-18 (b): OBs of one class in one millisecond", buffered, 4, 16, 520, 40)
    yield Kind("4 delays started again at their end", at_their_end, 1000, 20_000, 24, 28, long=True)
