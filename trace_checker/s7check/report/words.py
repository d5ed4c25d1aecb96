"""The situation of a CPU in words."""

from s7check.engine.answer import BroughtBack, Candidate, Frame, Moment, Pending, Situation
from s7check.log.errors import ranges
from s7check.log.values import MS_PER_MINUTE, iso

_PERIODS = {
    0x0000: "once",
    0x0201: "every minute",
    0x0401: "hourly",
    0x1001: "daily",
    0x1201: "weekly",
    0x1202: "weekly",
    0x1401: "monthly",
    0x1801: "yearly",
    0x2001: "at the end of the month",
}
"""In words, for people; which codes there are, and when each comes round, the specification says."""
_NO_CAUSE = -1


def moment(at: Moment) -> str:
    """As a log spells it, without the milliseconds of a whole minute."""
    text = iso(at.min * MS_PER_MINUTE + at.ms)
    return text if at.ms else text[:16]


def situation(state: Situation) -> list[tuple[str, str]]:
    """The statements about a situation, each with its topic; empty ones are left out, but for the running OBs."""
    said = [("mode", f"{state.mode}, clock {moment(state.clock)}"), ("running", _running(state.running))]
    if state.delay:
        said.append(("delayed", f"{state.delay} DIS_AIRT not taken back"))
    said += [("pending", _pending(request, state)) for request in state.pending]
    for tod in state.tod:
        period = _PERIODS.get(tod.period, f"PERIOD 16#{tod.period:04X}")
        text = f"OB {tod.ob} {period} from {moment(tod.start)}, {'active' if tod.active else 'not active'}"
        said.append(("set", text + (f", next point {moment(tod.next)}" if tod.armed else "")))
    said += [
        ("started", f"OB {job.ob} after {job.dtime} ms, {job.left} ms left, SIGN 16#{job.sign & 0xFFFF:04X}")
        if job.left >= 0
        else ("started", f"OB {job.ob}, its delay over and lost")
        for job in state.dint
    ]
    if state.blocked:
        said.append(("blocked", f"OB {ranges(state.blocked)} by DIS_IRT"))
    if state.silenced:
        said.append(("no entries", f"OB {ranges(state.silenced)} by DIS_IRT"))
    if state.stop != _NO_CAUSE:
        cause = f" for 16#{state.stop:04X}" if state.stop else ""
        said.append(("STOP", f"must come{cause}"))
    if back := _brought_back(state.kept):
        said.append(("hot restart", f"brings back {back}"))
    said.append(("loaded", f"OB {ranges(state.loaded)}"))
    return said


def _brought_back(kept: BroughtBack) -> str:
    return "; ".join(
        said
        for there, said in (
            (kept.running, _running(kept.running)),
            (kept.delay, f"{kept.delay} DIS_AIRT not taken back"),
            (kept.pending, f"OB {ranges(kept.pending)} pending"),
            (kept.dint, f"OB {ranges(kept.dint)} started"),
        )
        if there
    )


def candidate(one: Candidate) -> str:
    """A sentence, then the condition that is false and the values of its operands.

    Such as ``EnAirt(16#0001) does not explain the line, since a condition is false: ret = delay - 1; here ret =
    16#0001, delay - 1 = 16#0000``.
    """
    here = f"; here {one.values}" if one.values else ""
    return f"{one.action} does not explain the line, since a condition is false: {one.conjunct}{here}"


def _running(frames: list[Frame]) -> str:
    if not frames:
        return "nothing"
    *below, top = frames
    text = f"OB {top.ob} (class {top.class_})"
    if below:
        text += ", interrupting " + ", ".join(f"OB {frame.ob} (class {frame.class_})" for frame in reversed(below))
    return text


def _pending(request: Pending, state: Situation) -> str:
    text = f"OB {request.ob} (class {request.class_}) since {moment(request.since)}"
    if request.fault > 0:
        text += f", fault 16#{request.fault:02X}"
    if request.cause:
        text += f" because of OB {request.cause}"
    if request.late:
        text += f", for OB {ranges(request.late)}"
    if request.open:
        text += ", which may also come to nothing"
    if request.missing:
        text += ", not loaded"
    if request.ready:
        waited = dict(state.waited).get(request.class_)
        text += ", may start" + (f" for {waited} ms, latency {state.latency} ms" if waited is not None else "")
    return text
