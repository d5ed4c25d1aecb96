"""Builds logs with the verdict that their writer expects.

A situation is a function that is called for some CPUs and begins logs by ``Variant.log``. A log grows by one line a
call; ``copy`` gives it a second end. ``accepted``, ``rejected``, ``unusable`` and ``late`` say what is expected of it
as it stands, and why.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from datetime import datetime, timedelta
from typing import Any

MS, MINUTE, HOUR, DAY = timedelta(milliseconds=1), timedelta(minutes=1), timedelta(hours=1), timedelta(days=1)
DEFAULT_LATENCY = 10
"""What the format takes for ``latency_ms`` where the header has none."""

moment = datetime.fromisoformat


def iso(when: datetime) -> str:
    """A moment as the format spells it, with milliseconds."""
    return when.isoformat(timespec="milliseconds")


def word(value: int | str | None) -> str | None:
    """A number as a word in hexadecimal, two's complement; other values as they are."""
    return f"W#16#{value & 0xFFFF:04X}" if isinstance(value, int) else value


def bit(ob: int) -> int:
    """The bit of a time-of-day OB in the error information of OB 80."""
    return 1 << (ob - 10)


@dataclass(frozen=True)
class Case:
    """A log with the verdict expected; ``line`` counts from 1 and is None where the log is accepted."""

    situation: str
    variant: int
    requirement: str
    why: str
    verdict: str
    line: int | None
    lines: tuple[dict[str, Any] | str, ...]

    def text(self) -> str:
        """The log as NDJSON; a line that is no object stands as it is."""
        return "".join((line if isinstance(line, str) else json.dumps(line)) + "\n" for line in self.lines)

    @property
    def expected(self) -> tuple[str, int | None]:
        """Verdict and line."""
        return self.verdict, self.line


@dataclass(frozen=True)
class Variant:
    """One CPU, with the OBs and the beginning of its logs. Milliseconds; ``up`` says that lines carry it."""

    number: int
    cpu: str
    ob: int
    delay_ob: int
    begin: datetime
    latency: int
    up: bool
    cases: list[Case] = field(default_factory=list)
    situation: str = ""
    requirement: str = ""

    @property
    def point(self) -> datetime:
        """The first full minute after the beginning."""
        return self.begin.replace(second=0, microsecond=0) + MINUTE

    @property
    def other(self) -> int:
        """A second time-of-day OB."""
        return 10 if self.ob != 10 else 12

    @property
    def s7_300(self) -> bool:
        """Whether the CPU is an S7-300."""
        return self.cpu == "S7-300"

    @property
    def delay_class(self) -> int:
        """The default class of the delay OB."""
        return self.delay_ob - 17

    def log(self, obs: list[int] | None = None, begin: datetime | None = None, **header: Any) -> Log:
        """A log in mode RUN with some OBs loaded; ``header`` has further fields of the header."""
        if obs is None:
            obs = [1, self.ob, self.other, self.delay_ob, 35, 40, 80, 85, 100]
        clock = begin or self.begin
        latency = header.get("latency_ms", self.latency)
        first = {
            "format": "s7-interrupt-log/1",
            "cpu": self.cpu,
            "obs": sorted(set(obs)),
            "clock": iso(clock),
            "mode": "RUN",
        }
        if latency != DEFAULT_LATENCY:
            first["latency_ms"] = latency
        return Log(self, clock, latency, [first | header], self.up)


VARIANTS = [
    Variant(0, "S7-300", 10, 20, moment("2026-03-31T23:59:30.000"), 10, up=False),
    Variant(1, "S7-400", 13, 21, moment("2028-02-28T23:59:30.000"), 0, up=True),
    Variant(2, "CPU 318", 11, 22, moment("2089-12-31T22:29:30.000"), 50, up=False),
    Variant(3, "S7-300", 17, 23, moment("1999-12-31T23:59:30.000"), 7, up=True),
]
FIRST_TWO = VARIANTS[:2]
REMEMBERING = VARIANTS[1:3]
"""The CPUs that do not serve a point twice when the clock was set back."""
REPEATING = [VARIANTS[0], VARIANTS[3]]

Situation = Callable[[Variant], None]
SITUATIONS: list[tuple[Situation, str, list[Variant]]] = []


def situation(requirement: str, variants: list[Variant] = VARIANTS) -> Callable[[Situation], Situation]:
    """Enters a situation. ``requirement`` decides where a log names none; FP-n is fine point n of the format."""

    def enter(function: Situation) -> Situation:
        SITUATIONS.append((function, requirement, variants))
        return function

    return enter


def cases() -> Iterator[tuple[str, Case]]:
    """The logs of all situations, each with its name; equal ones once."""
    made: list[Case] = []
    for function, requirement, variants in SITUATIONS:
        for variant in variants:
            function(replace(variant, cases=made, situation=function.__name__, requirement=requirement))
    seen: set[str] = set()
    count: Counter[tuple[str, int]] = Counter()
    for case in made:
        text = case.text()
        if text not in seen:
            seen.add(text)
            count[case.situation, case.variant] += 1
            yield f"{case.situation}-{case.variant}-{count[case.situation, case.variant]:02}", case


@dataclass
class Log:
    """A log that grows, with the CPU clock and the milliseconds since it began."""

    variant: Variant
    clock_now: datetime
    latency: int
    lines: list[Any]
    with_up: bool
    up: int = 0

    def copy(self) -> Log:
        """The same log, to go on in another way."""
        return replace(self, lines=list(self.lines))

    def wait(self, ms: int) -> Log:
        """Time elapses."""
        self.clock_now += ms * MS
        self.up += ms
        return self

    def until(self, when: datetime, plus: int = 0) -> Log:
        """Time elapses until the clock shows ``when``, and ``plus`` ms."""
        ms = round((when + plus * MS - self.clock_now) / MS)
        assert ms >= 0, (when, self.clock_now)
        return self.wait(ms)

    def event(self, event: str, **fields: Any) -> Log:
        """A line of now."""
        line: dict[str, Any] = {"event": event, "at": iso(self.clock_now)}
        if self.with_up:
            line["up"] = self.up
        self.lines.append(line | fields)
        return self

    def raw(self, text: str) -> Log:
        """A line as it stands."""
        self.lines.append(text)
        return self

    def call(self, event: str, ret: int | None, **fields: Any) -> Log:
        """A call of a system function and its answer."""
        return self.event(event, **fields, ret=word(ret))

    def tod_call(self, event: str, ob: int | None, ret: int | None, **fields: Any) -> Log:
        """A call about a time-of-day OB, by default that of the variant."""
        return self.call(event, ret, ob=self.variant.ob if ob is None else ob, **fields)

    def dint_call(self, event: str, ob: int | None, ret: int | None, **fields: Any) -> Log:
        """A call about a delay OB, by default that of the variant."""
        return self.call(event, ret, ob=self.variant.delay_ob if ob is None else ob, **fields)

    def set_tint(
        self, sdt: datetime | str | None = None, per: int = 0, ret: int | None = 0, ob: int | None = None
    ) -> Log:
        """SET_TINT, by default onto the variant's point."""
        sdt = self.variant.point if sdt is None else sdt
        return self.tod_call("SET_TINT", ob, ret, sdt=sdt if isinstance(sdt, str) else iso(sdt), period=word(per))

    def can_tint(self, ret: int | None = 0, ob: int | None = None) -> Log:
        """CAN_TINT."""
        return self.tod_call("CAN_TINT", ob, ret)

    def act_tint(self, ret: int | None = 0, ob: int | None = None) -> Log:
        """ACT_TINT."""
        return self.tod_call("ACT_TINT", ob, ret)

    def armed(self, sdt: datetime | str | None = None, per: int = 0, ob: int | None = None) -> Log:
        """SET_TINT and ACT_TINT, both answered 0000."""
        return self.set_tint(sdt, per, 0, ob).act_tint(0, ob)

    def qry_tint(self, status: int, ob: int | None = None, ret: int | None = 0) -> Log:
        """QRY_TINT."""
        return self.tod_call("QRY_TINT", ob, ret, status=word(status))

    def srt_dint(self, dtime: int | str, sign: int = 0x1234, ret: int | None = 0, ob: int | None = None) -> Log:
        """SRT_DINT; ``dtime`` in ms or as the format spells it."""
        return self.dint_call("SRT_DINT", ob, ret, dtime=dtime, sign=word(sign))

    def can_dint(self, ret: int | None = 0, ob: int | None = None) -> Log:
        """CAN_DINT."""
        return self.dint_call("CAN_DINT", ob, ret)

    def qry_dint(self, status: int | None, ob: int | None = None, ret: int | None = 0) -> Log:
        """QRY_DINT."""
        return self.dint_call("QRY_DINT", ob, ret, status=word(status))

    def dis_irt(self, mode: int, ob: int = 0, ret: int | None = 0) -> Log:
        """DIS_IRT."""
        return self.call("DIS_IRT", ret, mode=f"B#16#{mode:02X}", ob=ob)

    def en_irt(self, mode: int, ob: int = 0, ret: int | None = 0) -> Log:
        """EN_IRT."""
        return self.call("EN_IRT", ret, mode=f"B#16#{mode:02X}", ob=ob)

    def dis_airt(self, ret: int | None) -> Log:
        """DIS_AIRT."""
        return self.call("DIS_AIRT", ret)

    def en_airt(self, ret: int | None) -> Log:
        """EN_AIRT."""
        return self.call("EN_AIRT", ret)

    def tick(self) -> Log:
        """A call that changes nothing: it shows the time, and that a program runs."""
        return self.call("CAN_DINT", 0x8090, ob=99)

    def start(self, ob: int | None = None, **info: Any) -> Log:
        """An OB starts; ``info`` has fields of its start information."""
        plain = {"priority", "dtime", "ev_ob", "time"}
        shown = {name: value if name in plain else word(value) for name, value in info.items()}
        return self.event("start", ob=self.variant.ob if ob is None else ob, **({"info": shown} if shown else {}))

    def end(self, ob: int | None = None) -> Log:
        """An OB ends."""
        return self.event("end", ob=self.variant.ob if ob is None else ob)

    def runs(self, ob: int | None = None, ms: int = 2, **info: Any) -> Log:
        """An OB starts, and ends ``ms`` later."""
        return self.start(ob, **info).wait(ms).end(ob)

    def interrupt(self, ob: int, **fields: Any) -> Log:
        """A start event from outside."""
        return self.event("interrupt", ob=ob, **fields)

    def clock(self, to: datetime) -> Log:
        """The clock is set."""
        self.event("clock", to=iso(to))
        self.clock_now = to
        return self

    def restart(self, kind: str = "warm") -> Log:
        """A restart begins."""
        return self.event("restart", type=kind)

    def run(self) -> Log:
        """STARTUP is over."""
        return self.event("run")

    def stop(self, cause: int | None = None) -> Log:
        """The CPU stops."""
        return self.event("stop", **({"cause": word(cause)} if cause else {}))

    def hold(self) -> Log:
        """HOLD begins."""
        return self.event("hold")

    def release(self) -> Log:
        """HOLD ends."""
        return self.event("release")

    def diag(self, entry: int) -> Log:
        """An entry of the diagnostic buffer."""
        return self.event("diag", id=word(entry))

    def state(self, ob: int, **fields: Any) -> Log:
        """What the CPU says of an OB."""
        return self.event("state", ob=ob, **fields)

    def accepted(self, why: str, requirement: str | None = None) -> Log:
        """The log is right as far as it goes."""
        return self._expect("accepted", None, why, requirement)

    def rejected(self, why: str, requirement: str | None = None, line: int | None = None) -> Log:
        """No behaviour explains a line, by default the last one."""
        return self._expect("rejected", line or len(self.lines), why, requirement)

    def unusable(self, why: str, requirement: str | None = None, line: int | None = None) -> Log:
        """A line cannot be read, by default the last one."""
        return self._expect("unusable", line or len(self.lines), why, requirement)

    def late(self, why: str, requirement: str | None = None) -> Log:
        """Something due now does not come: in time at exactly the latency, rejected a millisecond later."""
        self.wait(self.latency).tick().accepted(why + " (the window is still open)", requirement)
        return self.wait(1).tick().rejected(why, requirement)

    def _expect(self, verdict: str, line: int | None, why: str, requirement: str | None) -> Log:
        v = self.variant
        found = Case(v.situation, v.number, requirement or v.requirement, why, verdict, line, tuple(self.lines))
        v.cases.append(found)
        return self
