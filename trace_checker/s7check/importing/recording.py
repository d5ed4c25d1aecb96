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
    are sentences about the limits of the log.
    """

    events: list[Placed] = field(default_factory=list)
    header: dict[str, Any] = field(default_factory=dict)
    read: int = 0
    skipped: dict[str, int] = field(default_factory=dict)
    remarks: list[str] = field(default_factory=list)

    def skip(self, reason: str, count: int = 1) -> None:
        """Counts entries that give no event."""
        if count:
            self.skipped[reason] = self.skipped.get(reason, 0) + count

    def as_told(self) -> dict[str, Any]:
        """It as the engine takes it."""
        events = [(placed.place, placed.event) for placed in self.events]
        told = {"header": self.header, "read": self.read, "skipped": self.skipped, "remarks": self.remarks}
        return told | {"events": events}


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
