"""Sentences about the lines of a log, from the situations before and after them."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Any

from s7check.asking.line_text import iso_of, spelled
from s7check.engine.answer import Moment, Pending, Situation
from s7check.log.errors import ranges
from s7check.report.clauses import event_text

_NO_CAUSE = -1
_CYCLE_CLASS = 1

_LINES = {
    "end": "OB {ob} ends",
    "restart": "a {type} restart begins",
    "run": "the CPU goes to RUN",
    "hold": "the CPU is put on HOLD",
    "release": "the CPU leaves HOLD",
    "load": "OB {ob} is loaded",
    "delete": "OB {ob} is deleted",
    "interrupt": "a start event for OB {ob} comes from outside",
    "clock": "the clock is set to {to}",
    "zone": "local time is {zone} min ahead of the clock from now on",
    "done": "the log ends; nothing is missing up to here",
    "state": "the state of OB {ob} is read",
}


def by_itself(before: Situation, after: Situation) -> Iterator[str]:
    """What has happened without a line."""
    waiting = [request for request in after.pending if _of(request) not in map(_of, before.pending)]
    due = {request.ob for request in waiting}
    runs = {frame.ob for frame in after.running}
    then = {tod.ob: tod for tod in after.tod}
    for tod in before.tod:
        now = then.get(tod.ob)
        if tod.armed and (now is None or now.next != tod.next):
            again = " again while it runs" if tod.ob in runs else ""
            lost = ", which comes to nothing" if tod.ob in after.blocked else ""
            yield f"OB {tod.ob} is due{again}, its point {_moment(tod.next)} is reached{lost}"
    left = {job.ob for job in after.dint}
    for job in before.dint:
        if job.ob not in left:
            again = " while the OB runs" if job.ob in runs else ""
            yield f"the delay of OB {job.ob} is over{again}"
    known = {tod.ob for tod in before.tod} | {job.ob for job in before.dint}
    for request in waiting:
        if request.fault or request.ob not in known:
            yield _requested(request)
    for request in before.pending:
        if request.missing and _of(request) not in map(_of, after.pending) and request.ob not in due:
            yield f"OB {request.ob} is missing when it would start"
    yield from _unseen(before, after)
    if before.stop == _NO_CAUSE != after.stop:
        yield _stop(after.stop)


def _unseen(before: Situation, after: Situation) -> Iterator[str]:
    """The steps without a line that this explanation needs: ends and starts that the log leaves out."""
    if after.delay < before.delay and before.running:
        yield f"OB {before.running[-1].ob} has ended unseen, and with it the delay of interrupts (count {before.delay})"
    for verb, old, new in (("ended", before.running, after.running), ("started", after.running, before.running)):
        there = {frame.ob for frame in new}
        # A cycle may begin and end between any two lines; it is told where its end has an effect.
        gone = [frame.ob for frame in old if frame.ob not in there and frame.class_ > _CYCLE_CLASS]
        if gone:
            yield f"{_obs(gone)} {_has(gone)} {verb} unseen"


def of_line(line: dict[str, Any], before: Situation, after: Situation) -> Iterator[str]:
    """The event of the line, and its effects."""
    yield _said(line, before)
    if line["event"] in ("stop", "restart"):
        yield from _gone(before, after)
        return
    for request in after.pending:
        if _of(request) not in map(_of, before.pending):
            yield _requested(request)
    yield from _settings(before, after)
    if before.stop == _NO_CAUSE != after.stop:
        yield _stop(after.stop)


def _said(line: dict[str, Any], before: Situation) -> str:
    name = line["event"]
    if name.isupper():
        caller = f"OB {before.running[-1].ob}" if before.running else "the program"
        return f"{caller} calls {spelled(line)}"
    if name == "start":
        over = [frame.ob for frame in before.running if frame.ob != line["ob"]]
        request = next((one for one in before.pending if one.ob == line["ob"] and one.ready), None)
        why = f" with fault 16#{request.fault:02X}" if request is not None and request.fault > 0 else ""
        why += f" because of OB {request.cause}" if request is not None and request.cause else ""
        return f"OB {line['ob']} starts{why}" + (f", interrupting OB {over[-1]}" if over else "")
    if name == "stop":
        return "the CPU stops" + (f" for {_event(before.stop)}" if before.stop > 0 else "")
    if name == "diag":
        number = int(str(line["id"]).rpartition("#")[2], 16) if isinstance(line["id"], str) else line["id"]
        of = f" of OB {line['ob']}" if line.get("ob") else ""
        return f"the diagnostic buffer has the entry {_event(number)}{of}"
    form = _LINES.get(name)
    return spelled(line) if form is None else form.format_map(line)


def _gone(before: Situation, after: Situation) -> Iterator[str]:
    """What a STOP or a restart has ended, and which settings it has brought back."""
    if ended := {frame.ob for frame in before.running} - {frame.ob for frame in after.running}:
        yield f"{_obs(ended)} {_are(ended)} broken off"
    kept = set(map(_of, after.pending))
    if waited := sorted({request.ob for request in before.pending if _of(request) not in kept}):
        yield f"the start events of {_obs(waited)} no longer wait"
    set_now = {tod.ob: tod for tod in after.tod}
    if unset := [tod.ob for tod in before.tod if tod.ob not in set_now]:
        yield f"the time-of-day settings of {_obs(unset)} are erased"
    for tod in after.tod:
        old = next((one for one in before.tod if one.ob == tod.ob), None)
        if old is None or (old.start, old.period, old.active) != (tod.start, tod.period, tod.active):
            active = "active" if tod.active else "not active"
            yield f"OB {tod.ob} is set as by STEP 7, from {_moment(tod.start)}, {active}"
    if delays := sorted({job.ob for job in before.dint} - {job.ob for job in after.dint}):
        yield f"no delay of {_obs(delays)} runs any more"
    if freed := sorted(set(before.blocked) - set(after.blocked)):
        yield f"{_obs(freed)} {_are(freed)} blocked no more"


def _settings(before: Situation, after: Situation) -> Iterator[str]:
    if after.delay > before.delay:
        yield f"interrupts are delayed, count {after.delay}"
    elif after.delay < before.delay:
        yield f"the delay count falls to {after.delay}"
    gone, new = set(before.blocked) - set(after.blocked), set(after.blocked) - set(before.blocked)
    if new:
        yield f"start events are lost from now on for {_obs(new)}"
    if gone:
        yield f"start events count again for {_obs(gone)}"
    armed = {tod.ob: tod.next for tod in before.tod if tod.armed}
    for tod in after.tod:
        if tod.armed and armed.get(tod.ob) != tod.next:
            yield f"the next point of OB {tod.ob} is {_moment(tod.next)}"
    for job in after.dint:
        if job.ob not in {one.ob for one in before.dint}:
            yield f"OB {job.ob} is due in {job.left} ms"


def _requested(request: Pending) -> str:
    text = f"OB {request.ob} waits to start"
    if request.fault > 0:
        text = f"OB {request.ob} with fault 16#{request.fault:02X} is called"
    causes = request.late or ([request.cause] if request.cause else [])
    if causes:
        text += f" because of OB {', '.join(map(str, causes))}"
    if request.missing:
        text += "; it is missing"
    if request.open:
        text += "; the sources leave open whether it comes"
    return text


def _obs(numbers: Collection[int]) -> str:
    return f"OB {ranges(sorted(numbers))}"


def _has(numbers: Collection[int]) -> str:
    return "has" if len(numbers) == 1 else "have"


def _are(numbers: Collection[int]) -> str:
    return "is" if len(numbers) == 1 else "are"


def _stop(cause: int) -> str:
    return "the CPU has to stop" + (f" for {_event(cause)}" if cause > 0 else "")


def _event(number: int) -> str:
    """Such as ``16#4568 (STOP: OB 80 missing)``."""
    text = event_text(number)
    return f"16#{number & 0xFFFF:04X}" + (f" ({text})" if text else "")


def _of(request: Pending) -> tuple[object, ...]:
    return (request.ob, request.fault, request.cause, request.since, tuple(request.late))


def _moment(at: Moment) -> str:
    """As a log spells it, without the milliseconds of a whole minute."""
    return iso_of(at) if at.ms else iso_of(at)[:16]
