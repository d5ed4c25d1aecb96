"""What the explorer offers after every log of a graph, beside the edges of the graph."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import msgspec

from evidence.logs.graph import Graph
from evidence.tla.behaviour import Line
from s7check.asking.session import Session
from s7check.engine.answer import Content
from s7check.engine.client import Engine

AT_ONCE = {"latency_ms": 0, "readings": {"AMB-69": "b"}}
"""In the models everything happens at once."""

_EVERY = 10_000
_NO_STOP = -1

_NOTHING: Line = {"event": "state", "ob": 1}
"""A line that only says that it is later now."""


@dataclass
class Compared:
    """The logs that were asked about, the edges that they have shown, and what is wrong, each with its log.

    `missing` has edges that are not offered, `more` offered lines without an edge. Not among these are those `early`:
    where something has to come in this millisecond, a start or a STOP, a log may have other lines before it. The model
    has no such behaviours; so lines behind an early one may also be without an edge.
    """

    logs: int = 0
    questions: int = 0
    edges: set[tuple[int, bytes, int]] = field(default_factory=set)
    missing: list[str] = field(default_factory=list)
    more: list[str] = field(default_factory=list)
    early: int = 0


class Comparison:
    """Follows all logs of the graph that lead to different sets of states."""

    def __init__(self, engine: Engine, graph: Graph) -> None:
        self._engine = engine
        self._graph = graph
        self._lines = sorted({line for edges in graph.shown for line, _ in edges})
        self._texts = dict(zip(self._lines, self._normal(), strict=True))
        self._clocks = sorted(set(graph.at))
        self.found = Compared()

    def run(self) -> Compared:
        """Compare everywhere."""
        for state, header in self._graph.headers.items():
            session = Session(
                self._engine, header | AT_ONCE | {"readings": header.get("readings", {}) | AT_ONCE["readings"]}
            )
            seen: set[tuple[frozenset[int], bool]] = set()
            self._follow(session, frozenset({state}), False, seen)
            session.close()
        return self.found

    def _normal(self) -> Iterator[str]:
        """The lines in one spelling."""
        header = next(iter(self._graph.headers.values())) | {"records": []}
        at = f'{{"at":"{header["clock"]}",'.encode()
        log = [msgspec.json.encode(header), *(at + line.removeprefix(b"{") for line in self._lines)]
        text = b"\n".join(log)
        for event in self._engine.ask({"message": "read", "count": len(text), "spelled": True}, Content, text).events:
            yield _spelled(event)

    def _follow(
        self, session: Session, after: frozenset[int], early: bool, seen: set[tuple[frozenset[int], bool]]
    ) -> None:
        """Compare after a log, and go on. `early`: one of its lines came before something that was due."""
        seen.add((after, early))
        self.found.logs += 1
        closed = self._closed(after)
        # What comes behind the border is not known; time goes on unseen, and never back.
        unknown = min((self._graph.at[state] for state in closed & self._graph.border), default="9")
        for at in (one for one in self._clocks if session.clock <= one < unknown):
            there: dict[bytes, set[int]] = {}
            for state in (one for one in closed if self._graph.at[one] == at):
                for line, end in self._graph.shown[state]:
                    there.setdefault(line, set()).add(end)
                    self.found.edges.add((state, line, end))
            due = self._due(session, at)
            self._compare(session, at, set(there), early or bool(due))
            for line, ends in sorted(there.items()):
                event = {"at": at, **msgspec.json.decode(line)}
                follower = frozenset(ends), early or bool(due - {(event["event"], event.get("ob", 0))})
                if follower not in seen and session.feed(event) is None:
                    self._follow(session, *follower, seen)
                    session.undo()

    @staticmethod
    def _due(session: Session, at: str) -> set[tuple[str, int]]:
        """The starts and STOPs that may have to come now, in some explanation of the log; of the starts the first."""
        if session.feed({"at": at, **_NOTHING}) is not None:
            return set()
        found = set()
        for state in session.situations(_EVERY):
            ready = [one for one in state.pending if one.ready]
            highest = max((one.class_ for one in ready), default=0)
            found |= {("start", one.ob) for one in ready if one.class_ == highest}
            if state.stop != _NO_STOP:
                found.add(("stop", 0))
        session.undo()
        return found

    def _closed(self, states: frozenset[int]) -> set[int]:
        closed, open_ = set(states), list(states)
        while open_:
            for state in self._graph.unseen[open_.pop()] - closed:
                closed.add(state)
                open_.append(state)
        return closed

    def _compare(self, session: Session, at: str, edges: set[bytes], early: bool) -> None:
        self.found.questions += 1
        possible = session.possible([msgspec.json.decode(line) for line in self._lines], at)
        offered = {_spelled(line.event) for line in possible.lines}
        for line in self._lines:
            if line in edges and self._texts[line] not in offered:
                self.found.missing.append(_log(session, at, line))
            elif line not in edges and self._texts[line] in offered:
                if early:
                    self.found.early += 1
                elif self._changes(session, at, line):
                    self.found.more.append(_log(session, at, line))

    @staticmethod
    def _changes(session: Session, at: str, line: bytes) -> bool:
        """Whether the line changes anything; a step that does not is no edge of a graph."""
        keys = set()
        for one in (_NOTHING, msgspec.json.decode(line)):
            session.feed({"at": at, **one})
            keys.add(session.possible([]).key)
            session.undo()
        return len(keys) > 1


def _spelled(line: dict[str, Any]) -> str:
    return msgspec.json.encode(line, order="sorted").decode()


def _log(session: Session, at: str, line: bytes) -> str:
    before = [msgspec.json.encode(each).decode() for each in (session.header, *session.lines)]
    return "\n".join([*before, f"{at} {line.decode()}"])
