"""The CPU itself, read over ISO-on-TCP by python-snap7, an optional dependency."""

import logging
import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, NamedTuple

from s7check.importing.asking import ring_of
from s7check.importing.errors import SourceError, shown
from s7check.log.errors import printable

if TYPE_CHECKING:
    from snap7 import Client

SCHEME = "snap7://"
ISO_ON_TCP = 102
RING_HEADER = 20
"""Bytes of a ring before its slots."""

INSTALL = 'pip install "python-snap7>=3.3"'

_ADDRESS = re.compile(r"snap7://([^:/\s]+):([0-9]{1,2}):([0-9]{1,2})")
_DIAGNOSTIC_BUFFER = 0x00A0
LENGTH = 20
"""Bytes of a record of it."""

_COUNTS = 4
"""Bytes before the records: length of a record, number of records."""


class Address(NamedTuple):
    """A CPU; rack 0, slot 2 for an S7-300."""

    host: str
    rack: int
    slot: int
    port: int


def parse(text: str, port: int) -> Address:
    """The address ``snap7://HOST:RACK:SLOT``."""
    match = _ADDRESS.fullmatch(text)
    if not match:
        raise SourceError("", "an address snap7://HOST:RACK:SLOT", shown(text))
    return Address(match[1], int(match[2]), int(match[3]), port)


def read_diagnostic_buffer(address: Address) -> tuple[bytes, list[str]]:
    """The bytes of SZL 16#00A0 from the length of a record on, and remarks about them.

    Not ``Client.read_diagnostic_buffer``, which looks for the time in other bytes than S7-300/400 put it.
    """
    with _connected(address) as cpu:
        szl = cpu.read_szl(_DIAGNOSTIC_BUFFER, 0)
    raw = bytes(szl.Data[: szl.Header.LengthDR])
    announced = int.from_bytes(raw[2:_COUNTS])
    whole = (len(raw) - _COUNTS) // LENGTH
    if announced <= whole:
        return raw, []
    # The newest entries come first, so the oldest entries are missing at the end.
    remark = f"of the CPU's {announced} entries only the {whole} newest could be read"
    return raw[_COUNTS : _COUNTS + whole * LENGTH], [remark]


def read_ring(address: Address, db: int) -> bytes:
    """The data block of the SCL instrumentation's ring.

    The header is read first: an entry that it counts is complete when the slots are read.
    """
    with _connected(address) as cpu:
        start = bytes(cpu.db_read(db, 0, RING_HEADER))
        header = ring_of(start)
        return start + bytes(cpu.db_read(db, RING_HEADER, header.length - RING_HEADER))


class NoAnswerError(SourceError):
    """The CPU cannot be reached, or refuses what is asked of it."""


def client(address: Address) -> "Client":
    """A connection to the CPU. Raises SourceError without python-snap7, NoAnswerError where nobody answers."""
    try:
        from snap7 import Client
    except ImportError as error:
        raise SourceError("", f"python-snap7 to read a CPU: {INSTALL}", "none") from error
    # What goes wrong is said once, by the exception.
    logging.getLogger("snap7").addHandler(logging.NullHandler())
    cpu = Client()
    try:
        with answers():
            cpu.connect(address.host, address.rack, address.slot, address.port)
    except NoAnswerError:
        cpu.disconnect()
        raise
    return cpu


@contextmanager
def answers() -> Iterator[None]:
    """What goes wrong with a request, as NoAnswerError."""
    from snap7.error import S7Error

    try:
        yield
    except (S7Error, OSError, RuntimeError, ValueError) as error:
        raise NoAnswerError("", "an answer of the CPU", printable(str(error), 200)) from error


@contextmanager
def _connected(address: Address) -> Iterator["Client"]:
    cpu = client(address)
    try:
        with answers():
            yield cpu
    finally:
        cpu.disconnect()
