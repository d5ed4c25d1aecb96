"""Entries of the diagnostic buffer to events of a log."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

from s7check.importing.errors import SourceError
from s7check.importing.recording import Placed, Recording, select
from s7check.importing.sources.bcd import spaced
from s7check.importing.sources.entry import Buffer, Entry
from s7check.importing.sources.modes import follow
from s7check.importing.sources.start_info import start_info, word

_START_EVENTS = frozenset({1, 3})
"""Event classes whose entries are the start information of an OB whose layout is known."""

_MODE_CLASS = 4
_OB_NUMBERS = range(1, 123)

_CLASSES = range(30)
"""Priority classes; 16#FF stands for none."""

_NOT_STARTED = 0xFE
"""In the place of the priority class: the OB could not be started."""


def convert(buffer: Buffer, chosen: range | None = None) -> Recording:
    """The events of a diagnostic buffer.

    Raises SourceError if the clock was set back between two of the ``chosen`` ones, since nothing
    tells when and from which reading.
    """
    recording = Recording()
    kept = sorted(select(buffer.entries, chosen, recording), key=lambda entry: entry.number, reverse=True)
    recording.read += buffer.empty
    recording.skip("never written", buffer.empty)
    _check_order(kept)
    modes = follow(kept)
    for index, entry in enumerate(kept):
        # What the entry reports comes first: the change of the mode, then the entry about it.
        if index in modes.events:
            change = modes.events[index]
            recording.events.append(Placed({"event": change["event"], "at": entry.at, **change}, entry.place))
        recording.events.append(Placed(diag_event(entry), entry.place))
        _note_ob(entry, recording)
    recording.header["clock"] = kept[0].at
    if modes.first in ("STOP", "STARTUP", "RUN"):
        recording.header["mode"] = modes.first
    recording.header["records"] = []
    if _without_gap(kept):
        recording.header["records"] = ["mode", "diag"] if modes.complete else ["diag"]
    else:
        recording.remarks.append("numbers are missing between the entries, so the log does not record diag completely")
    return recording


def _check_order(entries: Sequence[Entry]) -> None:
    for earlier, later in pairwise(entries):
        if later.at < earlier.at:
            raise SourceError(
                later.place,
                f"no time before {earlier.at}, that of entry {earlier.number}",
                f"{later.at}: the clock was set back between them; import the entries before and after "
                f"apart, with --entries {earlier.number}- and --entries 1-{later.number}",
            )


def _without_gap(entries: Sequence[Entry]) -> bool:
    return entries[0].number - entries[-1].number == len(entries) - 1


def _ob(entry: Entry) -> tuple[int, int] | None:
    """The OB that an entry is about, and its priority class as the entry has it."""
    if entry.coding is None or entry.event_class == _MODE_CLASS or entry.coding[3] not in _OB_NUMBERS:
        return None
    return entry.coding[3], entry.coding[2]


def _note_ob(entry: Entry, recording: Recording) -> None:
    found = _ob(entry)
    if found is None:
        return
    ob, priority = found
    if priority == _NOT_STARTED:
        recording.missing.setdefault(ob, entry.place)
    elif priority in _CLASSES:
        recording.started.setdefault(ob, entry.place)


def diag_event(entry: Entry) -> dict[str, Any]:
    """The event of an entry, without what it tells of the mode."""
    event: dict[str, Any] = {"event": "diag", "at": entry.at, "id": word(entry.id)}
    if entry.coding is None:
        return event
    if found := _ob(entry):
        ob, priority = found
        event["ob"] = ob
        if priority in _CLASSES:
            event["priority"] = priority
        if entry.event_class in _START_EVENTS:
            info_1, info_2 = int.from_bytes(entry.coding[6:8]), int.from_bytes(entry.coding[8:12])
            info = start_info(ob, entry.id & 0xFF, info_1, info_2)
            if info:
                event["info"] = info
    event["x_coding"] = spaced(entry.coding)
    return event
