"""Which check is likely to kill a mutant at least cost: the kills of other mutants decide."""

from __future__ import annotations

import threading
from collections import Counter

DOUBT = 2.0
"""How many observations of its own a definition needs to count as much as its module."""


class Experience:
    """How often each check killed, by definition, by module and in all. Safe to use from threads."""

    def __init__(self) -> None:
        """Know nothing yet."""
        self._runs: Counter[tuple[str, str]] = Counter()
        self._kills: Counter[tuple[str, str]] = Counter()
        self._lock = threading.Lock()

    def learn(self, check: str, mutant: str, *, killed: bool) -> None:
        """Note that the check was run on a mutant of this id."""
        with self._lock:
            for scope in _scopes(mutant):
                self._runs[check, scope] += 1
                self._kills[check, scope] += killed

    def likelihood(self, check: str, mutant: str) -> float:
        """How likely the check kills: the experience with the definition, leaning on wider experience."""
        guess = 0.5
        for scope in _scopes(mutant):
            guess = (self._kills[check, scope] + DOUBT * guess) / (self._runs[check, scope] + DOUBT)
        return guess


def _scopes(mutant: str) -> tuple[str, str, str]:
    module, definition = mutant.split("/")[:2]
    return "", module, f"{module}/{definition}"
