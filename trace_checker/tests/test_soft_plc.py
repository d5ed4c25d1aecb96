"""The soft PLC's logs, right and with deliberate faults, judged by the real engine."""

import os
import shlex
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from s7check import cli
from s7check.judging.verdict import Report

FOLDER = Path(cli.__file__).parents[2] / "examples" / "soft_plc"
SCENARIOS = sorted(path.stem for path in (FOLDER / "scenarios").glob("*.scn"))
REAL_TIME = "real_time"
"""The scenario that takes as long as it says."""

FAMILIES = ["S7-300", "S7-400", "318"]

FAULTS = {
    "airt-flag": "nested_delay",
    "airt-keeps-count": "--random 1 --events 300 --cpu S7-300",
    "airt-en-all": "nested_delay",
    "airt-en-zero": "nested_delay",
    "airt-loses": "nested_delay",
    "airt-ignores-ob80": "--random 1 --events 300 --cpu S7-300",
    "hourly-daily": "clock_onto_start_point",
    "month-end-30": "month_ends",
    "leap-century": "return_values",
    "monthly-31": "month_ends",
    "keep-seconds": "month_ends",
    "set-activates": "return_values",
    "set-past-all": "month_ends",
    "act-no-80a1": "return_values",
    "can-keeps-date": "cancelled_while_pending",
    "can-keeps-request": "cancelled_while_pending",
    "once-stays": "clock_over_start_point",
    "qry-no-loaded": "blocked",
    "no-ob80-skip": "blocked",
    "no-catch-up": "blocked",
    "catch-up-per-period": "blocked",
    "catch-up-first": "blocked",
    "skip-mask": "blocked",
    "skip-time": "blocked",
    "repeat-s7-400": "clock_over_start_point",
    "no-repeat-s7-300": "s7_300_clock_back",
    "overlap-silent": "diagnostic_buffer",
    "overlap-lost": "diagnostic_buffer",
    "equal-preempts": "blocked",
    "lifo": "shared_classes",
    "missing-ob80-runs-on": "diagnostic_buffer",
    "missing-ob85-runs-on": "diagnostic_buffer",
    "missing-silent": "blocked",
    "restart-keeps-sfc": "diagnostic_buffer",
    "restart-no-step7": "blocked",
    "startup-runs-tod": "diagnostic_buffer",
    "dint-zero": "--random 1 --events 300 --cpu S7-300",
    "dint-no-limit": "delay_interrupts",
    "dint-coarse": "--random 1 --events 300 --cpu S7-300",
    "dint-no-retrigger": "delay_interrupts",
    "dint-keeps-sign": "delay_interrupts",
    "dint-info-rest": "blocked",
    "dint-can-any": "delay_interrupts",
    "dint-can-keeps": "delay_interrupts",
    "dint-can-withdraws": "--random 49 --events 400 --cpu S7-400",
    "dint-waiting-active": "delay_interrupts",
    "dint-overlap-silent": "delay_interrupts",
    "dint-overlap-dtime": "delay_interrupts",
    "dint-follows-clock": "delay_interrupts",
    "dint-runs-in-hold": "delay_interrupts",
    "dint-survives": "--random 3 --events 300 --cpu S7-300",
    "startup-runs-dint": "delay_interrupts",
    "irt-queues": "blocked",
    "irt-counts": "--random 5 --events 300 --cpu S7-400",
    "irt-survives": "--random 4 --events 300 --cpu S7-300",
    "irt-ends-with-ob": "blocked",
    "irt-missing-reacts": "blocked",
    "irt-stops-80": "--random 50 --events 400 --cpu S7-400 --diag",
    "irt-drops-queued": "--random 2 --events 300 --cpu S7-300",
    "irt-job-stays": "blocked",
    "irt-no-status": "blocked",
    "irt-class-first": "blocked",
    "irt-no-class-70": "--random 5 --events 300 --cpu S7-400",
    "irt-no-8x": "blocked",
    "irt-all-needs-0": "--random 1 --events 300 --cpu S7-300",
    "irt-bad-mode": "--random 1 --events 300 --cpu S7-300",
    "irt-ob1": "--random 50 --events 400 --cpu S7-300",
    "en-irt-8x": "blocked",
    "en-irt-blocks": "blocked",
    "en-irt-8080": "blocked",
    "diag-no-5380": "blocked",
    "diag-5380-each": "blocked",
    "diag-8x-entered": "blocked",
    "diag-0x-silent": "blocked",
    "diag-en-silent": "--random 7 --events 400 --cpu S7-400 --diag",
    "diag-no-stop": "diagnostic_buffer",
    "diag-3505": "diagnostic_buffer",
    "priority-default": "shared_classes",
    "startup-class": "--random 4 --events 300 --cpu S7-300",
    "overflow-class": "diagnostic_buffer",
    "async-runs-on": "--random 3 --events 300 --cpu S7-400",
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
    """What a random program shows is explained, to its last event; entries too, with every second seed."""
    report = judge(run(f"--random {seed} --events 400 --cpu {family}", *(["--diag"] if seed % 2 else [])))
    assert report.verdict == "accepted", report
    assert report.events >= 400


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
