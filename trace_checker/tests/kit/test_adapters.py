"""The adapters that the project ships run the kit's programs."""

import json
import sys
from contextlib import suppress
from pathlib import Path
from unittest import SkipTest

import pytest

from s7check.cli import main
from s7check.engine import pool
from s7check.kit.collection import programs_of
from s7check.kit.suite import Kit, NotKeptError
from s7check.simulating.simulation import simulated
from tests.test_soft_plc import program as soft_plc

__all__ = ["soft_plc"]

ADAPTERS = Path(__file__).parents[3] / "examples" / "adapters"
AWLSIM = Path(__file__).parents[3] / "build" / "awlsim"


def results(folder: Path, *arguments: str) -> list[dict[str, object]]:
    """The results of a run of the kit."""
    output = folder / "result.json"
    main(["kit", "run", "--output", str(output), "--timeout", "30", *arguments])
    programs: list[dict[str, object]] = json.loads(output.read_text(encoding="utf-8"))["programs"]
    return programs


def test_template(tmp_path: Path) -> None:
    """Short enough to be copied; what the toy CPU does right passes, its mistake fails for its requirement."""
    template = ADAPTERS / "template.py"
    assert len(template.read_text(encoding="utf-8").splitlines()) <= 100
    offer = str(ADAPTERS / "toy_offer.json")
    command = ["--offer", offer, "--only", "AIRT-07-*", "--only", "DINT-16-*", "--", sys.executable, str(template)]
    found = results(tmp_path, *command)
    assert {result["status"] for result in found if str(result["name"]).startswith("AIRT")} >= {"passed"}
    wrong = {(one["status"], *one["deciding"]) for one in found if one["deciding"]}  # type: ignore[misc]
    assert wrong == {("passed under another reading", "DINT-16")}


@pytest.mark.skipif(not AWLSIM.is_dir(), reason="awlsim is not there; `make test-checker` installs it")
def test_awlsim(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """AWL runs in a simulator that others have written: calls and operands take their way through it."""
    monkeypatch.setenv("PYTHONPATH", str(AWLSIM))
    names = ["AIRT-nesting-002", "DINT-calls-OB-1-S7-300", "DINT-beside-20-21-cancel", "DINT-beside-21-20-start"]
    names += ["TINT-39-every-field-at-its-limit", "TINT-19-end-of-month-on-feb-28-of-a-leap-year"]
    names += ["CLK-05-skip-without-ob-80-stops", "CLK-02-clock-4"]
    names += ["OBS-56-log-begins-in-startup", "IRT-01-blocked-missing-obs-do-not-stop"]
    only = [f"--only={name}" for name in names]
    adapter = str(ADAPTERS / "awlsim_adapter.py")
    found = results(tmp_path, "--offer", str(ADAPTERS / "awlsim_offer.json"), *only, "--", sys.executable, adapter)
    assert {result["name"]: result["status"] for result in found} == dict.fromkeys(names, "passed")


def test_soft_plc(soft_plc: str, tmp_path: Path) -> None:
    """A sample of the programs of each area passes, also those that are skipped only for what this CPU lacks."""
    names = [program.name for program in programs_of()][::40]
    found = results(tmp_path, *(f"--only={name}" for name in names), "--", soft_plc, "--kit")
    assert len(found) == len(names)
    assert [result for result in found if result["status"] not in ("passed", "skipped")] == []
    assert sum(result["status"] == "passed" for result in found) > len(names) * 0.9


HEADER_ONLY = """
import json, sys
for line in sys.stdin:
    header = json.loads(line)["header"]
    names = ("cpu", "obs", "clock", "mode", "cycle", "priority", "step7")
    own = {name: header[name] for name in names if name in header}
    print(json.dumps({"format": "s7-interrupt-log/1", "latency_ms": 0} | own))
    print(json.dumps({"event": "done"}), flush=True)
"""

HALF = """
import json, subprocess, sys
cpu = subprocess.Popen([sys.argv[1], "--kit", "--up"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
for line in sys.stdin.buffer:
    cpu.stdin.write(line)
    cpu.stdin.flush()
    half, lines = json.loads(line)["duration"] // 2, []
    while not lines or lines[-1].get("event") not in ("done", "skip"):
        lines.append(json.loads(cpu.stdout.readline()))
    end = lines.pop()
    kept = [one for one in lines if one.get("up", 0) <= half]
    last = end if end["event"] == "skip" else {"event": "done"}
    print("".join(json.dumps(one) + "\\n" for one in [*kept, last]), end="", flush=True)
"""


def test_silence_does_not_pass(tmp_path: Path) -> None:
    """An adapter that prints the header alone passes no program on which a CPU has anything to do."""
    names = [program.name for program in programs_of()][::12]
    found = results(tmp_path, *(f"--only={name}" for name in names), "--", sys.executable, "-c", HEADER_ONLY)
    passed = {result["name"] for result in found if result["status"] == "passed"}
    assert len(found) == len(names)
    assert len(passed) < len(names) / 50
    with pool.engine() as engine:
        for program in programs_of():
            if program.name in passed:
                assert simulated(engine, program)[1:] == [], program.name


def test_half_of_the_time_does_not_pass(soft_plc: str, tmp_path: Path) -> None:
    """A CPU that falls silent after half of a program passes where nothing comes in the other half."""
    # Long programs cost seconds each and show no more. No failure is reduced here.
    names = [program.name for program in programs_of() if len(program.line()) < 1_500][::80]
    kit = Kit([sys.executable, "-c", HALF, soft_plc], only=names)
    passed = set()
    for name in names:
        with suppress(NotKeptError, SkipTest):
            passed.add(kit.run(name).name)
    logs = tmp_path / "logs"
    results(tmp_path, *(f"--only={name}" for name in passed), "--logs", str(logs), "--", soft_plc, "--kit", "--up")
    assert 0 < len(passed) < len(names) / 2
    for program in programs_of():
        if program.name in passed:
            lines = map(json.loads, (logs / f"{program.name}.ndjson").read_text(encoding="utf-8").splitlines())
            # Beside what may lag behind its wait by 100 ms and the latency of 10 ms.
            other_half = range(program.duration // 2 + 1, program.duration - 110)
            late = [line for line in lines if line.get("up", 0) in other_half]
            # A cycle of OB 1 lasts as long as the implementation likes, and a `state` line need not come.
            assert [line for line in late if line.get("ob") != 1 and line["event"] != "state"] == [], program.name


def test_silence_about_what_may_be_silent(soft_plc: str, tmp_path: Path) -> None:
    """The soft PLC passes every program whose end is new: small steps of the clock, PERIODs, months in a row."""
    only = ("--only=CLK-step-*", "--only=TINT-period-*", "--only=TINT-months-*", "--only=OBS-4*")
    found = results(tmp_path, *only, "--", soft_plc, "--kit")
    assert {result["status"] for result in found} <= {"passed", "skipped"}
