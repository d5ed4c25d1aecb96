"""Why mutants survive: ``models/survivors.json``.

An entry names a mutant, or several by a glob, and says why nothing notices them: because they are `equivalent`, that
is because no behaviour differs, or for a reason that leaves something to be done.
"""

from __future__ import annotations

import fnmatch
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import msgspec

from trace_checker.mutants.bench import Verdict

Text = Annotated[str, msgspec.Meta(min_length=1)]


class Reason(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One entry of the file."""

    id: Text
    reason: Text
    equivalent: bool = False

    def fits(self, mutant: str) -> bool:
        """Whether the entry speaks of this mutant."""
        return fnmatch.fnmatchcase(mutant, self.id)


class ReasonsError(ValueError):
    """The file is no list of reasons; the text names file and field."""


def read(path: Path) -> list[Reason]:
    """Read the file; one that is not there holds no reasons. Raises `ReasonsError`."""
    if not path.is_file():
        return []
    try:
        return msgspec.json.decode(path.read_bytes(), type=list[Reason])
    except msgspec.MsgspecError as error:
        raise ReasonsError(f"{path}: {error}") from error


@dataclass(frozen=True)
class Explained:
    """Verdicts and reasons side by side; `stale` are the reasons that fit nothing any more, and why."""

    verdicts: list[Verdict]
    reasons: dict[str, Reason]
    stale: list[str]

    @property
    def unexplained(self) -> list[Verdict]:
        """The survivors without a reason."""
        return [v for v in self.verdicts if v.how == "survived" and v.mutant.id not in self.reasons]

    def equivalent(self, verdict: Verdict) -> bool:
        """Whether a mutant survived because it changes nothing."""
        reason = self.reasons.get(verdict.mutant.id)
        return verdict.how == "survived" and reason is not None and reason.equivalent


def explain(verdicts: list[Verdict], reasons: Iterable[Reason], existing: Iterable[str]) -> Explained:
    """Find the reason of each survivor. `existing` are the ids of all mutants, judged or not."""
    ids = list(existing)
    survivors = [v.mutant.id for v in verdicts if v.how == "survived"]
    judged = {v.mutant.id for v in verdicts}
    found: dict[str, Reason] = {}
    stale = []
    for reason in reasons:
        fitting = [i for i in ids if reason.fits(i)]
        surviving = [i for i in survivors if reason.fits(i)]
        found |= {i: reason for i in surviving if i not in found}
        if not fitting:
            stale.append(f"{reason.id}: there is no such mutant")
        elif not surviving and judged.issuperset(fitting):
            stale.append(f"{reason.id}: does not survive")
    return Explained(verdicts, found, stale)
