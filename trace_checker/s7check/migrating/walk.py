"""A log, line by line, on the CPU that wrote it and on one of another family.

Where the other CPU would not show a line it is brought back to the log: it starts the OB that it had to start, or
leaves out the run, the answer or the STOP that it does not know. So later differences are found, too, each as if the
earlier ones had made no difference to what the program does.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import msgspec

from s7check.asking.line_text import spelled
from s7check.asking.log_prefix import Prefix
from s7check.asking.session import Session
from s7check.asking.variants import fitted
from s7check.engine import pool
from s7check.engine.answer import Refusal
from s7check.engine.client import Engine
from s7check.log.errors import UnusableLogError
from s7check.log.values import instant, iso
from s7check.migrating.table import Difference, differences

Json = dict[str, Any]

_SETTING = ("SET_TINT", "ACT_TINT", "SRT_DINT")
_OB_RUNS = 1
"""Milliseconds of a run that the other CPU has and the log has not."""
_MOST_DUE = 20
"""Runs that are put in before one line."""


class Point(msgspec.Struct, frozen=True):
    """A line that the other CPU ``will`` not show, or may not (``may``), or about which there is a ``hint``.

    ``instead`` is what it shows in its place. ``old`` and ``new`` are the requirements of both sides.
    """

    line: int
    at: str
    text: str
    kind: str
    instead: list[str]
    old: list[str]
    new: list[str]
    differences: list[Difference]


def migrated(header: Json, family: str, new_project: bool) -> Json:
    """The header on a CPU of the family: the priorities are kept, as a migration does, or those of a new project."""
    words = pool.alternatives()
    kept = {} if new_project else {str(ob): level for ob, level in dict(words.usual)[header["cpu"]]}
    loaded = {str(ob) for ob in header["obs"]}
    priority = {ob: level for ob, level in kept.items() if ob in loaded} | header.get("priority", {})
    readings = {name: letter for name, letter in header.get("readings", {}).items() if name.startswith("A15-")}
    plain = {name: value for name, value in header.items() if name not in ("priority", "readings", "profile")}
    return fitted(plain | ({"priority": priority} if priority else {}) | {"readings": readings}, family, words)


@dataclass
class Walk:
    """Both sessions, and the runs of the log's OBs: whether the other CPU has each of them, too."""

    old: Session
    new: Session
    table: Sequence[Difference]
    latency: int
    runs: list[tuple[int, bool]] = field(default_factory=list)

    def take(self, number: int, line: Json) -> Iterator[Point]:
        """The points at a line. Raises EngineError."""
        for refusal in self._refusals(line):
            yield self._point(number, line, "will", refusal)
        if self._may_be_missing(line):
            yield self._point(number, line, "may", None)
        for one in self.table:
            if one.fits(line, hint=True):
                yield self._told(number, line, "hint", [], [], [], [one])
        self.old.feed(line)

    def _refusals(self, line: Json) -> Iterator[Refusal]:
        """Why the other CPU does not show the line, as often as it has to be brought back to the log."""
        if self._left_out(line):
            return
        for _ in range(_MOST_DUE):
            refusal = self._feed(line)
            if refusal is None:
                break
            if line["event"] != "diag":  # entries follow from what the other lines say
                yield refusal
            if not (refusal.late and self._put_in(line)):
                self._leave_out(line)
                return
        if line["event"] == "start":
            self.runs.append((line["ob"], True))
        elif line["event"] in ("stop", "restart"):
            self.runs.clear()

    def _feed(self, line: Json) -> Refusal | None:
        """Why the other CPU refuses the line; without a requirement where no log of it can have such a line."""
        try:
            return self.new.feed(line)
        except UnusableLogError:
            return Refusal()

    def _left_out(self, line: Json) -> bool:
        """Whether the line belongs to a run that the other CPU does not have; ends of runs are counted."""
        within = bool(self.runs) and not self.runs[-1][1]
        if line["event"] == "end" and self.runs and self.runs[-1][0] == line["ob"]:
            self.runs.pop()
        return within and (line["event"] == "end" or str(line["event"]).isupper())

    def _leave_out(self, line: Json) -> None:
        """The other CPU goes on without the line, or with what is nearest to it."""
        if line["event"] == "start":
            self.runs.append((line["ob"], False))
        elif line["event"] == "stop":
            self.new.feed({"event": "stop", "at": line["at"]})
            self.runs.clear()
        elif line["event"] == "restart":
            self.new.feed({"event": "restart", "at": line["at"], "type": "warm"})
            self.runs.clear()
        elif str(line["event"]).isupper():
            self.new.feed(
                {**line, "ret": None} if line["event"] not in ("QRY_TINT", "QRY_DINT") else {**line, "ret": 0}
            )

    def _put_in(self, line: Json) -> bool:
        """Lets an OB run that had to start before the line. Whether there is one."""
        possible = self.new.possible(only=("start", "stop"))
        for one in possible.lines:
            time = possible.times[one.first].at
            at = iso(time.min * 60_000 + time.ms)
            ob = one.event.get("ob")
            if (
                one.event["event"] == "start"
                and ob != 1
                and self.new.feed({"event": "start", "ob": ob, "at": at}) is None
            ):
                end = iso(min(instant(at) + _OB_RUNS, max(instant(at), instant(line["at"]))))
                self.new.feed({"event": "end", "ob": ob, "at": end})
                return True
        return False

    def _may_be_missing(self, line: Json) -> bool:
        """Whether the old CPU had to start this OB, or to stop, and the other one need not."""
        start = line["event"] == "start" and line["ob"] != 1
        stop = line["event"] == "stop" and "cause" not in line
        if not (start or stop) or not self.new.lines or self.new.lines[-1] != line:
            return False
        later = {"event": "stop" if start else "hold", "at": iso(instant(line["at"]) + self.latency + 1)}
        self.new.undo()
        free = _owed(self.old, later) and not _owed(self.new, later)
        self.new.feed(line)
        return free

    def _point(self, number: int, line: Json, kind: str, refusal: Refusal | None) -> Point:
        possible = self.old.possible([line], line["at"])
        old = sorted({name for one in possible.lines for name in one.requirements})
        new = list(refusal.requirements) if refusal else []
        instead = [one.text for one in refusal.expected] if refusal else []
        return self._told(number, line, kind, instead, old, new, matching(self.table, line, old, new, refusal))

    @staticmethod
    def _told(
        number: int,
        line: Json,
        kind: str,
        instead: list[str],
        old: list[str],
        new: list[str],
        found: list[Difference],
    ) -> Point:
        return Point(number, line["at"], spelled(line), kind, instead, old, new, found)


def _owed(session: Session, later: Json) -> bool:
    """Whether something has to come before a later line."""
    refusal = session.why(later)
    return refusal is not None and refusal.late


def matching(
    table: Sequence[Difference], line: Json, old: Sequence[str], new: Sequence[str], refusal: Refusal | None
) -> list[Difference]:
    """The differences that share most with a point: their line, and requirements of both sides; none is a guess.

    Of a line that may come those go first that no log shows, since the new CPU may do as the old one.
    """
    late = refusal is not None and refusal.late
    due = [{"event": one.event, "ob": one.ob} for one in refusal.expected] if refusal and late else []

    def score(one: Difference) -> int:
        shared = 2 * len({*one.old} & {*old}) + 3 * len({*one.new} & {*new})
        known = bool(one.lines) and not one.lines[0].startswith("?")
        if (one.none and not known) or not shared or (known and not any(map(one.fits, due or [line]))):
            return 0
        return shared + (4 if known else 0)

    best = max((score(one) for one in table), default=0)
    found = [one for one in table if best and score(one) == best]
    open_ones = [one for one in found if one.none and refusal is None]
    return open_ones or found


def _not_there(header: Json, other: Json, table: Sequence[Difference]) -> Iterator[Point]:
    """A hint about each OB of the header that the other CPU does not have."""
    for ob in sorted({*header["obs"]} - {*other["obs"]}):
        found = [one for one in table if one.fits({"event": "start", "ob": ob})]
        yield Point(1, header["clock"], f"OB {ob} is loaded", "hint", [], [], [], found)


def points(engine: Engine, prefix: Prefix, family: str, new_project: bool = False) -> Iterator[Point]:
    """The points of a log, as they come. Raises EngineError, UnusableLogError."""
    header = prefix.header
    other = migrated(header, family, new_project)
    table = differences(family)
    yield from _not_there(header, other, table)
    walk = Walk(Session(engine, header), Session(engine, other), table, int(header.get("latency_ms", 10)))
    for number, line in prefix.events:
        yield from walk.take(number, line)
