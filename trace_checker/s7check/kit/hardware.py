"""A program of the kit as the interpreter in AWL has it: steps of 16 bytes (instrumentation/awl/README.md)."""

from __future__ import annotations

import struct
from collections.abc import Iterable, Iterator
from dataclasses import replace
from datetime import datetime
from itertools import islice
from typing import Any

from s7check.kit.program import OF_S7_1500, Program, bodies_of, outside_events
from s7check.kit.scl import NotForCpuError, sfc
from s7check.log.values import instant, iso

_STATES = {"RUN": 1, "STARTUP": 5, "STOP": 0}
"""What DB 110 says of a program that was loaded, by the mode in which it begins."""

_RESTARTED = 4
_STARTUP_OB = 100

STATE, BEGUN, NEXT = 8, 12, 28
"""Bytes in DB 110: what it says of the program, its begin, the next event from outside."""

MOST = 498
"""Steps that fit in DB 110."""

_HEADER = struct.Struct(">HhhhhhI8sII")
HEAD = _HEADER.size
"""Bytes of DB 110 before the steps."""

_STEP = struct.Struct(">BBhHH8s")
_MAGIC, _LAYOUT = 0x5331, 1
_EVENT_STEP = struct.Struct(">BBhI8s")
_WAIT, _SET_CLK, _EVENT, _BODY, _END = 1, 2, 253, 254, 255
_KINDS = {"clock": 2, "interrupt": 40, "stop": 46, "restart": 46}
"""Events from outside that the interpreter brings about itself: SFC 0, an edge at an output, SFC 46. For a restart it
comes to STOP only."""

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
    for field in ("priority", "step7", "cycle", *OF_S7_1500):
        if header.get(field):
            return f"no {field} in the header"
    stopped = header.get("mode", "STOP") == "STOP"
    for _, event in islice(outside_events(program), MOST):
        name = event["event"]
        if name not in _KINDS or event.get("type", "warm") != "warm":
            return f"no {event.get('type', '')} {name} from outside".replace("  ", " ")
        if event.get("ob", _WIRED) != _WIRED or "flt_id" in event:
            return f"no interrupt of OB {event['ob']} from outside"
        if stopped and name == "clock":
            return "no clock set in STOP"
        stopped = name == "stop" or (stopped and name != "restart")
    restarts = header.get("mode") != "RUN" or any(event["event"] == "restart" for event in program.outside)
    if restarts and _STARTUP_OB not in header["obs"]:
        return f"no OB {_STARTUP_OB}, from which a restart is known"
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
    clock, state = _bcd(program.plain["header"]["clock"]), _STATES[program.header.get("mode", "STOP")]
    return _HEADER.pack(_MAGIC, _LAYOUT, MOST, 0, state, 0, 0, clock, program.duration, _HEADER.size) + b"".join(steps)


def happened(content: bytes) -> int:
    """How many events from outside the interpreter has brought about; ``content`` is the beginning of DB 110."""
    return (int.from_bytes(content[NEXT : NEXT + 4]) - _HEADER.size) // _STEP.size


def restarted(elapsed: int, events: int) -> dict[int, bytes]:
    """What to write into DB 110, by its byte, before a restart: the program has gone on for ``elapsed`` ms, and as many
    events from outside are over.
    """
    place = _HEADER.size + events * _STEP.size
    return {NEXT: place.to_bytes(4), BEGUN: elapsed.to_bytes(4), STATE: _RESTARTED.to_bytes(2)}


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
    return _STEP.pack(sfc(step["call"]), step.get("mode", 0), step.get("ob", 0), word, 0, given)


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
