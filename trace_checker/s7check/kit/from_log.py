"""A log turned into a program: its calls become the bodies of OBs, the rest of its cause comes from outside.

What the CPU of the log answered is left out. Another CPU may do other things with the program, and its log is judged
for itself.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from s7check.engine.client import Engine
from s7check.kit.program import FORMAT, HEADER_FIELDS
from s7check.log.calls import OPERANDS
from s7check.log.objects import decoded

Json = dict[str, Any]

AFTERWARDS = 1_000
"""Milliseconds that a program lasts beyond the last line of its log, so that OBs that are due then are seen."""

_STARTUP = {"warm": 100, "hot": 101, "cold": 102}

_MADE_BY_RULES = {0x4568, 0x456D, 0x454A}
"""Causes of a STOP by the CPU itself."""

_FAULTS_OF_RULES = {80: {0x02, 0x05, 0x06, 0x07}, 85: {0xA1, 0xA2}}
"""Fault ids that come from no cause outside, as the log format has them."""


@dataclass
class _Run:
    """A run of an OB: its steps so far, and since when it has not been interrupted."""

    ob: int
    number: int
    since: int
    worked: int = 0
    steps: list[Json] = field(default_factory=list)

    def interrupted(self, now: int) -> None:
        self.worked += now - self.since

    def step(self, now: int, step: Json) -> None:
        self.wait(now)
        self.steps.append(step)

    def wait(self, now: int) -> None:
        self.worked += now - self.since
        self.since = now
        if self.worked:
            self.steps.append({"wait": self.worked})
            self.worked = 0


class _Log:
    """Follows a log and collects the parts of its program."""

    def __init__(self, header: Json) -> None:
        self.outside: list[Json] = []
        self.bodies: dict[tuple[int, int], list[Json]] = {}
        self.now = 0
        self._runs: Counter[int] = Counter()
        self._stack: list[_Run] = []
        self._stopped: list[_Run] = []
        """What STOP has interrupted and a hot restart brings back."""
        self._cycles = bool(header.get("cycle"))
        mode = header.get("mode", "STOP")
        if mode != "STOP":
            self._begin(1 if mode == "RUN" else _STARTUP["warm"])

    def take(self, event: Json, raw: Json) -> None:
        name = event["event"]
        if name in OPERANDS:
            if self._stack:
                operands = {operand: raw[operand] for operand in OPERANDS[name]}
                self._stack[-1].step(self.now, {"call": name, **operands})
        elif name == "state":
            self._outside({"event": "state", "ob": event["ob"]})
        elif name == "start":
            self._start(event["ob"])
        elif name == "end":
            self._end(event["ob"])
        elif name == "stop":
            if event.get("cause") not in _MADE_BY_RULES:
                self._outside({"event": "stop"})
            self._stop()
        elif name == "restart":
            if raw["type"] != "hot":
                self._close(self._stopped)
            self._outside({"event": "restart", "type": raw["type"]})
            self._begin(_STARTUP[raw["type"]])
        elif name == "run":
            self._cut()
            self._run()
        elif name == "interrupt" and event.get("flt_id") in _FAULTS_OF_RULES.get(event["ob"], ()):
            return
        elif name in ("hold", "release", "clock", "interrupt", "load", "delete"):
            kept: Json = {field: raw[field] for field in ("ob", "flt_id", "to") if field in raw}
            self._outside({"event": name, **kept})

    def finish(self, now: int) -> None:
        self.now = now
        self._cut()
        self._close(self._stopped)

    def _outside(self, event: Json) -> None:
        self.outside.append({"after": self.now, **event})

    def _begin(self, ob: int) -> None:
        self._runs[ob] += 1
        self._stack.append(_Run(ob, self._runs[ob], self.now))

    def _start(self, ob: int) -> None:
        if self._stack and self._stack[-1].ob == ob and ob in (1, *_STARTUP.values()):
            if not self._cycles or ob != 1:
                return  # the OB below all others, which runs already
            self._finished(self._stack.pop())
        if self._stack:
            self._stack[-1].interrupted(self.now)
        self._begin(ob)

    def _end(self, ob: int) -> None:
        if not self._stack or self._stack[-1].ob != ob or (ob == 1 and not self._cycles):
            return
        run = self._stack.pop()
        run.wait(self.now)
        self._finished(run)
        if self._stack:
            self._stack[-1].since = self.now

    def _cut(self) -> None:
        """Nothing runs any more: each OB stays at work until here."""
        if self._stack:
            self._stack[-1].wait(self.now)
        self._close(self._stack)

    def _stop(self) -> None:
        """STOP ends a startup OB for good; others may go on."""
        if not self._stack or self._stack[0].ob in _STARTUP.values():
            self._cut()
        else:
            self._stack[-1].wait(self.now)
            self._stopped, self._stack = self._stack, []

    def _run(self) -> None:
        self._stack, self._stopped = self._stopped, []
        if self._stack:
            self._stack[-1].since = self.now
        else:
            self._begin(1)

    def _close(self, runs: list[_Run]) -> None:
        for run in reversed(runs):
            if run.worked:
                run.steps.append({"wait": run.worked})
            if run.ob == 1:
                # Its cycle must not end before the STOP: the next runs would have other numbers.
                run.steps.append({"wait": 1})
            self._finished(run)
        runs.clear()

    def _finished(self, run: _Run) -> None:
        if run.steps:
            self.bodies[run.ob, run.number] = run.steps


def program_of(
    engine: Engine, lines: Iterable[bytes], name: str, about: str, requirements: list[str], **more: object
) -> Json:
    """The program of a log whose lines can be read; ``more`` are further fields. Raises UnusableLogError."""
    texts = [line for line in lines if line.strip()]
    content = engine.read(b"\n".join(texts))
    if content.unusable is not None:
        raise content.unusable.error()
    header = decoded(texts[0])
    log = _Log(header)
    for text, event in zip(texts[1:], content.events, strict=True):
        log.now = event["up"]["min"] * 60_000 + event["up"]["ms"]
        log.take(event, decoded(text))
    log.finish(log.now + AFTERWARDS)
    return {
        "format": FORMAT,
        "name": name,
        "about": about,
        "requirements": requirements,
        **more,
        "header": {field: header[field] for field in HEADER_FIELDS if field in header},
        "duration": max(1, log.now),
        **({"outside": log.outside} if log.outside else {}),
        "bodies": [{"ob": ob, "run": run, "steps": steps} for (ob, run), steps in sorted(log.bodies.items())],
    }
