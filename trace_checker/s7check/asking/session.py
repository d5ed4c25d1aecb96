"""A log that grows line by line, and questions about it."""

from collections.abc import Collection, Iterable, Mapping
from copy import copy
from itertools import count
from typing import Any, Self

import msgspec

from s7check.asking.answers import Parting, Possible, Refusal
from s7check.engine.answer import Answer, Situation
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.log.elapsed import Clocks
from s7check.log.events import read_event
from s7check.log.header import read_header
from s7check.log.values import iso

MOST_SITUATIONS = 8
"""Explanations of a log of which the situations are shown."""

_names = count()


class _Reply(msgspec.Struct, frozen=True):
    error: str = ""
    refusal: Refusal | None = None
    situations: list[Situation] = []
    possible: Possible | None = None
    parting: Parting | None = None


class Session:
    """A log that begins with a header and grows, in a running engine.

    ::

        with Engine() as engine:
            session = Session(engine, {"format": "s7-interrupt-log/1", "cpu": "S7-400", "obs": [1, 10, 80], ...})
            refusal = session.feed({"event": "DIS_AIRT", "at": "2026-03-02T08:00:00.000", "ret": 1})
            session.situations()          # the CPU after the last line, one for each explanation of the log
            session.possible()            # everything that may come next, when, and why
            session.possible([{"event": "EN_AIRT"}])   # the answers to this call; the same for any line
            session.why({"event": "EN_AIRT", "ret": 5})  # None, or why it is not possible
            session.undo()                # takes the last line back
            session.branch()              # another session that goes on from here
            other = session.under({"cpu": "S7-300"})   # the same lines in a CPU with another header

    Headers and lines are objects as in a log (docs/checking/log-format.md). ``at`` may be left out: it is then that
    of the line before. ``as_line`` in :mod:`s7check.asking.line_text` makes such lines of the answers.

    A warm engine answers each question in some milliseconds and keeps any number of sessions; not while it judges a
    log (``Engine.begin``). Header and lines raise UnusableLogError where they are not of the format. Every method may
    raise EngineError, also where too many states explain the log; the session is of no use afterwards.
    """

    def __init__(self, engine: Engine, header: Mapping[str, Any]) -> None:
        self.header: dict[str, Any] = dict(header)
        """The header, as it would stand in the log."""
        self.lines: list[dict[str, Any]] = []
        """The lines so far, each with its ``at``."""
        self._engine = engine
        self._name = str(next(_names))
        self._normalised = read_header(self.header)
        self._clocks = [Clocks(self._normalised["clock"], "clock" in self._normalised["records"])]
        self._ask("open", header=self._normalised)

    @property
    def clock(self) -> str:
        """The CPU clock after the last line, as a log spells it."""
        return iso(self._clocks[-1].reading)

    def feed(self, line: Mapping[str, Any]) -> Refusal | None:
        """Adds a line. If it is not possible the session stays as it was, and the answer says why."""
        clocks = copy(self._clocks[-1])
        whole = self._whole(line)
        refusal = self._ask("feed", event=self._event(whole, clocks)).refusal
        if refusal is None:
            self.lines.append(whole)
            self._clocks.append(clocks)
        return refusal

    def why(self, line: Mapping[str, Any]) -> Refusal | None:
        """Why the line is not possible next; None if it is. The session stays as it is."""
        return self._ask("judge", event=self._event(self._whole(line), copy(self._clocks[-1]))).refusal

    def undo(self, lines: int = 1) -> None:
        """Takes back the last lines, at most all of them."""
        left = max(0, len(self.lines) - lines)
        self._ask("back", lines=left)
        del self.lines[left:]
        del self._clocks[left + 1 :]

    def situations(self, most: int = MOST_SITUATIONS) -> list[Situation]:
        """The situations in which the CPU may be after the last line: one for each explanation, so many at most."""
        return self._ask("situations", most=most).situations

    def before(self, line: Mapping[str, Any]) -> list[Situation]:
        """The situations just before the line, after all that happens by itself until then; none if it may not come."""
        event = self._event(self._whole(line), copy(self._clocks[-1]))
        return self._ask("before", event=event, most=MOST_SITUATIONS).situations

    def possible(
        self,
        lines: Iterable[Mapping[str, Any]] | None = None,
        at: str | None = None,
        *,
        only: Collection[str] = (),
        few: Collection[str] = (),
        most: int | None = None,
    ) -> Possible:
        """What may come next: all that the specification offers, or which of these lines with which answers.

        A line of ``lines`` may lack ``at``, which counts for nothing, and ``ret``. With ``at`` only this time of the
        CPU clock is looked at, and the only one of the answer. ``only`` names the events that are looked for, all if
        it is empty; of the events ``few`` one line is enough. ``most`` states are looked at for each line: one that
        none of them allows may be possible still.
        """
        more: dict[str, Any] = {"only": list(only), "few": list(few)}
        if most is not None:
            more["most"] = most
        if at is not None:
            more["when"] = self._event({"event": "hold", "at": at}, copy(self._clocks[-1]))
        if lines is not None:
            more["lines"] = self._bare(lines)
        possible = self._ask("possible", **more).possible
        assert possible is not None
        return possible

    def parting(
        self,
        other: Self,
        lines: Iterable[Mapping[str, Any]] = (),
        *,
        only: Collection[str] = (),
        obs: Collection[int] = (),
        deepest: int,
        most: int,
    ) -> Parting:
        """The search for the shortest log of more lines that this session allows and ``other`` does not.

        Its lines are ``lines`` and those that the specification offers: of the events ``only``, all if it is empty;
        interrupts, loads and deletions of ``obs`` alone. Their times are those at which something may change. The
        search ends at the length ``deepest``, or beyond ``most`` pairs of explanations.
        """
        bounds = {"only": list(only), "obs": list(obs), "deepest": deepest, "most": most}
        parting = self._ask("parting", **{"from": other._name}, lines=self._bare(lines), **bounds).parting
        assert parting is not None
        return parting

    def under(self, changes: Mapping[str, Any]) -> tuple[Self, Refusal | None]:
        """A session with the same lines under a header with other fields, and why it ends before the last of them."""
        other = type(self)(self._engine, {name: self.header[name] for name in self.header} | dict(changes))
        for line in self.lines:
            if (refusal := other.feed(line)) is not None:
                return other, refusal
        return other, None

    def branch(self) -> Self:
        """A session with the same lines that goes on by itself."""
        twin = copy(self)
        twin._name = str(next(_names))
        twin.lines = list(self.lines)
        twin._clocks = list(self._clocks)
        self._ask("branch", to=twin._name)
        return twin

    def close(self) -> None:
        """Ends the session; nothing else may be called any more."""
        self._ask("close")

    def _bare(self, lines: Iterable[Mapping[str, Any]]) -> list[dict[str, Any]]:
        """The events of lines, without their times."""
        events = [self._event(self._whole(line), copy(self._clocks[-1])) for line in lines]
        return [{name: each[name] for name in each if name not in _TIMES} for each in events]

    def _ask(self, message: str, **more: Any) -> _Reply:
        reply = self._engine.ask({"message": message, "session": self._name, **more}, _Reply)
        if reply.error:
            raise EngineError(reply.error)
        return reply

    def _whole(self, line: Mapping[str, Any]) -> dict[str, Any]:
        whole = {"at": self.clock, **line}
        if str(line.get("event")).isupper():
            whole.setdefault("ret", None)
        return whole

    def _event(self, line: dict[str, Any], clocks: Clocks) -> dict[str, Any]:
        event = read_event(line)
        clocks.stamp(event)
        return event


_TIMES = frozenset({"at", "up", "counter", "step"})


def as_answer(refusal: Refusal, line: int) -> Answer:
    """The refusal as the engine's answer to a log that is rejected at ``line``."""
    fields = {name: getattr(refusal, name) for name in refusal.__struct_fields__}
    return Answer("rejected", line=line, **fields)
