"""The finding of a check about a mutant, and the findings that are kept from run to run."""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Literal

import msgspec

How = Literal["survived", "invalid", "property", "assumption", "deadlock", "error", "log", "count", "timeout"]
"""``survived`` the check noticed nothing; ``invalid`` the mutant is no specification; all others killed it.

``error`` an expression could not be evaluated; ``count`` the model passed with other state counts; ``log`` a shipped
log got another verdict, or at another line.
"""

KILLS: tuple[How, ...] = ("property", "assumption", "deadlock", "error", "log", "count", "timeout")
WEAK = frozenset({"count", "timeout"})
"""Kills that say that something changed, not that it is wrong."""

STATED = frozenset({"property", "assumption", "deadlock"})
"""Kills by something that a model states of the rules."""


class Finding(msgspec.Struct, frozen=True):
    """The result of a check; `detail` names the property, the log or the error."""

    how: How
    detail: str = ""
    seconds: float = 0.0

    @property
    def killed(self) -> bool:
        """Whether the mutant was noticed."""
        return self.how in KILLS


class Kept(msgspec.Struct, frozen=True):
    """A finding with its check and its mutant; `key` is a hash of everything that decides it."""

    key: str
    check: str
    mutant: str
    finding: Finding


class Findings:
    """Findings in a file, a line each, so that a run that was interrupted loses none. Safe to use from threads."""

    def __init__(self, path: Path, *, fresh: bool = False) -> None:
        """Read the file, unless `fresh`; a line that an interrupted run cut off is passed over."""
        self._path = path
        self._lock = threading.Lock()
        self._by_key: dict[str, Kept] = {}
        lines = path.read_bytes().splitlines() if path.is_file() and not fresh else []
        for line in lines:
            try:
                kept = msgspec.json.decode(line, type=Kept)
            except msgspec.MsgspecError:
                continue
            self._by_key[kept.key] = kept

    def all(self) -> list[Kept]:
        """Every finding, also about specifications that have changed since."""
        return list(self._by_key.values())

    def known(self, key: str) -> Finding | None:
        """Return the finding of this key, if there is one."""
        kept = self._by_key.get(key)
        return kept.finding if kept else None

    def keep(self, key: str, check: str, mutant: str, finding: Finding) -> None:
        """Keep a finding; it is in the file when this returns."""
        kept = Kept(key, check, mutant, finding)
        with self._lock:
            self._by_key[key] = kept
            self._path.parent.mkdir(parents=True, exist_ok=True)
            with self._path.open("ab") as file:
                file.write(msgspec.json.encode(kept) + b"\n")
