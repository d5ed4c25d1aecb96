"""What the engine makes of a source."""

from collections.abc import Mapping, Sequence
from typing import Any, TypeVar

import msgspec

from s7check.engine import pool
from s7check.engine.client import Checked, Engine
from s7check.importing.errors import SourceError, in_field
from s7check.log.profile_file import HERE, profile_file

_Shape = TypeVar("_Shape")


class Imported(msgspec.Struct, frozen=True):
    """Header and events of a log, and what is to be said of it, in lines."""

    log: list[dict[str, Any]]
    told: list[str]


class Entry(msgspec.Struct, frozen=True):
    """An entry of the diagnostic buffer, of a record of 20 bytes.

    ``event`` is its line, ``change`` has old and new mode, None where not told, or is None if the entry changes no
    mode. ``told`` is the line of the mode, as far as the entry and those asked about with it tell it; ``power``: the
    power came back.
    """

    event: dict[str, Any]
    power: bool
    change: tuple[str | None, str | None] | None = None
    told: dict[str, Any] | None = None
    record: bytes = b""

    @property
    def at(self) -> str:
        """Its time, as a log spells it."""
        return str(self.event["at"])


class Ring(msgspec.Struct, frozen=True):
    """A ring: the number of slots, the bytes of one, how many entries were written so far, the bytes of all."""

    capacity: int
    size: int
    written: int
    length: int


class Slot(msgspec.Struct, frozen=True):
    """An entry of the ring before its events are asked for.

    A ``startup`` OB made it or not; ``begins``: a log can begin there. It ``sets`` the clock
    to the time ``to``, or begins a ``restart``, a line without its time. ``done``: RET_VAL is there.
    """

    number: int
    code: int
    done: bool
    sets: bool
    startup: bool
    begins: bool
    clock: str | None
    to: str | None
    restart: dict[str, Any] | None = None
    content: bytes = b""

    @property
    def at(self) -> str:
        """The CPU clock. Raises SourceError for one that there is not."""
        return self._told(self.clock)

    @property
    def set_to(self) -> str:
        """The time to which it sets the clock. Raises SourceError for one that there is not."""
        return self._told(self.to)

    def _told(self, time: str | None) -> str:
        if time is None:
            events_of([self], {})
        return str(time)


class RingEvents(msgspec.Struct, frozen=True):
    """Events of slots, the ``elapsed`` time behind them, and whether the clock ``jumped`` before the last slot."""

    events: list[dict[str, Any]]
    elapsed: dict[str, Any]
    jumped: bool


class _Slots(msgspec.Struct):
    slots: list[Slot]


class _Kind(msgspec.Struct):
    kind: str | None


class _Entries(msgspec.Struct):
    entries: list[Entry]


class _Mode(msgspec.Struct):
    mode: str | None


def kind_of(begin: bytes, engine: Engine | None = None) -> str | None:
    """``step7``, ``szl`` or ``ring``, as ``--from`` has it, if ``begin`` is the beginning of such a source; ``program``
    of a program of the kit.
    """
    if engine is not None:
        return _answer(engine, {"message": "kind"}, _Kind, begin).kind
    return _ask({"message": "kind"}, _Kind, begin).kind


def log_of(content: bytes, kind: str, given: dict[str, Any], **how: Any) -> Imported:
    """The log of a source; ``given`` are fields of the header, which count more than what it tells."""
    file = profile_file(msgspec.json.encode(given), HERE)
    message = {"message": "import", "kind": kind, "given": given, **how, **({"file": file} if file else {})}
    return _ask(message, Imported, content)


def entries_of(records: Sequence[bytes]) -> list[Entry]:
    """The entries of records of the diagnostic buffer, oldest first. Raises SourceError for one that is none."""
    entries = _ask({"message": "entries"}, _Entries, b"".join(records)).entries
    return [msgspec.structs.replace(one, record=record) for one, record in zip(entries, records, strict=True)]


def mode_of(nibble: int) -> str | None:
    """The mode that a half-byte of the CPU stands for; None for others than STOP, STARTUP, RUN, HOLD."""
    return _ask({"message": "mode", "number": nibble}, _Mode).mode


def ring_of(header: bytes) -> Ring:
    """The header of a ring, with what follows or without. Raises SourceError for another one."""
    return _ask({"message": "ring"}, Ring, header)


def slots_of(content: bytes) -> list[Slot]:
    """What whole slots of a ring hold, one behind the other."""
    slots = _ask({"message": "slots"}, _Slots, content).slots
    length = len(content) // max(len(slots), 1)
    return [msgspec.structs.replace(one, content=content[i * length :][:length]) for i, one in enumerate(slots)]


def events_of(slots: Sequence[Slot], elapsed: Mapping[str, Any]) -> RingEvents:
    """The events of slots; ``elapsed`` is as the answer before had it, or empty. Raises SourceError."""
    content = b"".join(one.content for one in slots)
    return _ask({"message": "ring events", "elapsed": elapsed}, RingEvents, content)


def state_of(ob: int, al1: int) -> dict[str, Any]:
    """What the word al1 of SZL 16#0222 shows of an OB."""
    return _ask({"message": "state", "ob": ob, "al1": al1}, dict[str, Any])


def _ask(message: dict[str, Any], shape: type[_Shape], content: bytes = b"") -> _Shape:
    with pool.engine() as engine:
        return _answer(engine, message, shape, content)


def _answer(engine: Engine, message: dict[str, Any], shape: type[_Shape], content: bytes) -> _Shape:
    answer = engine.ask({**message, "count": len(content)}, Checked, content)
    if (wrong := answer.unusable) is not None:
        raise SourceError(in_field(wrong.place, wrong.field), wrong.expected, wrong.found)
    return msgspec.convert(answer.object, shape)
