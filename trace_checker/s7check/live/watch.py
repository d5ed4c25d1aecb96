"""Logs of a running CPU, one after the other."""

from collections import deque
from collections.abc import Callable, Mapping
from pathlib import Path
from time import monotonic
from typing import Any, Generic, TypeVar

from s7check.importing.sources.live import NoAnswerError
from s7check.live.connection import Connection
from s7check.live.log import GrowingLog
from s7check.live.tail import Cut, Event, Tail
from s7check.log.calls import LOG_FORMAT
from s7check.log.values import instant
from s7check.report.report import Report

_OF_THE_CPU = ("mode", "clock")
"""Kinds that the CPU tells completely: every change of the mode, and a setting of the clock, or there is a cut."""

_WITH_STATE = frozenset({*range(10, 18), *range(20, 24)})
One = TypeVar("One")
_KEPT = 1000
_STATE_S = 1.0
_TRIES = 3


class Recent(Generic[One]):
    """The last of a growing number of things."""

    def __init__(self) -> None:
        self.count = 0
        self._kept: deque[One] = deque(maxlen=_KEPT)

    def append(self, one: One) -> None:
        """One more."""
        self.count += 1
        self._kept.append(one)

    def last(self, most: int) -> list[One]:
        """The last ones, the oldest of them first."""
        return list(self._kept)[-most:] if most else []

    def since(self, count: int) -> list[One]:
        """Those after the first ``count``, as far as they are kept."""
        return self.last(min(self.count - count, _KEPT))


class Watch:
    """Follows a CPU: ``step`` reads what is new. ``given`` has fields of the headers, ``file`` is the first log's.

    A log begins with the CPU in STOP, or while it runs, at an entry that OB 1 or a startup OB has made: what the
    program called before is not known then, so such a log does not record calls completely. It ends where something
    is missing, with a line that is not possible, and, if it began while the CPU ran, with the next restart.
    """

    def __init__(
        self, cpu: Connection, given: Mapping[str, Any], file: Path | None = None, now: Callable[[], float] = monotonic
    ) -> None:
        self._cpu = cpu
        self._given = dict(given)
        self._file = file
        self._now = now
        self.tail = Tail(cpu, now)
        self.log: GrowingLog | None = None
        self.reports: list[Report] = []
        self.lines: Recent[dict[str, Any]] = Recent()
        self.notes: Recent[str] = Recent()
        self.trouble = ""
        self.passed_over = 0
        self._partial = False
        self._logs = 0
        self._base: int | None = None
        self._obs = deque(sorted(_WITH_STATE & set(self._given.get("obs", []))))
        self._asked = now()
        self._refused = 0
        self._state: tuple[str, str, dict[str, Any]] | None = None

    def step(self) -> None:
        """Reads what is new; ``trouble`` says why that was not possible.

        Raises SourceError for what cannot be read as what it has to be.
        """
        try:
            new = 0
            for one in self.tail.poll():
                new += 1
                self._take(one)
            self.trouble = ""
        except NoAnswerError as error:
            self.trouble = str(error)
            self._state = None
            self._cpu.close()
            return
        if not new:
            self._take_state()
            self._take_silence()
        self._state = self._next_state()

    def end(self) -> None:
        """The log ends here."""
        self._end("the end of the watch", self._until())

    def _take(self, one: Event | Cut) -> None:
        if isinstance(one, Cut):
            self.notes.append(one.reason)
            self._end(one.reason)
            return
        if self.log is not None and self._partial and one.fields["event"] == "restart":
            self._end("a restart: from here on every call is known")
        if self.log is None and not self._begin(one):
            self.passed_over += 1
            return
        event = dict(one.fields)
        if "up" in event:
            assert self.log is not None
            if self._base is None:
                self._base = event["up"] - max(0, instant(event["at"]) - instant(self.log.header["clock"]))
            event["up"] -= self._base
        self._add(event)

    def _begin(self, one: Event) -> bool:
        """Whether a log can begin before the event."""
        if one.mode != "STOP" and not one.begins:
            return False
        self._partial = one.mode != "STOP"
        records = [*self._given.get("records", []), *_OF_THE_CPU]
        told = {"clock": one.fields["at"], "mode": one.mode}
        given = self._given | {"records": [name for name in records if not (self._partial and name == "call")]}
        self._logs += 1
        file = None
        if self._file is not None:
            file = self._file if self._logs == 1 else self._file.with_stem(f"{self._file.stem}-{self._logs}")
        self._base = None
        self.log = GrowingLog(str(file or f"log {self._logs}"), file, {"format": LOG_FORMAT, **told, **given})
        return True

    def _add(self, event: dict[str, Any]) -> None:
        assert self.log is not None
        self.lines.append(event)
        if self.log.add(event) is not None:
            self._end("")

    def _until(self) -> str | None:
        until = self.tail.told_until
        return None if until is None or self.trouble else until.isoformat(timespec="milliseconds")

    def _end(self, reason: str, until: str | None = None) -> None:
        if self.log is None:
            return
        log, self.log = self.log, None
        report = log.close(until)
        self.reports.append(report)
        self.notes.append(
            f"{log.name}: {report.verdict}, {log.events} events" + (f"; it ends: {reason}" if reason else "")
        )

    def _take_silence(self) -> None:
        until = self._until()
        if self.log is not None and until is not None and self.log.silent(until) is not None:
            self._end("")

    def _take_state(self) -> None:
        """The state read after the last poll: nothing has happened since, so it holds between two readings."""
        if self.log is None or self._state is None or self.tail.told_until is None:
            return
        before, after, fields = self._state
        early = {**fields, "at": before}
        late = {**fields, "at": after}
        self._add(early if self.log.allows(early) and not self.log.allows(late) else late)

    def _next_state(self) -> tuple[str, str, dict[str, Any]] | None:
        if self.log is None or not self._obs or self._now() - self._asked < _STATE_S:
            return None
        self._asked = self._now()
        self._obs.rotate(-1)
        try:
            found = self.tail.state(self._obs[0])
        except NoAnswerError:
            self._cpu.close()
            self._refused += 1
            if self._refused == _TRIES:
                self._obs.clear()
                self.notes.append("the CPU does not answer SZL 16#0222: no states of OBs")
            return None
        self._refused = 0
        return found
