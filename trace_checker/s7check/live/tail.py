"""What is new in a running CPU: entries of the ring and of the diagnostic buffer as events, in the order of the CPU.

Each poll reads the ring's counter, then the diagnostic buffer, then the slots up to that counter. So every entry of the
buffer that is older than one of these slots is at hand; those behind the last slot wait for the next poll. Where it is
not certain what is missing or which came first, there is a cut, and nothing is guessed.
"""

import sys
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from datetime import datetime
from time import monotonic
from typing import Any, NamedTuple

from s7check.importing.asking import Entry, Ring, Slot, entries_of, events_of, state_of
from s7check.importing.errors import SourceError
from s7check.live.connection import Connection

_FEW = 5
"""Records of the diagnostic buffer that are read each time: one answer, also of a CPU with short PDUs."""

_KNOWN = 3
"""Records by which the last one is found again: two may be alike."""

_PATIENCE = 10
"""Polls for which a RET_VAL that is not there yet is waited for."""

_DRIFT_S = 1.0
"""The CPU clock and that of this machine run apart by no more between two polls, and a hundredth."""

_MODES = {"restart": ("STOP", "STARTUP"), "run": ("STARTUP", "RUN")}
"""Event that the ring proves -> mode before, mode after."""

_LATE = (0, 42)
"""Codes of entries that may be completed after they are counted: SFC 0 and 42."""

_TRIES = 5


class Event(NamedTuple):
    """An event without a gap before it; ``mode`` was that of the CPU before, ``begins``: a log can begin there."""

    fields: dict[str, Any]
    mode: str | None
    begins: bool


class Cut(NamedTuple):
    """Something is missing here, or its order is not known."""

    reason: str


@dataclass
class _Waiting:
    """What was read and is not told yet, oldest first; ``settled`` of ``diag`` were read in an earlier poll."""

    ring: deque[Slot | Cut] = field(default_factory=deque)
    diag: deque[Entry] = field(default_factory=deque)
    settled: int = 0
    polls: int = 0


class Tail:
    """Follows a CPU from now on. Methods raise SourceError, NoAnswerError where the CPU does not answer.

    ``now`` is a clock of this machine, in seconds, with which that of the CPU is compared; None: with the ring alone.
    """

    def __init__(self, cpu: Connection, now: Callable[[], float] | None = monotonic) -> None:
        self._cpu = cpu
        self._now = now
        self._known: list[bytes] = []
        self._clocks: list[tuple[datetime, float]] = []
        self._jumped = False
        self._waiting = _Waiting()
        self._elapsed: dict[str, Any] = {}
        self._set_before = False
        self._last = ""
        self.written = cpu.ring().written
        self.mode: str | None = None
        self._begin()

    @property
    def told_until(self) -> datetime | None:
        """A reading of the CPU clock up to which everything has been told; None while something waits.

        That of the poll before: who had to write an entry by then has had time for it.
        """
        return None if self._waiting.ring or self._waiting.diag or len(self._clocks) < 2 else self._clocks[0][0]

    def poll(self) -> Iterator[Event | Cut]:
        """What is new."""
        self._read_clock()
        header = self._cpu.ring()
        self._waiting.settled = len(self._waiting.diag)
        known = self._read_diag()
        self._read_slots(header)
        sets = [one for one in self._waiting.ring if isinstance(one, Slot) and one.sets]
        if any(one.at >= diag.at >= one.set_to for one in sets for diag in self._waiting.diag):
            # Nobody knows whether the entry of the buffer comes before the clock was set back, or after.
            self._waiting.ring.clear()
            yield self._cut("the clock was set back, and the order of entries about then is not certain")
            known = False
        else:
            yield from self._merged()
        if self._jumped and not sets and not self._set_before:
            yield self._cut("the clock was set, by whom and when is not known")
        self._jumped, self._set_before = False, bool(sets)
        if not known:
            yield self._cut("entries of the diagnostic buffer are missing")
            self._begin()

    def state(self, ob: int) -> tuple[str, str, dict[str, Any]] | None:
        """What the CPU says of an OB, between two readings of its clock; None unless all is told and stands still."""
        if self._waiting.ring or self._waiting.diag or self.mode != "RUN":
            return None
        before = self._cpu.clock()
        al1 = self._cpu.state(ob)
        after = self._cpu.clock()
        if al1 is None or after < before or self._cpu.ring().written != self.written:
            return None
        said = state_of(ob, al1)
        return _spelled(before), _spelled(after), {"event": "state", "ob": ob, **said}

    def _begin(self) -> None:
        """The newest record and the mode, of one moment."""
        for _ in range(_TRIES):
            before = self._cpu.newest(_FEW)
            self.mode = self._cpu.mode()
            self._known = self._cpu.newest(_FEW)
            if before == self._known:
                break
        else:
            raise SourceError("", "a diagnostic buffer that stands still for a moment", "new entries all the time")
        self._waiting.diag.clear()
        self._waiting.settled = 0

    def _read_clock(self) -> None:
        asked = self._now() if self._now else 0
        clock, answered = self._cpu.clock(), self._now() if self._now else 0
        if self._clocks and self._now:
            last, then = self._clocks[-1]
            passed = answered - then
            apart = abs((clock - last).total_seconds() - passed)
            self._jumped |= apart > _DRIFT_S + passed / 100 + (answered - asked)
        self._clocks = [*self._clocks[-1:], (clock, asked)]

    def _read_diag(self) -> bool:
        """Reads the new entries of the diagnostic buffer, by comparing. False if the last one is gone."""
        for read, longest in ((self._newest, _FEW), (self._cpu.all_records, sys.maxsize)):
            records = read()
            new = _new(records, self._known, longest)
            if new is not None:
                self._known = records[:_FEW]
                self._waiting.diag += entries_of(records[:new][::-1])
                return True
        return False

    def _newest(self) -> list[bytes]:
        return self._cpu.newest(_FEW)

    def _read_slots(self, header: Ring) -> None:
        """The entries up to the counter; what was overwritten before it was read is a cut."""
        waiting = self._waiting.ring
        if header.written < self.written:
            waiting.append(Cut("the ring was emptied"))
            self.written = 0
        oldest = header.written + 2 - header.capacity
        wanted = max(self.written + 1, oldest)
        entries = self._cpu.slots(header, wanted, header.written) if wanted <= header.written else []
        # Of an entry that is completed later RET_VAL comes, then the mark that it is there.
        late = [one for one in entries if one.code in _LATE and one.done]
        again = {one.number: self._cpu.slots(header, one.number, one.number)[0] for one in late}
        if entries:
            after = self._cpu.ring()
            oldest = after.written + 2 - after.capacity
        for number, entry in enumerate((again.get(one.number, one) for one in entries), wanted):
            if number >= oldest and entry.number == number:
                if number != self.written + 1:
                    waiting.append(Cut(f"{number - self.written - 1} entries of the ring were overwritten"))
                waiting.append(entry)
                self.written = number
        if self.written < header.written:
            waiting.append(Cut(f"{header.written - self.written} entries of the ring were overwritten"))
            self.written = header.written
        self._complete(header)

    def _complete(self, header: Ring) -> None:
        """Reads the entries again that wait for their RET_VAL."""
        waiting = self._waiting
        for place, entry in enumerate(waiting.ring):
            if isinstance(entry, Slot) and not entry.done:
                (read,) = self._cpu.slots(header, entry.number, entry.number)
                if read.number == entry.number and read.done:
                    (read,) = self._cpu.slots(header, entry.number, entry.number)
                    waiting.ring[place] = read if read.number == entry.number else entry

    def _merged(self) -> Iterator[Event | Cut]:
        waiting = self._waiting
        while waiting.ring or waiting.diag:
            head = waiting.ring[0] if waiting.ring else None
            if isinstance(head, Cut):
                waiting.ring.popleft()
                yield self._cut(head.reason)
            elif waiting.diag and (head is None or self._is_before(waiting.diag[0], head)):
                if (head is None and not waiting.settled) or self._waits_for_kind(head):
                    return
                waiting.settled = max(0, waiting.settled - 1)
                yield from self._of_diag(waiting.diag.popleft(), head)
            elif head is not None:
                if not head.done and head.code in _LATE and waiting.polls < _PATIENCE:
                    waiting.polls += 1
                    return
                waiting.polls = 0
                waiting.ring.popleft()
                yield from self._of_ring(head)

    def _is_before(self, diag: Entry, entry: Slot) -> bool:
        """Of one millisecond, a restart is before the entries of the ring, and RUN before those of no startup OB."""
        at = entry.at
        if diag.at < self._last:  # behind a setting of the clock that the ring has yet to tell of
            return False
        change = diag.change
        if diag.at == at and change is not None:
            return change[1] == "STARTUP" or (change[1] == "RUN" and not entry.startup)
        return diag.at < at

    def _waits_for_kind(self, head: Slot | None) -> bool:
        """Whether the oldest entry of the buffer begins a restart whose kind a later entry will tell."""
        change = self._waiting.diag[0].change
        if change is None or change[1] != "STARTUP" or self.mode == "STARTUP":
            return False
        told = _told_with(list(self._waiting.diag))
        ended = any(one.change is not None for one in list(self._waiting.diag)[1:])
        return told is None and head is None and not ended

    def _of_diag(self, entry: Entry, head: Slot | None) -> Iterator[Event | Cut]:
        if entry.at < self._last:
            yield self._cut("the clock was set back, by whom and when is not known")
        change = entry.change
        if entry.power:
            yield self._cut("the power failed")
            self.mode = "STOP"
        elif change is not None and change[1] != self.mode:
            yield from self._change(entry, head, *change)
        yield self._told(entry.event)

    def _change(self, entry: Entry, head: Slot | None, old: str | None, new: str | None) -> Iterator[Event | Cut]:
        """The line of a change of the mode; a cut where the entries do not tell it."""
        event = _told_with([entry, *self._waiting.diag])
        if event is None and (old, new) == ("STOP", "STARTUP") and head is not None and head.restart:
            event = {"event": "restart", "at": entry.at, **head.restart}
        if event is None or old not in (None, self.mode):
            yield self._cut("a change of the mode is missing, or its kind is not told")
        else:
            yield self._told(event)
        self.mode = new

    def _of_ring(self, entry: Slot) -> Iterator[Event | Cut]:
        try:
            told = events_of([entry], self._elapsed)
        except SourceError as error:
            yield self._cut(str(error))
            return
        self._elapsed = told.elapsed
        if told.jumped:
            yield self._cut("the clock was set, by whom and when is not known")
        for event in told.events:
            before, after = _MODES.get(event["event"], (None, None))
            if after is not None and after == self.mode:
                continue  # the diagnostic buffer has told it
            if self.mode != before if before else self.mode in ("STOP", "HOLD"):
                yield self._cut("a change of the mode is missing")
                self.mode = before or ("STARTUP" if entry.startup else "RUN")
            yield self._told(event, entry.begins)
            self.mode = after or self.mode
            self._last = event.get("to", self._last)

    def _told(self, event: dict[str, Any], begins: bool = False) -> Event:
        self._last = event["at"]
        return Event(event, self.mode, begins)

    def _cut(self, reason: str) -> Cut:
        self._last = ""
        return Cut(reason)


def _told_with(entries: list[Entry]) -> dict[str, Any] | None:
    """The line of the mode that the first entry tells, by those that follow it."""
    return entries_of([one.record for one in entries])[0].told


def _spelled(clock: datetime) -> str:
    return clock.isoformat(timespec="milliseconds")


def _new(records: list[bytes], known: list[bytes], longest: int) -> int | None:
    """How many of the newest ``longest`` records come before those that are known; None if these are not there."""
    if not known:
        return len(records) if len(records) < longest else None
    for count in range(len(records)):
        same = known[: min(_KNOWN, len(records) - count)]
        if records[count : count + len(same)] == same:
            return count
    return None
