"""Why mutants survive: ``models/survivors.json``.

An entry names a mutant, or several by a glob, and says why nothing notices them: because they are `equivalent`, that
is because no behaviour differs, or for a reason that leaves something to be done.
"""

from __future__ import annotations

import fnmatch
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, TypeVar

import msgspec

from evidence.mutants.bench import Verdict

Text = Annotated[str, msgspec.Meta(min_length=1)]


class Excuse(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """An id, or a glob of ids, and why what it names is as it is."""

    id: Text
    reason: Text

    def fits(self, name: str) -> bool:
        """Whether the entry speaks of this id."""
        return fnmatch.fnmatchcase(name, self.id)


class Reason(Excuse, frozen=True, forbid_unknown_fields=True):
    """One entry of the file."""

    equivalent: bool = False


class ReasonsError(ValueError):
    """The file is no list of reasons; the text names file and field."""


Kind = TypeVar("Kind", bound=Excuse)


def read(path: Path, kind: type[Kind]) -> list[Kind]:
    """Read a file of such entries; one that is not there holds none. Raises `ReasonsError`."""
    if not path.is_file():
        return []
    try:
        return msgspec.json.decode(path.read_bytes(), type=list[kind])  # type: ignore[valid-type]
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
    survivors = [v.mutant.id for v in verdicts if v.how == "survived"]
    found, gone, needless = assign(reasons, existing, survivors, [v.mutant.id for v in verdicts])
    stale = [f"{reason.id}: there is no such mutant" for reason in gone]
    stale += [f"{reason.id}: does not survive" for reason in needless]
    return Explained(verdicts, found, stale)


def assign(
    entries: Iterable[Kind], existing: Iterable[str], lacking: Iterable[str], judged: Iterable[str]
) -> tuple[dict[str, Kind], list[Kind], list[Kind]]:
    """Find the entry of each id in `lacking`, the entries that fit none of `existing`, and those that none needs.

    An entry that fits an id which is not in `judged` may be needed.
    """
    ids, needing, done = list(existing), list(lacking), set(judged)
    found: dict[str, Kind] = {}
    gone, needless = [], []
    for entry in entries:
        fitting = [i for i in ids if entry.fits(i)]
        needed = [i for i in needing if entry.fits(i)]
        found |= {i: entry for i in needed if i not in found}
        if not fitting:
            gone.append(entry)
        elif not needed and done.issuperset(fitting):
            needless.append(entry)
    return found, gone, needless
