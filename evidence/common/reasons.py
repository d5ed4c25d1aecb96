"""Files of reasons: each entry names an id, or a glob of ids, and gives the reason."""

from __future__ import annotations

import fnmatch
from collections.abc import Iterable
from pathlib import Path
from typing import Annotated, TypeVar

import msgspec

Text = Annotated[str, msgspec.Meta(min_length=1)]


class Excuse(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """An id, or a glob of ids, with the reason for it."""

    id: Text
    reason: Text

    def fits(self, name: str) -> bool:
        """Whether the entry speaks of this id."""
        return fnmatch.fnmatchcase(name, self.id)


class ReasonsError(ValueError):
    """The file is no list of reasons; the text names file and field."""


Kind = TypeVar("Kind", bound=Excuse)


def read(path: Path, kind: type[Kind]) -> list[Kind]:
    """Read a file of such entries; a missing file holds none. Raises `ReasonsError`."""
    if not path.is_file():
        return []
    try:
        return msgspec.json.decode(path.read_bytes(), type=list[kind])  # type: ignore[valid-type]
    except msgspec.MsgspecError as error:
        raise ReasonsError(f"{path}: {error}") from error


def assign(
    entries: Iterable[Kind], existing: Iterable[str], lacking: Iterable[str], judged: Iterable[str]
) -> tuple[dict[str, Kind], list[Kind], list[Kind]]:
    """Find the entry of each id in `lacking`, the entries that fit none of `existing`, and the needless ones.

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
