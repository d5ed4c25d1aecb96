"""What a source gives."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple, Protocol, TypeVar

from s7check.importing.errors import SourceError


class Placed(NamedTuple):
    """An event of the log and the place in the source that tells of it."""

    event: dict[str, Any]
    place: str


@dataclass
class Recording:
    """The events of a source, oldest first.

    ``header`` has those of the header's fields that the source tells; ``read`` is the number of
    entries that were there, ``skipped`` says how many of them gave no event and why; ``remarks``
    are sentences about the limits of the log. ``started`` has the OBs that an entry shows
    as started, ``missing`` the OBs that an entry says could not be, each with the place of the first such entry.
    """

    events: list[Placed] = field(default_factory=list)
    header: dict[str, Any] = field(default_factory=dict)
    read: int = 0
    skipped: dict[str, int] = field(default_factory=dict)
    remarks: list[str] = field(default_factory=list)
    started: dict[int, str] = field(default_factory=dict)
    missing: dict[int, str] = field(default_factory=dict)

    def skip(self, reason: str, count: int = 1) -> None:
        """Counts entries that give no event."""
        if count:
            self.skipped[reason] = self.skipped.get(reason, 0) + count

    def contradictions(self, obs: Iterable[int]) -> list[str]:
        """Sentences about entries that do not fit the OBs said to be loaded; the log has the entries as they are."""
        loaded = set(obs)
        found = [
            f"{place}: OB {ob} could not be started (priority 16#FE), as if it were not loaded; --obs names it"
            for ob, place in self.missing.items()
            if ob in loaded
        ]
        found += [
            f"{place}: OB {ob} was started, so it is loaded; --obs does not name it"
            for ob, place in self.started.items()
            if ob not in loaded
        ]
        return found


class Numbered(Protocol):
    """An entry of a source, by the number that the source gives it."""

    @property
    def number(self) -> int:
        """The number."""


_Entry = TypeVar("_Entry", bound=Numbered)


def select(entries: Sequence[_Entry], chosen: range | None, recording: Recording) -> list[_Entry]:
    """The entries whose numbers are ``chosen``, all by default; the others count as skipped."""
    kept = list(_among(entries, chosen))
    recording.read = len(entries)
    recording.skip("outside --entries", len(entries) - len(kept))
    if not kept:
        numbers = f"entries {entries[0].number} to {entries[-1].number}" if entries else "no entry"
        raise SourceError("", "an entry to import", numbers)
    return kept


def _among(entries: Iterable[_Entry], chosen: range | None) -> Iterable[_Entry]:
    return (entry for entry in entries if chosen is None or entry.number in chosen)
