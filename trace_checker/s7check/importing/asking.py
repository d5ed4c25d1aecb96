"""What the engine makes of a source."""

from collections.abc import Sequence
from typing import Any, TypeVar

import msgspec

from s7check.engine import pool
from s7check.engine.client import Checked, Engine
from s7check.importing.errors import SourceError, in_field
from s7check.importing.recording import Recording
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


class _Kind(msgspec.Struct):
    kind: str | None


class _Entries(msgspec.Struct):
    entries: list[Entry]


class _Mode(msgspec.Struct):
    mode: str | None


def kind_of(begin: bytes, engine: Engine | None = None) -> str | None:
    """``step7``, ``szl`` or ``ring``, as ``--from`` has it, if ``begin`` is the beginning of such a source."""
    if engine is not None:
        return _answer(engine, {"message": "kind"}, _Kind, begin).kind
    return _ask({"message": "kind"}, _Kind, begin).kind


def log_of(content: bytes, kind: str, given: dict[str, Any], chosen: range | None = None, **how: Any) -> Imported:
    """The log of a source; ``given`` are fields of the header, which count more than what it tells."""
    entries = f"{chosen.start}-{chosen.stop - 1}" if chosen is not None else None
    return _import({"kind": kind, "given": given, "entries": entries, **how}, content)


def log_of_recording(recording: Recording, given: dict[str, Any]) -> Imported:
    """The log of what was read here."""
    return _import({"given": given, "recording": recording.as_told()}, b"")


def _import(message: dict[str, Any], content: bytes) -> Imported:
    file = profile_file(msgspec.json.encode(message["given"]), HERE)
    return _ask({"message": "import", **message, **({"file": file} if file else {})}, Imported, content)


def entries_of(records: Sequence[bytes]) -> list[Entry]:
    """The entries of records of the diagnostic buffer, oldest first. Raises SourceError for one that is none."""
    entries = _ask({"message": "entries"}, _Entries, b"".join(records)).entries
    return [msgspec.structs.replace(one, record=record) for one, record in zip(entries, records, strict=True)]


def mode_of(nibble: int) -> str | None:
    """The mode that a half-byte of the CPU stands for; None for others than STOP, STARTUP, RUN, HOLD."""
    return _ask({"message": "mode", "number": nibble}, _Mode).mode


def start_info(ob: int, number: int, info_1: int, info_2: int) -> dict[str, Any]:
    """The fields of ``ob``'s start information: of byte 1, the word of bytes 6-7, the double word of bytes 8-11."""
    message = {"message": "start info", "ob": ob, "number": number, "info1": info_1, "info2": info_2}
    return _ask(message, dict[str, Any])


def _ask(message: dict[str, Any], shape: type[_Shape], content: bytes = b"") -> _Shape:
    with pool.engine() as engine:
        return _answer(engine, message, shape, content)


def _answer(engine: Engine, message: dict[str, Any], shape: type[_Shape], content: bytes) -> _Shape:
    answer = engine.ask({**message, "count": len(content)}, Checked, content)
    if (wrong := answer.unusable) is not None:
        raise SourceError(in_field(wrong.place, wrong.field), wrong.expected, wrong.found)
    return msgspec.convert(answer.object, shape)
