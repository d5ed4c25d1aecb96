"""A program runs on the specification. What the CPU may do, and when, is asked of it at every step."""

from __future__ import annotations

from copy import copy
from itertools import takewhile
from random import Random
from typing import Any, Self

from s7check.asking.answers import Possible, Time
from s7check.asking.line_text import as_line, spelled
from s7check.asking.session import Session
from s7check.asking.variants import AS_IT_IS, Variant
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.kit.program import Program, outside_events
from s7check.log.calls import LOG_FORMAT, MODES
from s7check.log.values import MS_PER_MINUTE, instant, iso
from s7check.simulating.work import CYCLE_OB, Work

LATENCY = 10
"""``latency_ms`` of a log, by default."""

_LONGEST = 100_000
"""Lines of a log; a program with more does not end."""

_AT_WORK = ("RUN", "STARTUP")

Choice = dict[str, Any] | None
"""What may happen next, a line of the log without its time; None: the CPU lets something be that need not come now."""


class Simulation:
    """A run of ``program``: ``choices`` has the possible next events, ``take`` takes one, until there is no choice.

    Everything happens as early as it may: OBs before events from outside, those before the steps of the program. With
    ``random``, OBs start up to ``latency`` ms late. ``variant`` changes the program's CPU. Every method may raise
    EngineError.
    """

    def __init__(
        self,
        engine: Engine,
        program: Program,
        variant: Variant = AS_IT_IS,
        latency: int = LATENCY,
        random: Random | None = None,
    ) -> None:
        self.header = {"format": LOG_FORMAT, **variant.of(program.header), "latency_ms": latency}
        self._duration = program.duration
        self._random = random
        # Where OB 1 is in its body is known here, so every cycle is told.
        strict = {"cycle": True, "latency_ms": latency if random else 0}
        self._session = Session(engine, self.header | strict)
        self._work = Work(program)
        self._outside = outside_events(program)
        self._up = 0
        self._clock = instant(program.header["clock"])
        self._let_until = 0
        self._let_at = -1
        self._begun: set[tuple[int, str]] = set()
        """When, and in which state of the CPU, an OB has started."""
        self._mode: str = program.header.get("mode", "STOP")
        loads = {event["ob"] for event in program.outside if event["event"] == "load"}
        self._starts = [{"event": "start", "ob": ob} for ob in sorted({CYCLE_OB, *program.header["obs"], *loads})]
        self._known: Possible | None = None
        self._ends_that_count: list[int] = []
        if self._mode == "RUN":
            self._work.start(CYCLE_OB)

    @property
    def log(self) -> list[dict[str, Any]]:
        """The lines of the log so far, the header first."""
        return [self.header, *(line for place, line in enumerate(self._session.lines) if self._shown(place, line))]

    def _shown(self, place: int, line: dict[str, Any]) -> bool:
        """Lines of OB 1 are optional; an end of it without which the next lines are hard to understand is shown."""
        of_cycle = line["event"] in ("start", "end") and line["ob"] == CYCLE_OB
        return not of_cycle or bool(self.header.get("cycle")) or place in self._ends_that_count

    def run(self) -> list[dict[str, Any]]:
        """Runs the program to its end and returns the log."""
        while choices := self.choices():
            self.take(self._random.choice(choices) if self._random else choices[0])
        return self.log

    def close(self) -> None:
        """Ends the session in the engine."""
        self._session.close()

    def branch(self) -> Self:
        """A simulation that goes on from here by itself."""
        twin = copy(self)
        twin._session = self._session.branch()
        twin._work = self._work.copy()
        twin._outside = list(self._outside)
        twin._begun = set(self._begun)
        twin._ends_that_count = list(self._ends_that_count)
        return twin

    def key(self) -> tuple[object, ...]:
        """Equal for simulations that go on alike."""
        lets = (self._let_until, self._let_at)
        return (self._possible().key, self._work.key(), len(self._outside), self._up, self._clock, self._mode, lets)

    def choices(self) -> list[Choice]:
        """What may happen now, once time has gone on to where something may; none at the end of the program."""
        while self._up < self._duration:
            if len(self._session.lines) >= _LONGEST:
                raise EngineError(f"the program has more than {_LONGEST} lines of log")
            now = self._of_cpu() or self._of_outside() or self._of_program() or self._of_idle_cpu()
            if now:
                return now
            self._wait()
        return []

    def take(self, choice: Choice) -> None:
        """One of the choices happens."""
        if choice is None:
            self._let_at = self._up
            self._let_until = self._up + (self._random.randint(0, self._slack()) if self._random else 0)
            return
        if choice["event"] == "restart" and self._mode != "STOP":
            self._feed({"event": "stop"})
        if choice["event"] == "start":
            self._begun.add(self._moment())
        self._feed(choice)

    # What may happen

    def _possible(self) -> Possible:
        if self._known is None:
            self._known = self._session.possible([*self._starts, {"event": "run"}])
        return self._known

    def _now(self, possible: Possible) -> list[dict[str, Any]]:
        """The lines that may come now."""
        return [
            as_line(line.event)
            for line in possible.lines
            if elapsed(possible.times[line.first]) <= self._up
            and (line.last is None or self._up <= elapsed(possible.times[line.last]))
        ]

    def _fits(self, line: dict[str, Any]) -> bool:
        """Whether the line is possible now, while those OBs run that are at work.

        Between two times at which it is possible, a start event may have come to nothing. A startup OB may end unseen.
        """
        before = self._session.before({"at": iso(self._clock), **line})
        at_work = [frame.ob for frame in self._work.frames]
        return any(self._mode != "STARTUP" or [one.ob for one in each.running] == at_work for each in before)

    def _slack(self) -> int:
        """Milliseconds until something has to have come."""
        ends = [elapsed(time) for time in self._possible().times if time.due]
        return max(0, min(ends, default=self._up) - self._up)

    def _of_cpu(self) -> list[Choice]:
        """OBs that interrupt what runs, and a STOP by rule."""
        possible = self._possible()
        ended = [time for time in possible.times if time.due and elapsed(time) <= self._up]
        if self._up < self._let_until and not ended:
            return []
        found: list[Choice] = [
            line
            for line in self._now(possible)
            if line["event"] == "start" and line["ob"] != CYCLE_OB and self._fits(line)
        ]
        if not self._random or ended or not found:
            due = [one for time in ended for one in time.due if one.event == "stop"]
            found += [{"event": "stop"} | ({"cause": f"W#16#{one.value:04X}"} if one.field else {}) for one in due]
        if found and not ended:
            return [] if self._let_at == self._up or self._moment() in self._begun else [*found, None]
        return found

    def _moment(self) -> tuple[int, str]:
        """Equal after an OB of no length that may start any number of times, such as for many open start events."""
        return self._up, self._possible().key

    def _of_idle_cpu(self) -> list[Choice]:
        """The next cycle, or the end of STARTUP."""
        if self._work.frames:
            return []
        for line in self._now(self._possible()):
            if line["event"] == "run" or line["ob"] == CYCLE_OB:
                return [line]
        return []

    def _of_outside(self) -> list[Choice]:
        """The next event from outside, if its time has come."""
        while self._outside and self._outside[0][0] <= self._up:
            event = {name: value for name, value in self._outside.pop(0)[1].items() if name not in ("after", "every")}
            line = self._clocked(event)
            name = line["event"]
            silent = name == "state" or (self._mode == "STOP" and name in ("interrupt", "stop"))
            if not silent and (name == "restart" or self._session.why({"at": iso(self._clock), **line}) is None):
                return [line]
        return []

    def _clocked(self, event: dict[str, Any]) -> dict[str, Any]:
        """An event that moves the clock, as an event that sets it."""
        if "by" not in event:
            return event
        return {"event": "clock", "to": iso(self._clock + event["by"])}

    def _of_program(self) -> list[Choice]:
        """The next step of the OB at work."""
        while (top := self._work.top) is not None and self._mode in _AT_WORK and top.busy == 0:
            step = top.step
            if step is None:
                return [{"event": "end", "ob": top.ob}]
            if "call" in step:
                return self._answers({**step, "event": step["call"]})
            if step.get("event") == "clock":
                line = self._clocked(step)
                if line["to"] != iso(self._clock):
                    return [line]
            top.go_on()
        return []

    def _answers(self, call: dict[str, Any]) -> list[Choice]:
        del call["call"]
        answers = self._session.possible([call], iso(self._clock)).lines
        if not answers:
            raise EngineError(f"no answer to {spelled(call)}")
        return [as_line(line.event) for line in answers]

    # What happens

    def _feed(self, line: dict[str, Any]) -> None:
        whole = {"at": iso(self._clock), **{name: value for name, value in line.items() if name != "at"}}
        top = self._work.top
        if whole["event"] == "end" and whole["ob"] == CYCLE_OB and self._ends_a_delay():
            self._ends_that_count.append(len(self._session.lines))
        refusal = self._session.feed(whole)
        if refusal is not None:
            raise EngineError(f"{spelled(whole)} at {whole['at']}: refused, {', '.join(refusal.requirements)}")
        self._known = None
        name = line["event"]
        if top is not None and top.busy == 0 and top.step is not None and name in top.step.values():
            top.go_on()
        if name == "start":
            self._work.start(line["ob"])
        elif name == "end":
            self._work.end()
        elif name == "clock":
            self._clock = instant(line["to"])
        elif name == "stop":
            self._work.stop(self._mode == "STARTUP")
        elif name == "restart":
            self._work.restart(line["type"] == "hot")
        elif name == "run":
            self._work.go_on()
        self._mode = MODES.get(name, self._mode)

    def _ends_a_delay(self) -> bool:
        """Whether a delay by SFC 41 ends if the OB at work ends now."""
        lines = reversed(self._session.lines)
        cycle = takewhile(lambda line: (line["event"], line.get("ob")) != ("end", CYCLE_OB), lines)
        called = any(line["event"] == "DIS_AIRT" for line in cycle)
        return called and any(state.delay for state in self._session.situations(most=1))

    def _wait(self) -> None:
        """Time goes on to where something may happen."""
        possible = self._possible()
        wakes = {line.first for line in possible.lines} | {i for i, time in enumerate(possible.times) if time.due}
        ends = [elapsed(possible.times[i]) for i in wakes]
        if possible.endless:
            ends.append(elapsed(possible.times[-1]))
        ends += [after for after, _ in self._outside[:1]]
        ends.append(self._let_until)
        top = self._work.top
        at_work = top is not None and self._mode in _AT_WORK
        if top is not None and at_work and not top.idle:
            ends.append(self._up + top.busy)
        until = min([end for end in ends if end > self._up], default=self._duration)
        passed = min(until, self._duration) - self._up
        if top is not None and at_work:
            top.busy = max(0, top.busy - passed) if not top.idle else top.busy
        self._up += passed
        self._clock += passed


def elapsed(time: Time) -> int:
    """The milliseconds since the log began."""
    return time.up.min * MS_PER_MINUTE + time.up.ms
