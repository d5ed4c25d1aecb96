"""The calls of a program: in each run of an OB its own, in their order, and once their turn has come."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from itertools import dropwhile
from typing import Any

from s7check.asking.line_text import passed_date
from s7check.engine import pool
from s7check.kit.program import Program, bodies_of
from s7check.kit.whole import elapsed
from s7check.log.calls import MODES, OPERANDS

Call = tuple[int, dict[str, Any]]
"""A call, or a step that sets the clock or local time, with the milliseconds for which its OB is at work before."""

_CLOCK = {"call": "clock"}
"""A clock that is right already needs no line."""

_SETTINGS = ("clock", "zone")

_CYCLE = 200
"""Milliseconds that a cycle of OB 1 may take beside its waits."""

_SLACK = 100
"""Milliseconds beside the latency by which an implementation may lag behind a wait."""

_DRIFT = 500
"""Milliseconds, at most, for a clock that runs up to 0.1 % apart from the work."""


def _call(step: dict[str, Any]) -> dict[str, Any]:
    return {name: step[name] for name in ("call", *OPERANDS[step["call"]])}


def _called(event: dict[str, Any]) -> dict[str, Any]:
    """The call of a line, as a program in one spelling has it."""
    operands = {name: event[name] for name in OPERANDS[event["event"]]}
    return {"call": event["event"], **operands, **({"sdt": passed_date(event["sdt"])} if "sdt" in operands else {})}


def _setting(event: dict[str, Any]) -> dict[str, Any]:
    return _CLOCK if event["event"] == "clock" else {"call": "zone", "zone": event["zone"], "reason": event["reason"]}


def _without_clocks(calls: list[Call]) -> list[Call]:
    return [*dropwhile(lambda one: one[1] is _CLOCK, calls)]


class _Runs:
    """The calls that are still to come in each run of an OB."""

    def __init__(self, program: Program) -> None:
        self._bodies = {(body.ob, body.run): body.steps for body in bodies_of(program.plain)}
        self._last = max((body.run for body in program.bodies), default=0) + 1
        self._started: Counter[int] = Counter()

    def begun(self) -> Counter[int]:
        """How often each OB was started."""
        return self._started.copy()

    def go_back(self, begun: Counter[int]) -> None:
        """Takes starts back."""
        self._started = begun

    def are_over(self, ob: int) -> bool:
        """Whether the OB has no body in this run nor in a later one."""
        return not any(other == ob and (run == 0 or run >= self._started[ob]) for other, run in self._bodies)

    def start(self, ob: int) -> tuple[list[Call], int]:
        """The calls of the next run, and the milliseconds of all its waits."""
        self._started[ob] += 1
        return self.of(ob, self._started[ob])

    def of(self, ob: int, run: int) -> tuple[list[Call], int]:
        calls, worked = [], 0
        for step in self._bodies.get((ob, run), self._bodies.get((ob, 0), ())):
            worked += step.get("wait", 0)
            if "call" in step:
                calls.append((worked, _call(step)))
            elif step.get("event") in _SETTINGS:
                calls.append((worked, _setting(step)))
        return calls, worked

    def cycle_with_calls(self, begun: int) -> tuple[list[Call], int]:
        """The calls of the next cycle of OB 1 that has some, and when the cycle is over, in ms of work.

        ``begun`` is when the next cycle begins.
        """
        while True:
            over = self._started[1] > self._last
            calls, waits = self.of(1, self._last) if over else self.start(1)
            if calls or over:
                return [(begun + due, call) for due, call in calls], begun + waits + _CYCLE
            begun += waits + _CYCLE


@dataclass
class _Frame:
    """An OB that was started: the calls that are left, for how long it works in all, and how much of it is done."""

    ob: int
    calls: list[Call] = field(default_factory=list)
    length: int = 0
    worked: int = 0

    def done(self) -> tuple[int, dict[str, Any]]:
        """The next call is made; those behind it come later if it was late."""
        due, call = self.calls.pop(0)
        late = max(0, self.worked - due)
        self.calls = [(after + late, each) for after, each in self.calls]
        self.length += late
        return late, call


class _Turns:
    def __init__(self, program: Program, latency: int) -> None:
        self._runs = _Runs(program)
        self._cycles = bool(program.header.get("cycle"))
        self._mode: str = program.header.get("mode", "STOP")
        self._loaded = set(program.header["obs"])
        self._slack = latency + _SLACK
        self._up = 0
        self._stack: list[_Frame] = []
        # Starts and ends of the OB below all others, OB 1 or a startup OB, need not be there.
        self._startup = dict(pool.alternatives().startup)
        self._below = _Frame(self._startup["warm"] if self._mode == "STARTUP" else 1)
        self._next_cycle = 0
        self._sure = True  # nobody has broken off a cycle of OB 1 that was not seen
        self._stopped: tuple[tuple[list[_Frame], _Frame, int, bool], int] | None = None
        self._told = False  # the calls of the startup OB are known, or its lines are there
        if self._cycles and self._mode == "RUN":
            self._stack.append(_Frame(1, *self._runs.start(1)))  # it runs when the log begins

    def take(self, event: dict[str, Any]) -> str:
        """What is wrong with the line, or with what had to be called before; empty if nothing is."""
        self.pass_until(elapsed(event))
        name = event["event"]
        wrong = ""
        if name in OPERANDS:
            wrong = self._take_call(event)
        elif name in _SETTINGS:
            self._take_setting(_setting(event))
        elif name == "start":
            self._start(event["ob"])
        elif name == "end":
            wrong = self._end(event["ob"])
        elif name == "load":
            self._loaded.add(event["ob"])
        elif name == "delete":
            self._loaded.discard(event["ob"])
        elif name in ("stop", "restart"):
            wrong = self.owed()
            if name == "stop" and self._below.ob == 1:
                work = (list(self._stack), self._below, self._next_cycle, self._sure)
                self._stopped = (work, self._runs.begun()[1])
            elif event.get("type") in ("warm", "cold"):
                self._stopped = None
            self._clear(self._startup[event["type"]] if name == "restart" else 1)
        elif name == "run":
            self._run()
        self._mode = MODES.get(name, self._mode)
        return wrong

    def pass_until(self, up: int) -> None:
        """Time passes for the OB at work."""
        if self._mode in ("RUN", "STARTUP"):
            (self._stack[-1] if self._stack else self._below).worked += up - self._up
        self._up = up

    def owed(self) -> str:
        """A call whose turn has come and that is not there."""
        if self._stack or self._mode == "STOP" or (self._cycles and self._below.ob == 1):
            return self._owed()
        # Nobody has seen that the next cycle has begun: it may begin after a restart as well.
        before = (self._runs.begun(), replace(self._below, calls=list(self._below.calls)), self._next_cycle, self._told)
        self._fetch()
        wrong = self._owed()
        begun, self._below, self._next_cycle, self._told = before
        self._runs.go_back(begun)
        return wrong

    def _owed(self) -> str:
        for frame in self._stack:
            if not frame.calls and frame.ob in (1, *self._startup.values()) and self._runs.are_over(frame.ob):
                continue  # with nothing to do it goes on as long as the implementation likes
            if frame.worked > self._latest(frame, frame.calls[0][0] if frame.calls else frame.length):
                return _missing(frame)
        frame = self._below
        sure = self._sure if frame.ob == 1 else frame.ob in self._loaded
        if sure and frame.calls and frame.worked > self._latest(frame, frame.calls[0][0]):
            return _missing(frame)
        return ""

    def _latest(self, frame: _Frame, due: int) -> int:
        return due + self._slack + min(frame.worked // 1000, _DRIFT)

    def startup_is_over(self) -> bool:
        """Whether STARTUP goes on though its OB has nothing to do any more."""
        if self._mode != "STARTUP" or self._stack:
            return False
        frame = self._below
        there = frame.ob in self._loaded
        if there and not self._told:
            self._fetch()
        return not frame.calls and frame.worked > self._latest(frame, frame.length if there else 0)

    def _run(self) -> None:
        """RUN begins; behind a hot restart what STOP has interrupted goes on."""
        self._below, self._next_cycle = _Frame(1), 0
        if self._stopped is not None:
            (stack, self._below, self._next_cycle, self._sure), cycles = self._stopped
            self._stack = [*stack, *self._stack]
            self._runs.go_back(Counter({**self._runs.begun(), 1: cycles}))
            self._stopped = None

    def _clear(self, lowest: int) -> None:
        if self._below.ob == 1 and self._mode in ("RUN", "HOLD") and not self._cycles:
            self._sure = self._sure and self._breaks_off()
        self._stack.clear()
        self._below, self._next_cycle, self._told = _Frame(lowest), 0, False

    def _breaks_off(self) -> bool:
        """Whether it is known which cycle of OB 1 ends here unfinished: the one that was seen, or the first in RUN."""
        if self._next_cycle:
            return self._below.worked < self._next_cycle - _CYCLE
        begun = self._runs.begun()
        known = self._below.worked < self._runs.start(1)[1]
        if not known:
            self._runs.go_back(begun)
        return known

    def _start(self, ob: int) -> None:
        if ob == 1 and not self._cycles:
            return
        self._stack.append(_Frame(ob, *self._runs.start(ob)))
        self._told = self._told or ob == self._below.ob

    def _end(self, ob: int) -> str:
        if not self._stack or self._stack[-1].ob != ob:
            return ""
        calls = [call for call in self._stack.pop().calls if call[1] is not _CLOCK]
        return f"expected {calls[0][1]['call']} before the end of OB {ob}" if calls else ""

    def _fetch(self) -> None:
        if self._below.calls:
            return
        if self._below.ob == 1:
            self._below.calls, self._next_cycle = self._runs.cycle_with_calls(self._next_cycle)
        elif not self._told:
            self._below.calls, self._below.length = self._runs.start(self._below.ob)
            self._told = True

    def _take_call(self, event: dict[str, Any]) -> str:
        if not self._stack:
            self._fetch()
        frame = self._stack[-1] if self._stack else self._below
        frame.calls = _without_clocks(frame.calls)
        if not frame.calls:
            return "no call of the program is left here"
        late, call = frame.done()
        if call != _called(event):
            return "expected the next call of the program"
        self._next_cycle += late if frame is self._below else 0
        return ""

    def _take_setting(self, setting: dict[str, Any]) -> None:
        if not self._stack and self._mode != "STOP":
            self._fetch()
        frame = self._stack[-1] if self._stack else self._below
        calls = frame.calls if setting is _CLOCK else _without_clocks(frame.calls)
        if calls and calls[0][1] == setting and calls[0][0] <= frame.worked + self._slack:
            frame.calls = calls
            frame.done()


def _missing(frame: _Frame) -> str:
    due, call = frame.calls[0] if frame.calls else (frame.length, {"call": "the end"})
    return f"expected {call['call']} of OB {frame.ob}, when it has been at work for {due} ms"


def calls_departure(program: Program, latency: int, events: Iterable[dict[str, Any]], until: int) -> tuple[str, bool]:
    """The first line at which the calls are not those of the program, or the call that is missing at the end; and
    whether STARTUP goes on at the end though its OB has nothing to do any more.
    """
    turns = _Turns(program, latency)
    for event in events:
        wrong = turns.take(event)
        if wrong:
            return f"line {event['line']}: {wrong}", False
    turns.pass_until(until)
    wrong = turns.owed()
    return f"at its end: {wrong}" if wrong else "", turns.startup_is_over()
