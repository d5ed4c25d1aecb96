"""An entry of the diagnostic buffer."""

from dataclasses import dataclass
from typing import NamedTuple

from s7check.importing.errors import SourceError
from s7check.importing.sources.bcd import instant, spaced

LENGTH = 20
"""Bytes of an entry: event ID, class, OB, two reserved, additional information, DATE_AND_TIME."""

CODED = 12
"""Those of them that STEP 7 prints as the coding: all but the time."""


@dataclass(frozen=True)
class Entry:
    """One entry.

    ``number`` is that of the source, 1 the newest; ``at`` the time as a log spells it; ``coding``
    the first twelve bytes, or None where the source gives the event ID only.
    """

    number: int
    place: str
    id: int
    at: str
    coding: bytes | None

    @property
    def event_class(self) -> int:
        """The class of the event ID: 1 to 3 start OBs, 4 changes the mode."""
        return self.id >> 12


class Buffer(NamedTuple):
    """The entries of a diagnostic buffer, newest first, and how many of its slots were never written."""

    entries: list[Entry]
    empty: int = 0


def from_record(number: int, record: bytes) -> Entry:
    """The entry of a record of SZL 16#xxA0; raises SourceError if its time is none."""
    place = f"entry {number}"
    try:
        at = instant(record[CODED:])
    except ValueError as error:
        expected = "a DATE_AND_TIME in BCD in the last eight bytes"
        raise SourceError(place, expected, spaced(record[CODED:])) from error
    return Entry(number, place, int.from_bytes(record[:2]), at, record[:CODED])
