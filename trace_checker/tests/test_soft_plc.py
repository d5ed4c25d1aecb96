"""The soft PLC's logs, right and with deliberate faults, judged by the real engine."""

import os
import shlex
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from trace_checker import cli
from trace_checker.verdict import Report

FOLDER = Path(cli.__file__).parents[1] / "examples" / "soft_plc"
SCENARIOS = sorted(path.stem for path in (FOLDER / "scenarios").glob("*.scn"))
REAL_TIME = "real_time"
"""The scenario that takes as long as it says."""

FAMILIES = ["S7-300", "S7-400", "318"]

FAULTS = {
    "airt-flag": "nested_delay",
    "airt-keeps-count": "--random 2 --events 300 --cpu S7-300",
    "airt-en-all": "nested_delay",
    "airt-en-zero": "nested_delay",
    "airt-loses": "nested_delay",
    "airt-ignores-ob80": "--random 3 --events 300 --cpu S7-300",
    "hourly-daily": "clock_onto_start_point",
    "month-end-30": "month_ends",
    "leap-century": "return_values",
    "monthly-31": "month_ends",
    "keep-seconds": "return_values",
    "set-activates": "return_values",
    "set-past-all": "restart_step7",
    "act-no-80a1": "return_values",
    "can-keeps-date": "cancelled_while_pending",
    "can-keeps-request": "cancelled_while_pending",
    "once-stays": "s7_300_clock_back",
    "qry-no-loaded": "cancelled_while_pending",
    "no-ob80-skip": "clock_over_start_point",
    "no-catch-up": "clock_over_start_point",
    "catch-up-per-period": "clock_over_start_point",
    "catch-up-first": "clock_over_start_point",
    "skip-mask": "clock_over_start_point",
    "skip-time": "clock_over_start_point",
    "repeat-s7-400": "clock_over_start_point",
    "no-repeat-s7-300": "s7_300_clock_back",
    "overlap-silent": "due_while_running",
    "overlap-lost": "due_while_running",
    "equal-preempts": "clock_over_start_point",
    "lifo": "--random 3 --events 300 --cpu S7-300",
    "missing-ob80-runs-on": "missing_ob",
    "missing-ob85-runs-on": "missing_ob",
    "missing-silent": "missing_ob",
    "restart-keeps-sfc": "restart_step7",
    "restart-no-step7": "restart_step7",
    "startup-runs-tod": "restart_step7",
}
"""A scenario, or arguments, in which the fault shows in the log; there is none that never shows."""

Run = Callable[..., Path]


@pytest.fixture(scope="module")
def program() -> str:
    """The soft PLC, built."""
    compiler = shlex.split(os.environ.get("CC", "cc"))[0]
    if shutil.which(compiler) is None:
        pytest.skip(f"there is no C compiler ({compiler})")
    subprocess.run(["make", "-C", str(FOLDER)], check=True, capture_output=True, timeout=300)
    return str(FOLDER / "build" / "soft_plc")


@pytest.fixture
def run(program: str, tmp_path: Path) -> Run:
    """A function that runs the soft PLC with a scenario or arguments, and returns the log."""

    def run(what: str, *options: str) -> Path:
        log = tmp_path / "log.ndjson"
        arguments = [str(FOLDER / "scenarios" / f"{what}.scn")] if what in SCENARIOS else what.split()
        subprocess.run([program, *options, *arguments, "-o", str(log)], check=True, timeout=60)
        return log

    return run


@pytest.mark.parametrize("scenario", [name for name in SCENARIOS if name != REAL_TIME])
def test_scenario(scenario: str, run: Run, judge: Callable[[Path], Report]) -> None:
    """What a scenario shows is explained."""
    report = judge(run(scenario))
    assert report.verdict == "accepted", report


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("seed", range(1, 9))
def test_random_program(seed: int, family: str, run: Run, judge: Callable[[Path], Report]) -> None:
    """What a random program shows is explained, to its last event."""
    report = judge(run(f"--random {seed} --events 400 --cpu {family}"))
    assert (report.verdict, report.events) == ("accepted", 400), report


def test_every_fault_is_tried(program: str) -> None:
    """The table has the faults that the soft PLC lists."""
    listed = subprocess.run([program, "--fault", "help"], check=True, capture_output=True, text=True).stdout
    assert [line.split()[0] for line in listed.splitlines()] == list(FAULTS)


@pytest.mark.parametrize(("fault", "what"), FAULTS.items(), ids=FAULTS.keys())
def test_fault_is_rejected(fault: str, what: str, run: Run, judge: Callable[[Path], Report]) -> None:
    """A log is rejected with the fault, for a requirement, and accepted without it."""
    report = judge(run(what))
    assert report.verdict == "accepted", report
    report = judge(run(what, "--fault", fault))
    assert report.verdict == "rejected", report
    assert report.requirements
