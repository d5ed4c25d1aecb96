"""Programs of the kit on a CPU over the S7 protocol: awlsim executes the interpreter in AWL."""

import json
import socket
import struct
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from s7check import cli
from s7check.kit.collection import chosen, programs_of
from s7check.kit.hardware import encoded, fitted, happened, lacks, restarted
from s7check.kit.program import Program, read_program
from tests.kit.programs import PROGRAM
from tests.test_shipped_logs import PROJECT

OBS = [1, *range(10, 18), *range(20, 24), 40, 80, 85, 100]
AWLSIM = PROJECT / "build" / "awlsim"
SHORT = (
    "DINT-14-cancel-without-a-job",
    "TINT-61-nothing-set-answers-80A1",
    "OBS-01-hardware-interrupt-one-millisecond-late",
    "DINT-13-job-of-ob-21-gone-after-a-restart",
)
"""CAN_DINT and ACT_TINT of OBs for which nothing is set, an interrupt from outside, calls after a restart."""

WITH_RESTARTS = {
    "DINT-11-elapsed-in-startup-runs-in-run": "STOP",
    "AMB-67-a-event-in-startup-kept": "STARTUP",
    "DINT-13-warm-restart-discards-the-job": "RUN",
    "DINT-10-SRT_DINT-restart": "RUN",
    "AIRT-11-stopped-while-interrupts-are-delayed": "RUN",
}
"""Programs that restart, stop in mid-program or begin so, and the modes in which they begin."""

Serve = Callable[..., int]

awlsim = pytest.mark.skipif(not AWLSIM.is_dir(), reason="awlsim is not there; `make test-checker` installs it")


@pytest.fixture
def serve() -> Iterator[Serve]:
    """A function that starts such a CPU, with a change of its interpreter, and has its port."""
    servers = []

    def one(change: str = "", kind: str = "foreign") -> int:
        with socket.create_server(("127.0.0.1", 0)) as free:
            port: int = free.getsockname()[1]
        command = [
            sys.executable,
            "-m",
            "tests.live.awl_cpu",
            kind,
            str(port),
            "S7-300",
            ",".join(map(str, OBS)),
            change,
        ]
        server = subprocess.Popen(command, cwd=PROJECT / "trace_checker", stdout=subprocess.PIPE)
        servers.append(server)
        assert server.stdout is not None
        assert server.stdout.readline() == b"serving\n"
        return port

    yield one
    for server in servers:
        server.kill()
        server.communicate()


def run(folder: Path, port: int, *choice: str) -> dict[str, str]:
    """The statuses of the programs on the CPU that these options choose."""
    offer, output = folder / "offer.json", folder / "result.json"
    offer.write_text(json.dumps({"cpu": ["S7-300"], "obs": OBS}))
    address = ["--cpu-address", "snap7://127.0.0.1:0:2", "--port", str(port), "--latency=20", "--timeout=0.1"]
    given = [*choice, "--offer", str(offer), "--output", str(output), *address]
    cli.main(["kit", "run", *given, "--stop-cpu-and-set-clock"])
    return {one["name"]: one["status"] for one in json.loads(output.read_text())["programs"]}


@awlsim
def test_smoke(serve: Serve, tmp_path: Path) -> None:
    """The few programs that reach what the CPU can reach: each log comes whole, however often the connection breaks."""
    statuses = run(tmp_path, serve(kind="own:31"), "--cover", "requirements", "--budget", "2min")
    assert len(statuses) >= 10
    assert set(statuses.values()) == {"passed"}, statuses


@awlsim
def test_restarts(serve: Serve, tmp_path: Path) -> None:
    """STOP, a warm restart, a beginning in STARTUP or STOP; more entries than slots between two polls: no log at all,
    or the whole one.
    """
    assert {one.name: one.header["mode"] for one in chosen(programs_of(), list(WITH_RESTARTS), [])} == WITH_RESTARTS
    statuses = run(tmp_path, serve(), *(f"--only={name}" for name in [*WITH_RESTARTS, "AIRT-nesting-127"]))
    assert statuses.pop("AIRT-nesting-127") in ("passed", "skipped")
    assert statuses == dict.fromkeys(WITH_RESTARTS, "passed")


@awlsim
def test_wrong_interpreter(serve: Serve, tmp_path: Path) -> None:
    """What the interpreter does wrong is found: no edge at the output, no OB at work after a restart."""
    statuses = run(tmp_path, serve("T PQB 0;->|JC ENTR;->JU ENTR;", "own"), *(f"--only={name}" for name in SHORT))
    assert {name for name, status in statuses.items() if status == "failed"} == {*SHORT[2:]}


@awlsim
def test_driver(tmp_path: Path) -> None:
    """The three calls of another link, without STOP and restart; SFC 34 in the place of SFC 33 is found."""
    change = "C33:  CALL->C33:  CALL SFC 34 ( OB_NR := #N, RET_VAL := #RET, STATUS := #STA ); JU NOTE; CALL"
    offer, output = tmp_path / "offer.json", tmp_path / "result.json"
    offer.write_text(json.dumps({"cpu": ["S7-300"], "obs": OBS, "loaded": OBS}))
    command = [sys.executable, "-m", "tests.live.awl_cpu", "link", "0", "S7-300", ",".join(map(str, OBS)), change]
    chosen_ = [f"--only={name}" for name in (SHORT[0], SHORT[1], SHORT[3])]
    cli.main(["kit", "run", *chosen_, "--offer", str(offer), "--output", str(output), "--jobs=1", "--", *command])
    statuses = {one["name"]: (one["status"], one["reason"]) for one in json.loads(output.read_text())["programs"]}
    assert statuses.pop(SHORT[3]) == ("skipped", "no STOP and no restart over this link")
    assert [status for status, _ in statuses.values()] == ["failed", "passed"], statuses


def test_encoded() -> None:
    """Byte for byte as instrumentation/awl/README.md has it."""
    (program,) = chosen(programs_of(), ["DINT-beside-20-21-cancel"], [])
    content = encoded(fitted(program, "S7-300", OBS))
    head = struct.unpack_from(">HhhhhhI8sII", content)
    assert head[:7] == (0x5331, 1, 498, 0, 1, 0, 0)
    assert head[7][:7].hex() == "".join(filter(str.isdigit, program.plain["header"]["clock"]))[2:16]
    assert head[8:] == (program.duration, 32)
    steps = [content[at : at + 16] for at in range(32, len(content), 16)]
    assert steps[0] == bytes([254, 0]) + struct.pack(">hH", 1, 1) + bytes(10)
    assert steps[-1] == bytes([255]) + bytes(15)
    call = next(step for body in program.bodies for step in body.steps if step.get("call") == "SRT_DINT")
    assert any(step[0] == 32 and int.from_bytes(step[2:4]) == call["ob"] for step in steps)


def test_events_from_outside() -> None:
    """They come before the bodies, in the order of their times; a duration has become a date."""
    outside: list[dict[str, object]] = [
        {"after": 3000, "event": "stop"},
        {"after": 1000, "event": "clock", "by": -60_000},
        {"after": 2000, "event": "interrupt", "ob": 40},
    ]
    bodies: list[object] = [{"ob": 1, "run": 1, "steps": [{"wait": 10}]}]

    def program(events: list[dict[str, object]], steps: list[object]) -> Program:
        return fitted(read_program(json.dumps(PROGRAM | {"outside": events, "bodies": steps})), "S7-300", OBS)

    content = encoded(program(outside, bodies))
    events = [struct.unpack_from(">BBhI8s", content, at) for at in (32, 48, 64)]
    assert [event[:4] for event in events] == [(253, 2, 0, 1000), (253, 40, 40, 2000), (253, 46, 0, 3000)]
    assert events[0][4].hex()[:12] == "261121055831", "05:59:30 and a second, less a minute"
    assert content[80] == 254
    set_by_step: list[object] = [{"ob": 1, "run": 1, "steps": [{"event": "clock", "to": "2026-11-21T06:00"}]}]
    assert "beside steps that set it" in lacks(program(outside, set_by_step))
    in_stop: dict[str, object] = {"after": 4000, "event": "clock", "by": 1000}
    assert lacks(program([*outside, in_stop], bodies)) == "no clock set in STOP"
    warm: dict[str, object] = {"after": 3500, "event": "restart", "type": "warm"}
    assert lacks(program([*outside, warm, in_stop], bodies)) == ""
    cold = [*outside, warm | {"type": "cold"}]
    assert lacks(program(cold, bodies)) == "no cold restart from outside"
    assert "no OB 100" in lacks(fitted(program([*outside, warm], bodies), "S7-300", OBS[:-1]))
    content = encoded(program([*outside, warm], bodies))
    assert happened(content[:28] + (32 + 16 * 3).to_bytes(4)) == 3
    assert restarted(3500, 4) == {28: (96).to_bytes(4), 12: (3500).to_bytes(4), 8: b"\0\4"}


def test_what_cannot_run() -> None:
    """Each with its reason."""
    reasons = {lacks(fitted(program, "S7-300", OBS)) for program in programs_of()}
    assert {"", "no step7 in the header", "no interrupt of OB 35 from outside", "no hold from outside"} <= reasons


def test_only_with_consent(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """A CPU is stopped only if that was agreed to."""
    assert cli.main(["kit", "run", "--cpu-address", "snap7://127.0.0.1:0:2"]) == 2
    assert "--stop-cpu-and-set-clock" in capsys.readouterr().err
    assert cli.main(["kit", "run", "--cpu-address", "snap7://127.0.0.1:0:2", "--stop-cpu-and-set-clock"]) == 2
    assert "--offer FILE with cpu" in capsys.readouterr().err
    offer = tmp_path / "offer.json"
    offer.write_text(json.dumps({"cpu": ["S7-300"], "obs": OBS}))
    given = ["kit", "run", "--stop-cpu-and-set-clock", "--offer", str(offer), "--port", "9", "--cpu-address"]
    for address, found in ("plc", "an address snap7://"), ("snap7://127.0.0.1:0:2", "an answer of the CPU"):
        assert cli.main([*given, address]) == 2
        assert found in capsys.readouterr().err
    assert cli.main(["kit", "run"]) == 2
    assert "either COMMAND" in capsys.readouterr().err
