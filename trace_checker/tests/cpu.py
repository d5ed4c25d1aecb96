"""A CPU for tests: ISO-on-TCP and the S7 protocol as far as reading, writing, stop and start need them, on a port of
its own.

python-snap7's own server does not have SZL 16#00A0, and never splits an answer.
"""

import socket
import threading

PDU = 240
"""The shortest PDU that CPUs negotiate; an S7-300 has it."""

SETUP, READ, WRITE, START, STOP = 0xF0, 0x04, 0x05, 0x28, 0x29
NAMES = {SETUP: "setup", READ: "read", WRITE: "write", START: "start", STOP: "stop"}
JOB, ANSWER, USER_DATA = 1, 3, 7
OK, ABSENT = 0xFF, 0x0A
NOT_AVAILABLE = 0xD401
"""Error of a CPU that does not have an SZL."""


class Cpu:
    """A CPU with system status lists and data blocks, answering on a port of its own.

    ``asked`` has what was asked for: functions, the SZL-IDs, ``clock``. It breaks the connection off after ``answers``
    more answers, if that is set.
    """

    def __init__(self, port: int = 0) -> None:
        self.szl: dict[tuple[int, int], bytes] = {}
        self.db: dict[int, bytes] = {}
        self.asked: set[object] = set()
        self.answers: int | None = None
        self.tsap = b""
        self._rest = b""
        self._listener = socket.create_server(("127.0.0.1", port))
        self.port: int = self._listener.getsockname()[1]
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """Ends the thread."""
        self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()
        self._thread.join(10)

    def _serve(self) -> None:
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                return
            with connection, connection.makefile("rb") as stream:
                while header := stream.read(4):
                    if self.answers is not None:
                        self.answers -= 1
                        if self.answers < 0:
                            self.answers = None
                            connection.sendall(b"\x03\x00")
                            break
                    answer = self._answer(stream.read(int.from_bytes(header[2:]) - 4))
                    if answer is None:
                        break
                    connection.sendall(b"\x03\x00" + (len(answer) + 4).to_bytes(2) + answer)

    def _answer(self, packet: bytes) -> bytes | None:
        """The answer to a COTP packet."""
        if packet[1] == 0xE0:  # connection request, confirmed with the references turned around
            self.tsap = packet.partition(b"\xc2\x02")[2][:2]
            parameters = packet[7:]
            return bytes([6 + len(parameters), 0xD0]) + packet[4:6] + b"\x00\x01\x00" + parameters
        if packet[1] != 0xF0:
            return None
        pdu = packet[3:]
        length = int.from_bytes(pdu[6:8])
        kind, parameters, data = pdu[1], pdu[10 : 10 + length], pdu[10 + length :]
        reply = self._job(parameters, data) if kind == JOB else self._user_data(parameters, data)
        answer_kind, errors, parameters, data = reply
        assert 12 + len(parameters) + len(data) <= PDU
        lengths = len(parameters).to_bytes(2) + len(data).to_bytes(2)
        header = b"\x32" + bytes([answer_kind]) + pdu[2:6] + lengths + errors
        return b"\x02\xf0\x80" + header + parameters + data

    def _job(self, parameters: bytes, data: bytes) -> tuple[int, bytes, bytes, bytes]:
        self.asked.add(NAMES[parameters[0]])
        if parameters[0] == SETUP:
            return ANSWER, b"\0\0", b"\xf0\0\0\x01\0\x01" + PDU.to_bytes(2), b""
        if parameters[0] in (START, STOP):
            self.control(parameters[0] == START)
            return ANSWER, b"\0\0", parameters[:1], b""
        count, number = int.from_bytes(parameters[6:8]), int.from_bytes(parameters[8:10])
        start = int.from_bytes(parameters[11:14]) // 8
        if parameters[0] == WRITE:
            self.write(number, start, data[4:])
            return ANSWER, b"\0\0", b"\x05\x01", bytes([OK])
        content = self.data(number)[start : start + count]
        if len(content) < count:
            return ANSWER, b"\0\0", b"\x04\x01", bytes([ABSENT, 0, 0, 0])
        return ANSWER, b"\0\0", b"\x04\x01", bytes([OK, 4]) + (count * 8).to_bytes(2) + content

    def control(self, start: bool) -> None:
        """A warm restart, or STOP."""

    def write(self, number: int, start: int, content: bytes) -> None:
        """Bytes of a data block."""

    def set_clock(self, to: bytes) -> None:
        """The clock is set to a DATE_AND_TIME."""

    def data(self, number: int) -> bytes:
        """A data block; empty if there is none."""
        return self.db.get(number, b"")

    def records(self, szl: int, index: int) -> bytes | None:
        """A system status list from the length of a record on; None if there is none."""
        return self.szl.get((szl, index))

    def clock(self) -> bytes:
        """DATE_AND_TIME."""
        return bytes.fromhex("2611210600000000")

    def _user_data(self, parameters: bytes, data: bytes) -> tuple[int, bytes, bytes, bytes]:
        """The clock; or a piece of an SZL: the list anew, or what is left of it."""
        if parameters[5:7] == b"\x47\x01":
            self.asked.add("clock")
            head = b"\0\x01\x12\x08\x12\x87\x01\x01\0\0\0\0"
            return USER_DATA, b"", head, bytes([OK, 9, 0, 10, 0, 0x20]) + self.clock()
        if parameters[5:7] == b"\x47\x02":
            self.set_clock(data[-8:])
            return USER_DATA, b"", b"\0\x01\x12\x08\x12\x87\x02\x01\0\0\0\0", b"\x0a\0\0\0"
        assert parameters[5:7] == b"\x44\x01", parameters
        error = 0
        if parameters[4] == 0x11:
            szl, index = int.from_bytes(data[4:6]), int.from_bytes(data[6:8])
            self.asked.add(szl)
            found = self.records(szl, index)
            error = NOT_AVAILABLE if found is None else 0
            self._rest = data[4:8] + (found or b"")
        piece, self._rest = self._rest[: PDU - 40], self._rest[PDU - 40 :]
        more = bool(self._rest)
        head = b"\0\x01\x12\x08\x12\x84\x01\x01" + bytes([0, more]) + error.to_bytes(2)
        code = ABSENT if error else OK
        return USER_DATA, b"", head, bytes([code, 9]) + len(piece).to_bytes(2) + piece
