"""A running CPU whose time the test makes: ring, diagnostic buffer, mode and clock; two servers that show it."""

import socket
import struct
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import datetime, timedelta
from typing import Any

from snap7.server import Server

from tests.cpu import Cpu
from tests.importing.test_import_ring import bcd, packed

RING = 101
STOP, STARTUP, RUN, HOLD = 4, 6, 8, 0xA
MODES = {STOP: "STOP", STARTUP: "STARTUP", RUN: "RUN", HOLD: "HOLD"}
PDU = 240
_SIZE = 44


class Plc:
    """Its clock begins at 2026-11-21T05:59. ``told`` are its events; ``before`` is called at each request."""

    def __init__(self, capacity: int = 20, mode: int = STOP) -> None:
        self.now = datetime(2026, 11, 21, 5, 59)
        self.passed = 0
        self.mode = mode
        self.capacity = capacity
        self.slots = [bytes(_SIZE)] * capacity
        self.written = 0
        self.buffer: list[bytes] = []
        self.states: dict[int, int] = {}
        self.told: list[tuple[str, str]] = []
        self.before: Callable[[], None] = lambda: None
        self._booted = 0

    @property
    def at(self) -> str:
        """The clock as a log spells it."""
        return self.now.isoformat(timespec="milliseconds")

    def pass_time(self, ms: int) -> None:
        """Time passes."""
        self.now += timedelta(milliseconds=ms)
        self.passed += ms

    def fields(self, code: int, caller: int = 1, **more: Any) -> dict[str, Any]:
        """The fields of an entry that is made now."""
        return {"code": code, "caller": caller, "clk": bcd(self.at), "tick": self.passed - self._booted, **more}

    def enter(self, code: int, caller: int = 1, **more: Any) -> int:
        """The program makes an entry; the number of it."""
        self.begin_entry(self.fields(code, caller, **more))
        self.written += 1
        names = {28: "SET_TINT", 30: "ACT_TINT", 32: "SRT_DINT", 33: "CAN_DINT", 41: "DIS_AIRT", 42: "EN_AIRT"}
        self.told.append((names.get(code) or {0: "clock", 200: "start", 201: "end"}[code], self.at))
        return self.written

    def begin_entry(self, fields: dict[str, Any]) -> None:
        """Fills the next slot in and does not publish it."""
        self.slots[self.written % self.capacity] = packed(self.written + 1, fields)

    def complete(self, number: int, **more: Any) -> None:
        """What SFC 42 answered is filled in."""
        place = (number - 1) % self.capacity
        slot = self.slots[place]
        ret = more["ret"].to_bytes(2)
        self.slots[place] = slot[:28] + ret + slot[30:43] + b"\x01"

    def start(self, ob: int, number: int = 0x11, priority: int = 2, **more: Any) -> None:
        """An OB begins now."""
        start = {"ob": ob, "ev_class": 0x11, "ev_num": number, "priority": priority, "stamp": bcd(self.at)}
        self.enter(200, ob, **start, **more)

    def end(self, ob: int) -> None:
        """An OB ends."""
        self.enter(201, ob, ob=ob)

    def set_clock(self, to: datetime) -> None:
        """The program sets the clock."""
        self.enter(0, stamp=bcd(to.isoformat(timespec="milliseconds")))
        self.now = to

    def change(self, event_id: int, mode: int, name: str) -> None:
        """The mode changes, and the diagnostic buffer has it."""
        self.note(f"{event_id:04X} FF{self.mode:X}{mode:X} 0000 0000 0000 0000")
        self.mode = mode
        self.told.insert(-1, (name, self.at))

    def note(self, coding: str) -> None:
        """An entry of the diagnostic buffer."""
        self.buffer.insert(0, bytes.fromhex(coding) + bcd(self.at))
        del self.buffer[100:]
        self.told.append(("diag", self.at))

    def stop(self) -> None:
        """The switch."""
        self.change(0x4303, STOP, "stop")

    def restart(self, run: bool = True) -> None:
        """A warm restart; OB 100 ends 5 ms later, and the first cycle begins."""
        self._booted = self.passed
        self.change(0x4301, STARTUP, "restart")
        self.start(100, 0x81, 27)
        if run:
            self.pass_time(5)
            self.end(100)
            self.pass_time(1)
            self.change(0x4302, RUN, "run")
            self.pass_time(1)
            self.start(1, 1, 1)

    def records(self, szl: int, index: int) -> bytes | None:
        """A system status list, from the length of a record on."""
        self.before()
        if szl == 0x0424:
            return _listed([b"\x43\x02\xff" + bytes([0x40 | self.mode]) + bytes(8) + bcd(self.at)])
        if szl == 0x0222 and index in self.states:
            return _listed([bytes(20) + struct.pack(">HHI", self.states[index], 0, 0)])
        whole = [*self.buffer, *[bytes(20)] * (100 - len(self.buffer))]
        shown = {0x00A0: whole, 0x01A0: whole[:index]}.get(szl)
        return None if shown is None else _listed(shown)

    def data(self, number: int) -> bytes:
        """The ring."""
        self.before()
        if number != RING:
            return b""
        lost = max(0, self.written - self.capacity)
        slot = self.written % self.capacity
        head = struct.pack(">HhhhhHiI", 0x5337, 1, self.capacity, _SIZE, slot, 0, self.written, lost)
        return head + b"".join(self.slots)

    def clock(self) -> bytes:
        """DATE_AND_TIME."""
        self.before()
        return bcd(self.at)


def _listed(records: list[bytes]) -> bytes:
    return struct.pack(">HH", len(records[0]), len(records)) + b"".join(records)


class Own(Cpu):
    """The tests' own server: PDUs of 240 bytes, long lists in pieces."""

    def __init__(self, plc: Plc, port: int = 0) -> None:
        self.data = plc.data  # type: ignore[method-assign]
        self.records = plc.records  # type: ignore[method-assign]
        self.clock = plc.clock  # type: ignore[method-assign]
        super().__init__(port)


class Foreign(Server):
    """python-snap7's server, with the lists and the clock that it lacks, and PDUs of 240 bytes."""

    def __init__(self, plc: Plc) -> None:
        super().__init__(log=False)
        self._plc = plc
        self._rest = b""

    def _handle_setup_communication(self, request: Any) -> bytes:
        request["parameters"]["pdu_length"] = PDU
        return super()._handle_setup_communication(request)

    def _read_from_memory_area(self, area: Any, db_number: int, start: int, count: int) -> tuple[int, bytearray]:
        content = self._plc.data(db_number)[start : start + count]
        return (0xFF if len(content) == count else 0x05), bytearray(content)

    def _handle_get_clock(self, request: Any, userdata_params: Any, client_address: Any) -> bytes:
        return self._build_userdata_success_response(request, userdata_params, b"\0\x20" + self._plc.clock())

    def _handle_szl(self, request: Any, userdata_params: Any, client_address: Any) -> bytes:
        raw = request.get("data", {}).get("data", b"")
        if len(raw) >= 4:
            szl, index = struct.unpack(">HH", raw[:4])
            found = self._plc.records(szl, index)
            if found is None:
                return self._build_userdata_error_response(request, 0xD401)
            self._rest = raw[:4] + found
        piece, self._rest = self._rest[: PDU - 40], self._rest[PDU - 40 :]
        answer = bytearray(self._build_userdata_success_response(request, userdata_params, piece))
        answer[10 + 7], answer[10 + 9] = 1, bool(self._rest)
        return bytes(answer)


@contextmanager
def own(plc: Plc) -> Iterator[int]:
    """The port of the tests' own server."""
    server = Own(plc)
    yield server.port
    server.stop()


@contextmanager
def foreign(plc: Plc) -> Iterator[int]:
    """The port of python-snap7's server."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        port: int = free.getsockname()[1]
    server = Foreign(plc)
    server.start(port)
    yield port
    server.stop()
    server.destroy()
