"""The letters of each ambiguity under which logs can be explained."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from s7check.engine.client import Engine
from s7check.judging.replay import Replay
from s7check.log.chosen import Chosen


class ContradictionError(Exception):
    """No reading explains these logs, whose names are the argument."""


class Letters:
    """The letters that ``logs``, by name, leave. Raises ContradictionError and EngineError.

    ``chosen`` are letters other than the default without which a log cannot be explained.
    """

    def __init__(self, engine: Engine, logs: Mapping[str, Replay]) -> None:
        self._engine = engine
        self._logs = logs
        self._all = {name: tuple(letters) for name, letters in engine.alternatives().letters}
        self.chosen: dict[str, str] = {}
        self._choose()
        self.left = {name: self._possible(name, letters) for name, letters in sorted(self._all.items())}

    @property
    def decided(self) -> dict[str, str]:
        """The letters of the ambiguities of which only one is left."""
        return {name: left[0] for name, left in self.left.items() if len(left) == 1 < len(self._all[name])}

    @property
    def narrowed(self) -> dict[str, tuple[str, ...]]:
        """The letters that are left of the ambiguities that have lost some, and more than one."""
        return {name: left for name, left in self.left.items() if 1 < len(left) < len(self._all[name])}

    def _choose(self) -> None:
        """Takes letters, one at a time, until every log is explained."""
        names = list(self._logs)
        explained = self._explained({}, names)
        while len(explained) < len(names):
            best = max(
                (
                    (self._explained({**self.chosen, name: letter}, names), name, letter)
                    for name, letters in self._all.items()
                    if name not in self.chosen
                    for letter in letters
                ),
                key=lambda one: len(one[0]),
            )
            if len(best[0]) <= len(explained):
                raise ContradictionError(sorted(set(names) - set(explained)))
            explained, name, letter = best
            self.chosen[name] = letter

    def _possible(self, name: str, letters: Sequence[str]) -> tuple[str, ...]:
        logs = list(self._logs)
        return tuple(one for one in letters if len(self._explained({**self.chosen, name: one}, logs)) == len(logs))

    def _explained(self, readings: Mapping[str, str], names: Sequence[str]) -> list[str]:
        return [name for name in names if self._accepts(self._logs[name], readings)]

    def _accepts(self, log: Replay, readings: Mapping[str, str]) -> bool:
        # A line that cannot be read ends a log.
        return log.judge(self._engine, Chosen(letters=readings)).verdict in ("accepted", "unusable")
