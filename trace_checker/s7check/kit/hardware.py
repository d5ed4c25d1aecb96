"""A program of the kit as the interpreter in AWL has it: steps of 16 bytes (instrumentation/awl/README.md)."""

from __future__ import annotations

import struct
from collections.abc import Iterable, Iterator
from dataclasses import replace
from datetime import datetime
from typing import Any

from s7check.kit.program import Program, bodies_of, outside_events
from s7check.kit.scl import SFC, NotForCpuError
from s7check.log.values import instant, iso

LOADED, RUNS, DONE = 1, 2, 3
"""What DB 110 says of the program."""

STATE = 8
"""The byte in DB 110 where it says so."""

MOST = 498
"""Steps that fit in DB 110."""

_HEADER = struct.Struct(">HhhhhhI8sII")
_STEP = struct.Struct(">BBhHH8s")
_MAGIC, _LAYOUT = 0x5331, 1
_EVENT_STEP = struct.Struct(">BBhI8s")
_WAIT, _SET_CLK, _EVENT, _BODY, _END = 1, 2, 253, 254, 255
_KINDS = {"clock": 2, "interrupt": 40, "stop": 46}
"""Events from outside that the interpreter brings about itself: SFC 0, an edge at an output, SFC 46."""

_WIRED = 40
"""The OB of the interrupt input to which the output is wired."""

_NOTHING = bytes(8)
_LONGEST = (1 << 31) - 1


def fitted(program: Program, cpu: str, obs: Iterable[int]) -> Program:
    """The program on a CPU that has just these OBs: what it shows is then another, since it has no expected output."""
    changed = {"cpu": cpu, "obs": sorted(obs)}
    raw, plain = (each | {"header": each["header"] | changed} for each in (program.raw, program.plain))
    return replace(program, header=program.header | changed, raw=raw, plain=plain)


def lacks(program: Program) -> str:
    """Why the interpreter cannot run the program; empty if it can."""
    header = program.header
    for field in ("priority", "step7", "cycle"):
        if header.get(field):
            return f"no {field} in the header"
    if header.get("mode", "STOP") != "RUN":
        return f"no beginning in {header.get('mode', 'STOP')}"
    for place, event in enumerate(program.outside):
        if event["event"] not in _KINDS or (program.outside[:place] and program.outside[place - 1]["event"] == "stop"):
            return f"no {event['event']} from outside"
        if event.get("ob", _WIRED) != _WIRED or "flt_id" in event:
            return f"no interrupt of OB {event['ob']} from outside"
    needed = {body.ob for body in program.bodies} | {event["ob"] for event in program.outside if "ob" in event}
    if missing := needed - set(header["obs"]):
        return f"no OB {min(missing)}"
    try:
        encoded(program)
    except NotForCpuError as error:
        return str(error)
    return ""


def encoded(program: Program) -> bytes:
    """The bytes of DB 110. Raises NotForCpuError."""
    steps = [*_events(program), *_steps(program)]
    if program.duration > _LONGEST:
        raise NotForCpuError("a duration above 2^31 ms")
    if len(steps) > MOST:
        raise NotForCpuError(f"{len(steps)} steps, more than {MOST}")
    clock = _bcd(program.plain["header"]["clock"])
    return _HEADER.pack(_MAGIC, _LAYOUT, MOST, 0, LOADED, 0, 0, clock, program.duration, _HEADER.size) + b"".join(steps)


def _events(program: Program) -> Iterator[bytes]:
    """The events from outside, in the order of their times."""
    moved = instant(program.plain["header"]["clock"])
    own = any(step.get("event") == "clock" for body in program.bodies for step in body.steps)
    for after, event in outside_events(replace(program, outside=tuple(program.plain["outside"]))):
        date = _NOTHING
        if event["event"] == "clock":
            if "by" in event and own:
                raise NotForCpuError("a clock moved by a duration beside steps that set it")
            moved = instant(event["to"]) - after if "to" in event else moved + event["by"]
            date = _bcd(iso(moved + after))
        yield _EVENT_STEP.pack(_EVENT, _KINDS[event["event"]], event.get("ob", 0), after, date)


def _steps(program: Program) -> Iterator[bytes]:
    for body in bodies_of(program.plain):
        yield _STEP.pack(_BODY, 0, body.ob, body.run, 0, _NOTHING)
        for step in body.steps:
            if "end" in step:
                break
            yield _step(step)
    yield _STEP.pack(_END, 0, 0, 0, 0, _NOTHING)


def _step(step: dict[str, Any]) -> bytes:
    if step.get("wait", 0) > _LONGEST:
        raise NotForCpuError("a wait above 2^31 ms")
    if "wait" in step:
        return _STEP.pack(_WAIT, 0, 0, 0, 0, struct.pack(">ii", step["wait"], 0))
    if "call" not in step:
        if step["event"] != "clock" or "to" not in step:
            raise NotForCpuError("a step that is neither a call, a wait nor a clock that is set to a date")
        return _STEP.pack(_SET_CLK, 0, 0, 0, 0, _bcd(step["to"]))
    given = _bcd(step["sdt"]) if "sdt" in step else struct.pack(">ii", step.get("dtime", 0), 0)
    word = step.get("period", step.get("sign", 0)) & 0xFFFF
    return _STEP.pack(SFC[step["call"]], step.get("mode", 0), step.get("ob", 0), word, 0, given)


def _bcd(date: str) -> bytes:
    """DATE_AND_TIME, of a date that need not exist."""
    digits = "".join(filter(str.isdigit, date)).ljust(17, "0")
    if not "1990" <= digits[:4] < "2090":
        raise NotForCpuError("a year outside of 1990 to 2089")
    try:
        day = datetime.fromisoformat(date).isoweekday() % 7 + 1
    except ValueError:
        day = 1
    return bytes.fromhex(digits[2:17] + str(day))
