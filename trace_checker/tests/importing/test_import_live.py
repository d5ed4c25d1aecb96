"""Reading a CPU by python-snap7, against a CPU of our own."""

import json
import socket
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

from s7check import cli
from tests.cpu import Cpu
from tests.importing.test_import_diagnostics import records
from tests.importing.test_import_ring import dump, entry
from tests.test_shipped_logs import PROJECT


@pytest.fixture
def cpu() -> Iterator[Cpu]:
    """A running CPU."""
    running = Cpu()
    yield running
    running.stop()


def imported(cpu: Cpu, log: Path, *arguments: str) -> list[dict[str, object]]:
    """The lines of the log imported from the CPU."""
    options = ["--cpu", "S7-300", "--obs", "1,10,80", "--port", str(cpu.port), "-o", str(log)]
    assert cli.main(["import", "snap7://127.0.0.1:0:2", *options, *arguments]) == 0
    return [json.loads(line) for line in log.read_text().splitlines()]


def refused(capfd: pytest.CaptureFixture[str], *arguments: str) -> str:
    """The one message with which an import fails."""
    code = cli.main(["import", "--cpu", "S7-300", "--obs", "1", "--mode", "RUN", *arguments])
    captured = capfd.readouterr()
    assert (code, captured.out) == (2, "")
    assert captured.err.startswith("Error: ") or captured.err.startswith("Usage: ")
    return captured.err.partition("Error: ")[2].rstrip("\n")


def listed(content: bytes) -> bytes:
    """Records with the length of one and their number before them."""
    return (20).to_bytes(2) + (len(content) // 20).to_bytes(2) + content


def test_diagnostic_buffer(cpu: Cpu, tmp_path: Path) -> None:
    """A buffer longer than a PDU, oldest entry first, the same as from a file."""
    content = records(*["3502 1A50 C358 0000 1136 0C23"] * 9, "4568 FF84 C700 0000 0000 0000")
    content = content + bytes(20 * 90)
    cpu.szl[0x00A0, 0] = listed(content)
    header, *events = imported(cpu, tmp_path / "log")
    assert cpu.tsap == b"\x01\x02", "rack 0, slot 2"
    assert (header["mode"], header["records"]) == ("RUN", ["mode", "diag"])
    assert [event["event"] for event in events] == ["diag"] * 9 + ["stop", "diag"]
    (tmp_path / "raw").write_bytes(content)
    options = ["--from", "szl", "--cpu", "S7-300", "--obs", "1,10,80", "-o", str(tmp_path / "file")]
    assert cli.main(["import", str(tmp_path / "raw"), *options]) == 0
    assert (tmp_path / "file").read_bytes() == (tmp_path / "log").read_bytes()


def test_more_entries_than_fit(cpu: Cpu, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """What python-snap7 has no room for is said; what it has is whole entries, the newest."""
    (only,) = [records("3502 1A50 C358 0000 1136 0C23")]
    cpu.szl[0x00A0, 0] = listed(only * 900)
    lines = imported(cpu, tmp_path / "log", "--mode", "RUN")
    err = capsys.readouterr().err
    assert f"{len(lines) - 1} entries read, 0 skipped" in err
    assert f"note: of the CPU's 900 entries only the {len(lines) - 1} newest could be read" in err
    assert 800 < len(lines) < 900


def test_ring(cpu: Cpu, tmp_path: Path) -> None:
    """The ring is read over several PDUs, without what a longer DB holds behind it."""
    cpu.db[101] = dump(*(entry(30, second, ob=10 + second) for second in range(8))) + bytes(1000)
    header, *events = imported(cpu, tmp_path / "log", "--from", "ring", "--db", "101", "--records", "call")
    assert header["records"] == ["call"]
    assert [event["ob"] for event in events] == list(range(10, 18))


def test_what_a_cpu_does_not_have(cpu: Cpu, capfd: pytest.CaptureFixture[str]) -> None:
    """One message names the CPU and what went wrong."""
    address = "snap7://127.0.0.1:0:2"
    at = ["--port", str(cpu.port), address]
    assert refused(capfd, *at).startswith(f"{address}: expected an answer of the CPU; found ")
    assert refused(capfd, *at, "--from", "ring", "--db", "7").startswith(f"{address}: expected an answer of the CPU;")
    cpu.db[7] = bytes(1000)
    expected = f"{address}: expected a ring that begins with 16#5337; found 16#0000"
    assert refused(capfd, *at, "--from", "ring", "--db", "7") == expected


def test_nobody_answers(capfd: pytest.CaptureFixture[str]) -> None:
    """An address where nothing listens."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
    message = refused(capfd, "snap7://127.0.0.1:0:2", "--port", str(port))
    assert message.startswith("snap7://127.0.0.1:0:2: expected an answer of the CPU; found ")


@pytest.mark.parametrize("address", ["snap7://", "snap7://plc", "snap7://plc:0", "snap7://plc:a:2", "snap7://plc/0/2"])
def test_wrong_address(address: str, capfd: pytest.CaptureFixture[str]) -> None:
    """An address is HOST:RACK:SLOT."""
    assert refused(capfd, address) == f'{address}: expected an address snap7://HOST:RACK:SLOT; found "{address}"'


def test_wrong_use(capfd: pytest.CaptureFixture[str]) -> None:
    """A CPU gives its diagnostic buffer or a ring, whose data block has to be named."""
    assert refused(capfd, "snap7://plc:0:2", "--from", "ring") == "--db: which data block is the ring?"
    assert refused(capfd, "snap7://plc:0:2", "--from", "csv") == "--from csv: a CPU gives szl or ring"


def test_without_snap7(capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """python-snap7 is needed for this only, and the message says how to get it, in the version of pyproject.toml."""
    monkeypatch.setitem(sys.modules, "snap7", None)
    message = refused(capfd, "snap7://plc:0:2")
    extras = tomllib.loads((PROJECT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    (package,) = extras["snap7"]
    assert message.endswith(f'expected python-snap7 to read a CPU: pip install "{package}"; found none')
