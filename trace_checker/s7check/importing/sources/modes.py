"""The operating mode, as far as entries of class 4 tell of it.

Byte 3 of such an entry holds the old and the new mode. Where only the event ID is known, some IDs
name one of them or both. What stays ambiguous gives no event and makes the recording of modes
incomplete; so does an entry whose old mode is not the new mode of the one before.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

from s7check.importing.sources.entry import Entry
from s7check.importing.sources.start_info import word

_MODE_CLASS = 4
POWER_ON = 0x4300

OF_NIBBLE = {
    **dict.fromkeys([1, 2, 3, 4], "STOP"),
    **dict.fromkeys([5, 6, 7], "STARTUP"),
    8: "RUN",
    0xA: "HOLD",
}

_OF_ID: dict[int, tuple[str | None, str | None]] = {
    0x4301: ("STOP", "STARTUP"),
    0x4302: ("STARTUP", "RUN"),
    0x4305: (None, "HOLD"),
    0x4306: ("HOLD", None),
    0x430A: ("HOLD", "STOP"),
    **dict.fromkeys(
        [0x4303, 0x4304, 0x4541, 0x454A, 0x4562, 0x4563, 0x4568, 0x456D, 0x4570, 0x457F],
        (None, "STOP"),
    ),
}
"""Event ID -> old and new mode, as far as the ID alone tells them."""

_ANY_RESTART = frozenset({"warm", "hot", "cold"})
_STARTUPS = {5: frozenset({"warm", "cold"}), 6: frozenset({"warm"}), 7: frozenset({"hot"})}
"""New mode of an entry 4301 -> the kinds of restart it may be; editions disagree about 5."""

_REQUESTS = {0x1381: "warm", 0x1382: "warm", 0x1383: "hot", 0x1384: "hot", 0x1385: "cold", 0x1386: "cold"}
"""Request for a restart -> its kind; it follows the entry 4301."""

_EVENTS: dict[tuple[str | None, str | None], str] = {
    ("STARTUP", "RUN"): "run",
    ("RUN", "HOLD"): "hold",
    ("HOLD", "RUN"): "release",
    **{(old, "STOP"): "stop" for old in ("STARTUP", "RUN", "HOLD", None)},
}


class Modes(NamedTuple):
    """What entries tell of the mode.

    ``first`` is the mode before them, None if they do not tell it; ``events`` the entries' mode
    events by the index of the entry; ``complete`` whether no change can be missing.
    """

    first: str | None
    events: dict[int, dict[str, Any]]
    complete: bool


def follow(entries: Sequence[Entry]) -> Modes:
    """What ``entries``, oldest first, tell of the mode."""
    first: str | None = None
    mode: str | None = None
    events: dict[int, dict[str, Any]] = {}
    complete = True
    changes = 0
    for index, entry in enumerate(entries):
        change = change_of(entry)
        if change is None:
            # A power failure ends RUN without an entry of its own.
            complete = complete and entry.id != POWER_ON
            continue
        old, new = change
        if not changes:
            first = old
        elif mode is not None and old is not None and mode != old:
            complete = False
        changes += 1
        event = _event(old or mode, new, index, entries)
        if event:
            events[index] = event
        elif (old or mode) != new or new is None:
            complete = False
        mode = new
    return Modes(first, events, complete and first is not None)


def change_of(entry: Entry) -> tuple[str | None, str | None] | None:
    """Old and new mode, None where not told; None if the entry changes no mode."""
    by_id = _OF_ID.get(entry.id)
    if entry.coding is None or entry.event_class != _MODE_CLASS:
        return by_id
    old, new = (OF_NIBBLE.get(nibble) for nibble in divmod(entry.coding[3], 16))
    if by_id is None:
        # Of other entries of the class only those of a STOP are sure to change the mode.
        return (old, new) if old not in (None, "STOP") and new == "STOP" else None
    contradicts = any(told not in (None, shown) for told, shown in zip(by_id, (old, new), strict=True))
    return (None, None) if contradicts else (old, new)


def _event(old: str | None, new: str | None, index: int, entries: Sequence[Entry]) -> dict[str, Any] | None:
    if (old, new) == ("STOP", "STARTUP"):
        kind = _restart(index, entries)
        return {"event": "restart", "type": kind} if kind else None
    name = _EVENTS.get((old, new))
    if name == "stop":
        return {"event": name, "cause": word(entries[index].id)}
    return {"event": name} if name else None


def _restart(index: int, entries: Sequence[Entry]) -> str | None:
    """The kind of restart that entry 4301 begins, None if not told."""
    coding = entries[index].coding
    kinds = _STARTUPS[coding[3] % 16] if coding else _ANY_RESTART
    for entry in entries[index + 1 :]:
        if entry.event_class == _MODE_CLASS:
            break
        if entry.id in _REQUESTS:
            kinds = kinds & {_REQUESTS[entry.id]}
    return next(iter(kinds)) if len(kinds) == 1 else None
