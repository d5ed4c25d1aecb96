"""A CPU as it is read while it runs.

Few requests, and only such as monitoring tools send all the time: never ``get_cpu_info``, which has put CPUs into the
state DEFECT, and nothing that writes.
"""

from contextlib import suppress
from datetime import datetime
from typing import TYPE_CHECKING

from s7check.importing.asking import Ring, Slot, mode_of, ring_of, slots_of
from s7check.importing.errors import SourceError
from s7check.importing.sources import live

if TYPE_CHECKING:
    from snap7 import Client

_ALL, _NEWEST, _MODE, _INTERRUPT = 0x00A0, 0x01A0, 0x0424, 0x0222
_COUNTS = 4
_BZU_ID = 3
"""Byte of a record of SZL 16#0424: previous mode, mode."""

_AL1 = 20
"""Byte of a record of SZL 16#0222: its word al1, behind the start information."""


class Connection:
    """A CPU; every method connects where there is no connection, and raises NoAnswerError where none comes about."""

    def __init__(self, address: live.Address, db: int) -> None:
        self._address = address
        self._db = db
        self._client: Client | None = None

    def close(self) -> None:
        """Ends the connection; the next request begins a new one."""
        client, self._client = self._client, None
        if client is not None:
            with suppress(Exception):  # nobody may be there any more
                client.disconnect()

    def clock(self) -> datetime:
        """The CPU clock."""
        client = self._connected()
        with live.answers():
            return client.get_plc_datetime()

    def ring(self) -> Ring:
        """The header of the ring."""
        return ring_of(self._data(0, live.RING_HEADER))

    def slots(self, header: Ring, first: int, last: int) -> list[Slot]:
        """What the slots of the entries ``first`` to ``last`` hold, at most as many as the ring has slots."""
        entries: list[Slot] = []
        while first <= last:
            begin = (first - 1) % header.capacity
            count = min(last - first + 1, header.capacity - begin)
            entries += slots_of(self._data(live.RING_HEADER + begin * header.size, count * header.size))
            first += count
        return entries

    def newest(self, count: int) -> list[bytes]:
        """The newest records of the diagnostic buffer, the newest first."""
        return self._records(_NEWEST, count)

    def all_records(self) -> list[bytes]:
        """All records of the diagnostic buffer, the newest first."""
        return self._records(_ALL, 0)

    def mode(self) -> str | None:
        """The operating mode, None if it is another than STOP, STARTUP, RUN and HOLD."""
        (record, *_) = self._list(_MODE, 0) or [b""]
        return mode_of(record[_BZU_ID] & 0xF) if len(record) > _BZU_ID else None

    def state(self, ob: int) -> int | None:
        """The word al1 of an OB, None if the CPU does not tell it."""
        (record, *_) = self._list(_INTERRUPT, ob) or [b""]
        return int.from_bytes(record[_AL1 : _AL1 + 2]) if len(record) >= _AL1 + 2 else None

    def _connected(self) -> "Client":
        if self._client is None:
            self._client = live.client(self._address)
        return self._client

    def _data(self, start: int, length: int) -> bytes:
        client = self._connected()
        with live.answers():
            return bytes(client.db_read(self._db, start, length))

    def _records(self, szl: int, index: int) -> list[bytes]:
        records = self._list(szl, index)
        if any(len(record) != live.LENGTH for record in records):
            raise SourceError("", f"records of {live.LENGTH} bytes in SZL 16#{szl:04X}", f"{len(records[0])} bytes")
        return [record for record in records if any(record)]

    def _list(self, szl: int, index: int) -> list[bytes]:
        """The records of a system status list."""
        client = self._connected()
        with live.answers():
            answer = client.read_szl(szl, index)
        raw = bytes(answer.Data[: answer.Header.LengthDR])
        length = int.from_bytes(raw[:2])
        return [raw[at : at + length] for at in range(_COUNTS, len(raw) - length + 1, length)] if length else []
