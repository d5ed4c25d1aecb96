"""The ring that the SCL instrumentation writes, byte by byte (instrumentation/scl/README.md)."""

import struct
from typing import NamedTuple

from s7check.importing.errors import SourceError

_HEADER = struct.Struct(">HhhhhHiI")
_ENTRY = struct.Struct(">iI8shBBhHIhH8sBBBB")

HEADER_LENGTH = _HEADER.size
_MAGIC = 0x5337
_LAYOUT = 1


class RingHeader(NamedTuple):
    """The first bytes of the data block.

    ``capacity`` is the number of slots, ``size`` that of bytes of a slot, ``slot`` the one that is
    written next, ``written`` the number of entries written so far, ``overwritten`` how many of them
    were lost to later ones.
    """

    magic: int
    layout: int
    capacity: int
    size: int
    slot: int
    reserved: int
    written: int
    overwritten: int

    @property
    def length(self) -> int:
        """Bytes of the header and all slots."""
        return HEADER_LENGTH + self.capacity * self.size


class RingEntry(NamedTuple):
    """A slot; the fields are those of UDT 100."""

    number: int
    tick: int
    clk: bytes
    code: int
    caller: int
    mode: int
    ob_nr: int
    info_1: int
    info_2: int
    ret: int
    status: int
    stamp: bytes
    ev_class: int
    ev_num: int
    priority: int
    done: int

    @property
    def place(self) -> str:
        """How messages call the entry."""
        return f"entry {self.number}"


def begins(raw: bytes) -> bool:
    """Whether ``raw`` begins as a ring does."""
    return raw[:4] == bytes((*_MAGIC.to_bytes(2), *_LAYOUT.to_bytes(2)))


def read_header(raw: bytes) -> RingHeader:
    """The header of the ring in ``raw``, which may be longer."""
    if len(raw) < HEADER_LENGTH:
        raise SourceError("", f"a ring of at least {HEADER_LENGTH} bytes", f"{len(raw)} bytes")
    header = RingHeader._make(_HEADER.unpack_from(raw))
    if header.magic != _MAGIC:
        raise SourceError("", f"a ring that begins with 16#{_MAGIC:04X}", f"16#{header.magic:04X}")
    if header.layout != _LAYOUT:
        raise SourceError("", f"a ring of layout {_LAYOUT}", f"layout {header.layout}")
    if header.size != _ENTRY.size or header.capacity < 1:
        expected = f"slots of {_ENTRY.size} bytes, one at least"
        raise SourceError("", expected, f"{header.capacity} slots of {header.size}")
    return header


def read_slots(raw: bytes, header: RingHeader) -> list[RingEntry]:
    """The slots that were written, in the order in which they lie in the data block."""
    if len(raw) < header.length:
        expected = f"{header.length} bytes, for {header.capacity} slots"
        raise SourceError("", expected, f"{len(raw)} bytes")
    return [entry for entry in read_entries(raw[HEADER_LENGTH : header.length]) if entry.number]


def read_entries(raw: bytes) -> list[RingEntry]:
    """What whole slots hold, one behind the other."""
    return [RingEntry._make(fields) for fields in _ENTRY.iter_unpack(raw)]
