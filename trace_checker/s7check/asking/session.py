"""A log that grows line by line, and questions about it."""

import json
from collections.abc import Collection, Iterable, Mapping
from copy import copy
from itertools import count
from typing import Any, Self

import msgspec

from s7check.asking.answers import Parting, Possible
from s7check.engine.answer import Refusal, Situation, Unusable
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.report.clauses import texts

MOST_SITUATIONS = 8
"""Explanations of a log of which the situations are shown."""

_names = count()


class _Reply(msgspec.Struct, frozen=True):
    error: str = ""
    unusable: Unusable | None = None
    clock: str = ""
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
    of the line before.

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
        self.clock = self._ask("open", header=json.dumps(self.header)).clock
        """The CPU clock after the last line, as a log spells it."""

    def feed(self, line: Mapping[str, Any]) -> Refusal | None:
        """Adds a line. If it is not possible the session stays as it was, and the answer says why."""
        whole = self._whole(line)
        reply = self._ask("feed", line=json.dumps(whole))
        if reply.refusal is None:
            self.lines.append(whole)
            self.clock = reply.clock
        return reply.refusal

    def why(self, line: Mapping[str, Any]) -> Refusal | None:
        """Why the line is not possible next; None if it is. The session stays as it is."""
        self._engine.tell(texts)
        return self._ask("judge", line=json.dumps(self._whole(line))).refusal

    def undo(self, lines: int = 1) -> None:
        """Takes back the last lines, at most all of them."""
        left = max(0, len(self.lines) - lines)
        self.clock = self._ask("back", lines=left).clock
        del self.lines[left:]

    def situations(self, most: int = MOST_SITUATIONS) -> list[Situation]:
        """The situations in which the CPU may be after the last line: one for each explanation, so many at most."""
        return self._ask("situations", most=most).situations

    def before(self, line: Mapping[str, Any]) -> list[Situation]:
        """The situations just before the line, after all that happens by itself until then; none if it may not come."""
        return self._ask("before", line=json.dumps(self._whole(line)), most=MOST_SITUATIONS).situations

    def possible(
        self,
        lines: Iterable[Mapping[str, Any]] | None = None,
        at: str | None = None,
        *,
        only: Collection[str] = (),
        most: int | None = None,
    ) -> Possible:
        """What may come next: all that the specification offers, or which of these lines with which answers.

        A line of ``lines`` may lack ``at``, which counts for nothing, and ``ret``. With ``at`` only this time of the
        CPU clock is looked at, and the only one of the answer. ``only`` names the events that are looked for, all if
        it is empty. ``most`` states are looked at for each line: one that none of them allows may be possible still.
        """
        more: dict[str, Any] = {"only": list(only)}
        if most is not None:
            more["most"] = most
        if at is not None:
            more["when"] = json.dumps({"event": "hold", "at": at})
        if lines is not None:
            more["lines"] = self._texts(lines)
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
        parting = self._ask("parting", **{"from": other._name}, lines=self._texts(lines), **bounds).parting
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
        self._ask("branch", to=twin._name)
        return twin

    def close(self) -> None:
        """Ends the session; nothing else may be called any more."""
        self._ask("close")

    def _texts(self, lines: Iterable[Mapping[str, Any]]) -> list[str]:
        return [json.dumps(self._whole(line)) for line in lines]

    def _ask(self, message: str, **more: Any) -> _Reply:
        reply = self._engine.ask({"message": message, "session": self._name, **more}, _Reply)
        if reply.unusable is not None:
            raise reply.unusable.error()
        if reply.error:
            raise EngineError(reply.error)
        return reply

    def _whole(self, line: Mapping[str, Any]) -> dict[str, Any]:
        whole = {"at": self.clock, **line}
        if str(line.get("event")).isupper():
            whole.setdefault("ret", None)
        return whole
