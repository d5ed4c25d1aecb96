"""A CPU that is awlsim with the interpreter in it, behind the S7 protocol: the tests' own server or that of
python-snap7. Run as a program.

awlsim executes the AWL; the interrupts and SFCs that it lacks come from examples/adapters. Time is simulated: a restart
runs the program to its end or to STOP, in which the clock goes on with each look at it.
"""

import logging
import re
import struct
import sys
from datetime import datetime, timedelta
from pathlib import Path
from threading import Event, Thread
from typing import Any

ROOT = Path(__file__).parents[3]
sys.path[:0] = [str(ROOT / "build" / "awlsim"), str(ROOT / "examples" / "adapters")]

import awlsim.core.main  # type: ignore  # noqa: E402
import awlsim_adapter as shipped  # type: ignore  # noqa: E402
from awlsim.awlcompiler import AwlParser  # type: ignore  # noqa: E402
from awlsim.common.sources import AwlSource  # type: ignore  # noqa: E402
from awlsim.core.blockinterface import BlockInterfaceField as Field  # type: ignore  # noqa: E402
from awlsim.core.memory import make_AwlMemoryObject_fromBytes as octets_of  # type: ignore  # noqa: E402
from awlsim.core.systemblocks.systemblocks import SFC  # type: ignore  # noqa: E402
from awlsim.core.systemblocks.tables import SFC_table  # type: ignore  # noqa: E402
from template import Adapter  # type: ignore  # noqa: E402

from s7check.live import driver  # noqa: E402
from tests.importing.test_import_ring import bcd  # noqa: E402
from tests.live.plc import RUN, STARTUP, STOP, Foreign, Own, Plc  # noqa: E402

INTERPRETER = ROOT / "instrumentation" / "awl" / "kit.awl"
PROGRAM = 110
CYCLE_MS = 5
LOOK_MS = 20
RESTARTED = 4
DATA = 0xF0
STARTS = {40: 0x41, 100: 0x81, **{10 + n: 0x11 + n for n in range(8)}, **{20 + n: 0x21 + n for n in range(4)}}


class Interpreted(shipped.AwlAdapter):  # type: ignore[misc]
    """The adapter's CPU and time, and the interpreter in the place of bodies."""

    def __init__(self, plc: "AwlPlc", source: str, obs: list[int], family: str) -> None:
        shipped.AwlAdapter.current = self
        self.plc = plc
        self.begun: list[int] = []
        self.outside: list[Any] = []
        self.cycles: list[Any] = []
        self.infos: dict[int, bytes] = {}
        self.awl = _loaded(source)
        header = {"cpu": family, "obs": obs, "clock": plc.at, "mode": "STOP"}
        Adapter.__init__(self, {"header": header, "bodies": [], "outside": [], "duration": 0})
        self.awl.getCPU().setPeripheralWriteCallback(self.edge)
        data = self.awl.getCPU().getDB
        self.blocks = {number: data(number).structInstance.memory.getRawDataBytes() for number in (101, 110, 111)}

    def log(self, event: str, **fields: Any) -> None:
        """What the CPU says: changes of the mode, and the start information of an OB that is to begin."""
        self.plc.now = self.clock + timedelta(milliseconds=self.now)
        if event in ("stop", "restart", "run"):
            known = {"stop": (0x4303, STOP), "restart": (0x4301, STARTUP), "run": (0x4302, RUN)}[event]
            self.plc.change(int(fields.get("cause", hex(known[0])).replace("16#", "0x"), 16), known[1], event)
        elif event == "start":
            self.infos[fields["ob"]] = self._info(fields["ob"], fields.get("info", {}))

    def _info(self, ob: int, info: dict[str, Any]) -> bytes:
        number = int(info.get("flt_id", STARTS.get(ob, 0)))
        words = [str(info.get(name, "16#0")) for name in ("period", "sign", "error_info")]
        info_1 = sum(int(word.replace("16#", "0x"), 16) for word in words)
        cause = int(str(info.get("ev", "16#0")).replace("16#", "0x"), 16) << 16 | info.get("ev_ob", 0)
        info_2 = info.get("dtime", 0) + cause
        head = struct.pack(">BBBBBBHI", 0x11, number, self.cpu.level(ob), ob, 0, 0, info_1, info_2)
        return head + bcd(info.get("time", self.plc.at))

    def execute(self, ob: int) -> None:
        """An OB, with its start information; the cycle goes on."""
        local = self.awl.getCPU().getOB(ob).lstack.memory.getRawDataBytes()
        local[0:20] = self.infos.get(ob) or self._info(ob, {})
        super().execute(ob)
        if ob == 1:
            self.cpu.cycle = self.now + CYCLE_MS

    def edge(self, *_: Any) -> bool:
        """The output is wired to the interrupt input of OB 40."""
        self.cpu.outside({"event": "interrupt", "ob": 40})
        return True

    def halt(self) -> None:
        """SFC 46."""
        self.cpu.to_stop("16#457F")
        self.happen()

    def set_clock_to(self, to: datetime) -> None:
        """SFC 0."""
        before = self.clock + timedelta(milliseconds=self.now)
        self.clock += to - before
        self.cpu.clock_set(before, to)

    booted = 0

    def restart(self) -> None:
        """The program in DB 110 from a warm restart to its end, or to STOP. SFC 64 starts anew."""
        state, elapsed, duration = struct.unpack_from(">hxxi8xI", self.blocks[PROGRAM], 8)
        self.program["duration"] = self.now + duration + 1000 - (elapsed if state == RESTARTED else 0)
        self.booted = self.now
        self.cpu.outside({"event": "restart", "type": "warm"})
        self.run()

    def pass_time(self, most: int = sys.maxsize) -> int:
        """In STOP nothing happens any more."""
        if self.cpu.mode == "STOP":
            self.program["duration"] = self.now
            return 0
        return int(super().pass_time(most))


class AwlPlc(Plc):
    """Data blocks are those of awlsim."""

    def __init__(self, source: str, obs: list[int], family: str) -> None:
        super().__init__()
        self.awl = Interpreted(self, source, obs, family)
        self.running = Thread()
        self.running.start()

    def data(self, number: int) -> bytes:
        """A data block."""
        return bytes(self.awl.blocks.get(number, b""))

    def write(self, number: int, start: int, content: bytes) -> None:
        """Bytes of a data block."""
        self.awl.blocks[number][start : start + len(content)] = content

    def clock(self) -> bytes:
        """DATE_AND_TIME."""
        if self.awl.cpu.mode == "STOP":
            self.awl.now += LOOK_MS
        self.now = self.awl.clock + timedelta(milliseconds=self.awl.now)
        return super().clock()

    def set_clock_by(self, to: bytes) -> None:
        """The clock is set over the network."""
        self.awl.set_clock_to(datetime.fromisoformat(shipped.date_of(to)))

    def control(self, start: bool) -> None:
        """A warm restart, or STOP once the program is over."""
        if start:
            self.running = Thread(target=self.awl.restart, daemon=True)
            self.running.start()
        else:
            self.running.join()
            self.awl.cpu.to_stop()


class Link:
    """The same CPU without the S7 protocol: the calls of a driver."""

    def __init__(self, plc: AwlPlc) -> None:
        self._plc = plc

    def load(self, program: bytes) -> None:
        """STOP, and a program."""
        self._plc.control(start=False)
        self._plc.write(PROGRAM, 0, program)
        self._plc.write(111, 16, bytes(272))

    def restart(self) -> None:
        """A warm restart."""
        self._plc.control(start=True)

    def ring(self) -> bytes:
        """DB 101, once the program is over."""
        self._plc.running.join()
        return self._plc.data(101)


class OwnServer(Own):
    """Also writes, stops, starts, and has its clock set; breaks the connection off after every so many answers."""

    def __init__(self, plc: AwlPlc, port: int, broken: int) -> None:
        self.control, self.write = plc.control, plc.write  # type: ignore[method-assign]
        self.set_clock = plc.set_clock_by  # type: ignore[method-assign]
        self._broken = broken
        super().__init__(plc, port)

    def _answer(self, packet: bytes) -> bytes | None:
        if self._broken and self.answers is None and packet[1] == DATA:
            self.answers = self._broken
        return super()._answer(packet)


class ForeignServer(Foreign):
    """Also writes, stops, starts, and has its clock set."""

    _plc: AwlPlc

    def _write_to_memory_area(self, area: Any, db_number: int, start: int, write_data: bytearray) -> bool:
        self._plc.write(db_number, start, bytes(write_data))
        return True

    def _handle_plc_stop(self, request: Any, client_address: Any) -> bytes:
        self._plc.control(start=False)
        return super()._handle_plc_stop(request, client_address)

    def _handle_set_clock(self, request: Any, userdata_params: Any, client_address: Any) -> bytes:
        self._plc.set_clock_by(request["data"]["data"][-8:])
        return self._build_userdata_success_response(request, userdata_params, b"", null_ack=True)

    def _handle_plc_control(self, request: Any, client_address: Any) -> bytes:
        self._plc.control(start=True)
        return super()._handle_plc_control(request, client_address)


def _loaded(source: str) -> Any:
    parser = AwlParser()
    parser.parseSource(AwlSource(name="kit", filepath=None, sourceBytes=source.encode("latin-1")))
    awl = awlsim.core.main.AwlSim()
    awl.load(parser.getParseTree())
    awl.build()
    awl.getCPU().setRunTimeLimit(-1.0)
    awl.getCPU().setCycleTimeLimit(1e9)
    return awl


def _system_function(number: int, inputs: dict[str, str], outputs: dict[str, str], behaviour: Any) -> None:
    """Puts a system function into awlsim's table; ``behaviour`` gets the operands, and returns bytes of the outputs."""

    def run(self: Any) -> None:
        given = {name: self.fetchInterfaceFieldByName(name) for name in inputs}
        for name, octets in zip(outputs, behaviour(given), strict=True):
            self.storeInterfaceFieldByName(name, octets_of(bytearray(octets), len(octets) * 8))
        self.cpu.statusWord.BIE = 1

    fields = {
        kind: tuple(Field(name=name, dataType=type_) for name, type_ in of.items())
        for kind, of in ((Field.FTYPE_IN, inputs), (Field.FTYPE_OUT, outputs))
        if of
    }
    members = {"name": (number, f"SFC{number}", ""), "interfaceFields": fields, "run": run}
    SFC_table[number] = type(f"SFC{number}", (SFC,), members)


def _install() -> None:
    shipped.install()

    def current() -> Interpreted:
        found = shipped.AwlAdapter.current
        assert isinstance(found, Interpreted)
        return found

    def set_clock(given: dict[str, Any]) -> tuple[bytes]:
        date = shipped.date_of(shipped.AwlMemoryObject_asBytes(given["PDT"]))
        try:
            to = datetime.fromisoformat(date)
        except ValueError:
            return (b"\x80\x80",)
        current().set_clock_to(to)
        return (bytes(2),)

    def tick(_: dict[str, Any]) -> tuple[bytes]:
        current().busy(1)
        return (struct.pack(">i", current().now - current().booted),)

    def clock(_: dict[str, Any]) -> tuple[bytes, bytes]:
        now = current().clock + timedelta(milliseconds=current().now)
        return bytes(2), bcd(now.isoformat(timespec="milliseconds"))

    _system_function(0, {"PDT": "DATE_AND_TIME"}, {"RET_VAL": "INT"}, set_clock)
    _system_function(1, {}, {"RET_VAL": "INT", "CDT": "DATE_AND_TIME"}, clock)
    _system_function(43, {}, {}, lambda _: current().busy(4))
    _system_function(46, {}, {}, lambda _: current().halt())
    _system_function(64, {}, {"RET_VAL": "TIME"}, tick)


def main(kind: str, port: int, family: str, obs: list[int], change: str) -> None:
    """Serves until it is ended; ``change``: OLD->NEW|... in the interpreter, or empty. ``kind``: foreign, own, own:N,
    which breaks off every N answers, or link, an adapter without the S7 protocol.
    """
    logging.disable()
    shipped.Logging.setLoglevel(shipped.Logging.LOG_NONE)
    _install()
    source = INTERPRETER.read_text(encoding="ascii")
    for old, new in (one.split("->") for one in change.split("|") if one):
        assert source.count(old) == 1, "the change fits one place"
        source = source.replace(old, new)
    call = re.search(r"^// (CALL FC 200 .*;)$", source, re.MULTILINE)
    assert call is not None
    for ob in obs:
        body = call[1].replace("n,", f"{ob},")
        source += f"\nORGANIZATION_BLOCK OB {ob}\nVAR_TEMP\nINFO : ARRAY [0..19] OF BYTE;\nEND_VAR\nBEGIN\n{body}\n"
        source += "END_ORGANIZATION_BLOCK\n"
    plc = AwlPlc(source, obs, family)
    if kind == "link":
        driver.main(Link(plc), latency=20, slack=0)
        return
    if kind == "foreign":
        ForeignServer(plc).start(port)
    else:
        OwnServer(plc, port, int(kind.partition(":")[2] or 0))
    print("serving", flush=True)
    Event().wait()


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), sys.argv[3], [int(ob) for ob in sys.argv[4].split(",")], sys.argv[5])
