"""Whether a log is the log of its program: the CPU of the header, the events from outside, the calls in their order.

This says nothing about the CPU, whose behaviour the specification judges: it finds an adapter that runs another program
or leaves parts of it out.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import replace
from itertools import islice
from typing import Any

import msgspec

from s7check.asking.session import Session
from s7check.engine.client import Engine
from s7check.kit.program import HEADER_FIELDS, Program, outside_events
from s7check.kit.turns import calls_departure
from s7check.kit.whole import Whole, elapsed
from s7check.log.calls import LOG_FORMAT
from s7check.log.objects import decoded
from s7check.log.values import instant, iso

_OF_PROGRAM = tuple(name for name in HEADER_FIELDS if name != "cycle")

_SURE = ("load", "delete", "restart")
"""Events from outside that reach a CPU in every mode."""

_NEVER = ("state",)
"""No line of these is ever owed."""

_SLACK = 1_000
"""Milliseconds, and 1 % of the time, by which an implementation may miss the moment of an event."""

_ASKED = 20
"""Events without a line about which the specification is asked, at most, for each program."""


def departure(engine: Engine, program: Program, log: Whole) -> str:
    """The first place where the log is not that of the program; empty if there is none.

    The log was accepted. Raises EngineError.
    """
    header = log.content.header
    assert header is not None
    own = engine.read(msgspec.json.encode({"format": LOG_FORMAT, **program.header})).header
    assert own is not None
    for field in _OF_PROGRAM:
        if _ordered(header[field]) != _ordered(own[field]):
            return f'line 1: field "{field}": expected that of the program'
    calls, over = calls_departure(program, header["latency"], log.content.events, log.until)
    if calls:
        return calls
    missing = list(_without_line(program, log))
    if not missing and not over:
        return ""
    reached = _Reached(engine, log, header["latency"])
    try:
        return _outside(reached, missing, log.until) or (
            "the log has no run, and STARTUP is over" if over and reached.may_run(log.until) else ""
        )
    finally:
        reached.close()


def _ordered(value: Any) -> Any:
    """Maps of the header have become lists in the order in which they were written."""
    return sorted(value, key=str) if isinstance(value, list) else value


def _outside(reached: _Reached, missing: list[tuple[int, dict[str, Any]]], until: int) -> str:
    """The first event from outside that has to be in the log and is not."""
    for after, event in missing:
        if event["event"] in _SURE:
            return _lacks(after, event)
    others = (one for one in missing if one[0] < until and one[1]["event"] not in _NEVER)
    for after, event in islice(others, _ASKED):
        if reached.by(after, event):
            return _lacks(after, event)
    return ""


def _lacks(after: int, event: dict[str, Any]) -> str:
    what = event["event"] + (f" of OB {event['ob']}" if "ob" in event else "")
    return f"the log has no {what}, which comes after {after} ms"


def _kind(event: dict[str, Any]) -> tuple[object, ...]:
    fault = event.get("flt_id", -1)
    zone = (event["zone"], event["reason"]) if event["event"] == "zone" else None
    return (event["event"], event.get("ob"), fault if event["event"] == "interrupt" else -1, zone)


def _without_line(program: Program, log: Whole) -> Iterator[tuple[int, dict[str, Any]]]:
    """The events from outside that no line of their time shows."""
    logged: dict[tuple[object, ...], list[int]] = defaultdict(list)
    for event in reversed(log.content.events):
        logged[_kind(event)].append(elapsed(event))
    for after, event in outside_events(replace(program, outside=tuple(program.plain["outside"]))):
        slack = _SLACK + after // 100
        times = logged[_kind(event)]
        if event["event"] in _SURE:
            slack = program.duration  # a restart may wait for its STOP
        while times and times[-1] < after - slack:
            times.pop()
        if times and times[-1] <= after + slack:
            times.pop()
        else:
            yield after, event


class _Reached:
    """Asks the specification whether the CPU of a log notices an event from outside: whether it then is another CPU."""

    def __init__(self, engine: Engine, log: Whole, latency: int) -> None:
        header, *lines = [line for line in log.lines if line.strip()]
        self._latency = latency
        raws = zip(map(decoded, lines), log.content.events, strict=False)
        self._lines = [(elapsed(event), raw) for raw, event in raws if raw["event"] != "done"]
        self._session = Session(engine, decoded(header))
        self._fed = 0
        self._up = 0

    def by(self, after: int, event: dict[str, Any]) -> bool:
        """Whether it is noticed at its time, in whatever order with the lines of that time."""
        self._feed_until(after)
        branch = self._session.branch()
        try:
            noticed = self._notices(branch, after - self._up, after, event)
            for up, raw in self._lines[self._fed :]:
                if not noticed or up > after + self._latency:
                    break
                noticed = branch.feed(raw) is None and self._notices(branch, 0, up, event)
            return noticed
        finally:
            branch.close()

    def _feed_until(self, after: int) -> None:
        while self._fed < len(self._lines) and self._lines[self._fed][0] < after:
            self._up, raw = self._lines[self._fed]
            self._session.feed(raw)
            self._fed += 1

    def may_run(self, until: int) -> bool:
        """Whether the mode RUN may come behind the last line."""
        self._feed_until(until + 1)
        return self._session.why(self._now(self._session, until - self._up, until) | {"event": "run"}) is None

    def _now(self, session: Session, later: int, up: int) -> dict[str, Any]:
        clock = instant(session.clock) + later
        return {"at": iso(clock), **({"up": up} if session.lines and "up" in session.lines[-1] else {})}

    def _notices(self, session: Session, later: int, up: int, event: dict[str, Any]) -> bool:
        now = self._now(session, later, up)
        line = {name: value for name, value in event.items() if name not in ("after", "every", "by")}
        if "by" in event:
            line["to"] = iso(instant(now["at"]) + event["by"])
        with_event, without = session.branch(), session.branch()
        try:
            if with_event.feed(now | line) is not None or without.feed(now | {"event": "done"}) is not None:
                return False
            if line["event"] == "interrupt":
                # It may be lost by a rule, and the log shows that. In STOP it reaches nobody.
                return all(one.mode != "STOP" for one in without.situations())
            return with_event.possible([]).key != without.possible([]).key
        finally:
            with_event.close()
            without.close()

    def close(self) -> None:
        """Ends the sessions in the engine."""
        self._session.close()
