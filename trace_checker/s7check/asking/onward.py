"""Beyond a rejected line: what else a log does against the rules.

The judging goes on as if something else had stood there: the line with another answer or with fewer details, something
in front of it, or nothing at all. Of these the one is taken with which most of the next lines can be explained.
"""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, NamedTuple

from msgspec.structs import replace

from s7check.asking.session import Session
from s7check.engine.answer import Allowed, Answer, Refusal
from s7check.engine.client import Engine
from s7check.judging.check import rejection
from s7check.log.calls import OPERANDS
from s7check.log.chosen import Chosen
from s7check.log.errors import UnusableLogError
from s7check.log.objects import objects
from s7check.report.clauses import texts
from s7check.report.report import Report

MOST = 100
"""Rejections of a log."""

_AHEAD = 40
"""Lines that are looked at to compare two ways to go on."""

_DETAILS = ("info", "status", "cause", "flt_id", "counter", "up")
"""Fields that a line need not have."""

Line = dict[str, Any]


@dataclass(frozen=True)
class _Way:
    """A way to go on: the lines in the place of the rejected one, and how many behind it are passed over."""

    said: str
    lines: tuple[Line, ...]
    passed: frozenset[int] = frozenset()


@dataclass
class _Tried:
    """A session that went on in a way, and how many of the lines behind it it explained."""

    way: _Way
    session: Session
    explained: int


class Onward(NamedTuple):
    """A rejection behind the first one: the report, which says how the judging went on, and the log as judged."""

    report: Report
    header: Line
    lines: Sequence[Line]
    """The events up to the rejected one, with those that were taken in place of rejected ones."""


def rejections(name: str, report: Report, engine: Engine, chosen: Chosen) -> Iterator[Onward]:
    """The rejections of a log behind the first one, of which ``report`` tells.

    A line that is not of the format ends them. Raises EngineError.
    """
    engine.tell(texts)
    try:
        _, _, header = next(lines := objects(name))
        session = Session(engine, _with(header, chosen))
    except (UnusableLogError, StopIteration):
        return
    read: list[tuple[int, bytes, Line]] = []
    with suppress(UnusableLogError):  # the lines before it are judged
        read.extend(lines)
    place, found, said = 0, 0, ""
    passed: frozenset[int] = frozenset()
    while place < len(read) and found < MOST:
        number, text, line = read[place]
        refusal = None if place in passed else _feed(session, line)
        place += 1
        if refusal is None:
            continue
        found += 1
        if found > 1:
            answer = Answer("rejected", number, len(session.lines), message=refusal.message)
            rejected = replace(rejection(report.log, answer, refusal, text, []), after=said)
            yield Onward(rejected, session.header, [*session.lines, line])
        best = _best(session, refusal, read, place - 1)
        session.close()
        session, passed = best.session, best.way.passed
        said = f"line {number} {best.way.said}"
    session.close()


def _with(header: Mapping[str, Any], chosen: Chosen) -> dict[str, Any]:
    letters = {"readings": {**header.get("readings", {}), **chosen.letters}} if chosen.letters else {}
    return {**header, **({"profile": chosen.profile} if chosen.profile else {}), **letters}


def _feed(session: Session, line: Line) -> Refusal | None:
    """Why the line is not possible; one that cannot be read is taken for one that says nothing."""
    try:
        return session.feed(line)
    except UnusableLogError:
        return None


def _best(session: Session, refusal: Refusal, read: Sequence[tuple[int, bytes, Line]], place: int) -> _Tried:
    """The way with which most of the next lines are explained; the first of several."""
    best: _Tried | None = None
    for way in _ways(refusal, session.clock, read, place):
        tried = _tried(session, way, read, place)
        if tried is None:
            continue
        if best is None or tried.explained > best.explained:
            if best is not None:
                best.session.close()
            best = tried
        else:
            tried.session.close()
    assert best is not None  # nothing at all is always a way
    return best


def _tried(session: Session, way: _Way, read: Sequence[tuple[int, bytes, Line]], place: int) -> _Tried | None:
    """The way, gone on from a twin of the session; none if its own lines are not possible."""
    twin = session.branch()
    if any(_feed(twin, line) is not None for line in way.lines):
        twin.close()
        return None
    ahead = twin.branch()
    explained = 0
    for offset, (_, _, line) in enumerate(read[place + 1 : place + 1 + _AHEAD], place + 1):
        if offset not in way.passed and _feed(ahead, line) is not None:
            break
        explained += 1
    ahead.close()
    return _Tried(way, twin, explained)


def _ways(refusal: Refusal, clock: str, read: Sequence[tuple[int, bytes, Line]], place: int) -> Iterator[_Way]:
    line = read[place][2]
    for allowed in refusal.expected:
        spelled = allowed.text
        if not refusal.late and _answers(line, allowed):
            yield _Way(f"taken as {spelled}", ({**line, allowed.field: allowed.value},))
        else:
            # What is late had to come at some time since the line before; an OB may have ended meanwhile, too.
            owed = _as_line(allowed, clock if refusal.late else str(line["at"]))
            yield _Way(f"taken with {spelled} before it", (owed, line))
            if allowed.event == "start":
                yield _Way(f"taken with {spelled} and its end before it", (owed, {**owed, "event": "end"}, line))
    plain = {field: value for field, value in line.items() if field not in _DETAILS}
    if plain != line:
        yield _Way("taken without its details", (plain,))
    yield _Way("left out", ())
    if line["event"] == "start":
        run = _run(read, place)
        yield _Way("left out with its run", (), run)


def _answers(line: Line, allowed: Allowed) -> bool:
    """Whether the specification allows the same call with another answer."""
    same = line["event"] == allowed.event and line.get("ob", 0) in (0, allowed.ob)
    return same and line["event"] in OPERANDS and bool(allowed.field)


def _as_line(allowed: Allowed, at: str) -> Line:
    made: Line = {"event": allowed.event, "at": at}
    if allowed.ob:
        made["ob"] = allowed.ob
    if allowed.field in ("cause", "id"):
        made[allowed.field] = allowed.value
    return made


def _run(read: Sequence[tuple[int, bytes, Line]], place: int) -> frozenset[int]:
    """The places of the lines of the run that starts at ``place``: its calls and its end."""
    ob = read[place][2].get("ob")
    depth = 0
    places = []
    for offset, (_, _, line) in enumerate(read[place + 1 :], place + 1):
        name = line.get("event")
        if name == "start":
            depth += 1
        elif name == "end" and depth:
            depth -= 1
        elif depth == 0 and (name in OPERANDS or (name == "end" and line.get("ob") == ob)):
            places.append(offset)
        if name in ("stop", "restart") or (name == "end" and line.get("ob") == ob and places and places[-1] == offset):
            break
    return frozenset(places)
