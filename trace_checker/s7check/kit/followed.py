"""Whether a log is the log of its program: the CPU of the header, the events from outside, the calls in their order.

This says nothing about the CPU, whose behaviour the specification judges: it finds an adapter that runs another program
or leaves parts of it out.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any

import msgspec

from s7check.asking.line_text import passed_date
from s7check.engine.client import Engine
from s7check.kit.program import Program, bodies_of
from s7check.log.calls import LOG_FORMAT, OPERANDS

_OF_PROGRAM = ("cpu", "obs", "clock", "mode", "priority", "step7")

_SURE = ("load", "delete", "restart")
"""Events from outside that reach a CPU in every mode."""


def departure(engine: Engine, program: Program, log: Sequence[bytes]) -> str:
    """The first place where the log is not that of the program; empty if there is none.

    ``log`` has been judged, so its lines can be read up to the first that cannot.
    """
    lines = [line for line in log if line.strip()]
    if not lines:
        return "the log is empty"
    content = engine.read(b"\n".join(lines))
    header = content.header
    if header is None:
        return ""  # the verdict says it
    own = engine.read(msgspec.json.encode({"format": LOG_FORMAT, **program.header})).header
    assert own is not None
    for field in _OF_PROGRAM:
        if _ordered(header[field]) != _ordered(own[field]):
            return f'line 1: field "{field}": expected that of the program'
    events = [(event["line"], event) for event in content.events]
    return _outside(program, events) or _calls(program, events)


def _ordered(value: Any) -> Any:
    """Maps of the header have become lists in the order in which they were written."""
    return sorted(value, key=str) if isinstance(value, list) else value


def _outside(program: Program, events: Sequence[tuple[int, dict[str, Any]]]) -> str:
    logged = Counter((event["event"], event.get("ob")) for _, event in events)
    for event in program.outside:
        name = (event["event"], event.get("ob"))
        if event["event"] not in _SURE or event["after"] >= program.duration or "every" in event:
            continue
        if logged[name] == 0:
            what = event["event"] + (f" of OB {event['ob']}" if "ob" in event else "")
            return f"the log has no {what}, which comes after {event['after']} ms"
        logged[name] -= 1
    return ""


class _Runs:
    """The calls that are still to come in each run of an OB."""

    def __init__(self, program: Program) -> None:
        self._bodies = {
            (body.ob, body.run): [_call(step) for step in body.steps if "call" in step]
            for body in bodies_of(program.plain)
        }
        self._last = max((body.run for body in program.bodies), default=0) + 1
        self._started: Counter[int] = Counter()

    def start(self, ob: int) -> list[dict[str, Any]]:
        """The calls of the next run."""
        self._started[ob] += 1
        return self.of(ob, self._started[ob])

    def of(self, ob: int, run: int) -> list[dict[str, Any]]:
        return list(self._bodies.get((ob, run), self._bodies.get((ob, 0), [])))

    def cycle_with_calls(self) -> list[dict[str, Any]]:
        """The calls of the next cycle of OB 1 that has some."""
        while self._started[1] <= self._last:
            calls = self.start(1)
            if calls:
                return calls
        return self.of(1, self._last)


def _call(step: dict[str, Any]) -> dict[str, Any]:
    return {name: step[name] for name in ("call", *OPERANDS[step["call"]])}


def _called(event: dict[str, Any]) -> dict[str, Any]:
    """The call of a line, as a program in one spelling has it."""
    operands = {name: event[name] for name in OPERANDS[event["event"]]}
    return {"call": event["event"], **operands, **({"sdt": passed_date(event["sdt"])} if "sdt" in operands else {})}


_STARTUP = {"warm": 100, "hot": 101, "cold": 102}


def _calls(program: Program, events: Sequence[tuple[int, dict[str, Any]]]) -> str:
    runs = _Runs(program)
    cycles_logged = bool(program.header.get("cycle"))
    # Starts and ends of the OB below all others, OB 1 or a startup OB, need not be there.
    lowest = _STARTUP["warm"] if program.header.get("mode") == "STARTUP" else 1
    below: list[dict[str, Any]] | None = None
    stack: list[tuple[int, list[dict[str, Any]]]] = []
    # What STOP has interrupted and a hot restart brings back.
    stopped, stopped_below = stack, below
    if cycles_logged and program.header.get("mode") == "RUN":
        stack.append((1, runs.start(1)))  # it runs when the log begins
    for number, event in events:
        name = event["event"]
        if name == "start" and (event["ob"] != 1 or cycles_logged):
            stack.append((event["ob"], runs.start(event["ob"])))
        elif name == "end" and stack and stack[-1][0] == event["ob"]:
            _, left = stack.pop()
            if left:
                return f"line {number}: expected {left[0]['call']} before the end of OB {event['ob']}"
        elif name == "stop":
            if lowest == 1:
                stopped, stopped_below = stack, below
            stack, below = [], None
        elif name == "restart":
            lowest = _STARTUP[event["type"]]
            if event["type"] != "hot":
                stopped, stopped_below = [], None
        elif name == "run":
            lowest, stack, below = 1, [*stopped, *stack], stopped_below
        elif name in OPERANDS:
            if stack:
                left = stack[-1][1]
            else:
                if not below:
                    below = runs.cycle_with_calls() if lowest == 1 else runs.start(lowest)
                left = below
            if not left:
                return f"line {number}: no call of the program is left here"
            if left.pop(0) != _called(event):
                return f"line {number}: expected the next call of the program"
    return ""
