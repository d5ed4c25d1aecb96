"""The soft PLC's logs, right and with deliberate faults, judged by the real engine."""

import os
import re
import shlex
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from s7check import cli
from s7check.report.report import Report

FOLDER = Path(cli.__file__).parents[2] / "examples" / "soft_plc"
SCENARIOS = sorted(path.stem for path in (FOLDER / "scenarios").glob("*.json"))
REAL_TIME = "real_time"
"""The scenario that takes as long as it says."""

FAMILIES = ["S7-300", "S7-400", "318", "S7-1500"]

FAULTS = {
    "airt-flag": "nested_delay",
    "airt-keeps-count": "--random 1 --events 300 --cpu S7-300 --up",
    "airt-en-all": "nested_delay",
    "airt-en-zero": "nested_delay",
    "airt-loses": "interrupt_masks",
    "airt-ignores-ob80": "--random 1 --events 300 --cpu S7-300 --up",
    "hourly-daily": "clock_onto_start_point",
    "month-end-30": "month_ends",
    "leap-century": "return_values",
    "monthly-31": "month_ends",
    "keep-seconds": "month_ends",
    "set-activates": "return_values",
    "set-past-all": "dispatch_order",
    "act-no-80a1": "return_values",
    "can-keeps-date": "cancelled_while_pending",
    "can-keeps-request": "cancelled_while_pending",
    "once-stays": "once_and_clock_back",
    "qry-no-loaded": "once_and_clock_back",
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
    "equal-preempts": "state_of_obs",
    "lifo": "dispatch_order",
    "missing-ob80-runs-on": "diagnostic_buffer",
    "missing-ob85-runs-on": "diagnostic_buffer",
    "missing-silent": "blocked",
    "restart-keeps-sfc": "dispatch_order",
    "restart-no-step7": "state_of_obs",
    "startup-runs-tod": "state_of_obs",
    "dint-zero": "--random 15 --events 300 --cpu S7-300 --up",
    "dint-no-limit": "delay_interrupts",
    "dint-coarse": "--random 1 --events 300 --cpu S7-300 --up",
    "dint-no-retrigger": "delay_interrupts",
    "dint-keeps-sign": "delay_interrupts",
    "dint-info-rest": "dispatch_order",
    "dint-can-any": "waiting_delay",
    "dint-can-keeps": "waiting_delay",
    "dint-can-runs": "waiting_delay",
    "dint-can-loses": "waiting_delay",
    "dint-can-mixed": "waiting_delay",
    "dint-running-active": "waiting_delay",
    "dint-overlap-silent": "delay_interrupts",
    "dint-overlap-dtime": "delay_interrupts",
    "dint-follows-clock": "delay_interrupts",
    "dint-runs-in-hold": "state_of_obs",
    "dint-survives": "--random 22 --events 300 --cpu S7-400 --up",
    "startup-runs-dint": "dispatch_order",
    "irt-queues": "interrupt_masks",
    "irt-counts": "interrupt_masks",
    "irt-survives": "--random 22 --events 300 --cpu S7-400 --up",
    "irt-ends-with-ob": "interrupt_masks",
    "irt-missing-reacts": "interrupt_masks",
    "irt-stops-80": "interrupt_masks",
    "irt-drops-queued": "interrupt_masks",
    "irt-job-stays": "blocked",
    "irt-no-status": "blocked",
    "irt-class-first": "interrupt_masks",
    "irt-no-class-70": "interrupt_masks",
    "irt-no-8x": "interrupt_masks",
    "irt-all-needs-0": "interrupt_masks",
    "irt-bad-mode": "interrupt_masks",
    "irt-ob1": "interrupt_masks",
    "en-irt-8x": "interrupt_masks",
    "en-irt-blocks": "interrupt_masks",
    "en-irt-8080": "interrupt_masks",
    "diag-no-5380": "interrupt_masks",
    "diag-5380-each": "interrupt_masks",
    "diag-8x-entered": "interrupt_masks",
    "diag-0x-silent": "interrupt_masks",
    "diag-en-silent": "interrupt_masks",
    "diag-no-stop": "diagnostic_buffer",
    "diag-3505": "diagnostic_buffer",
    "priority-default": "dispatch_order",
    "startup-class": "--random 2 --events 300 --cpu S7-400 --up",
    "overflow-class": "diagnostic_buffer",
    "async-runs-on": "--random 35 --events 300 --cpu S7-400 --up",
    "fifo": "dispatch_order",
    "once-runs-twice": "once_and_clock_back",
    "back-blocks-new": "--random 2 --events 300 --cpu S7-400 --up",
    "clock-runs-away": "--random 1 --events 300 --cpu S7-300 --up",
    "overlap-runs-each": "due_while_running",
    "skip-as-interrupt": "blocked",
    "stop-cause": "dispatch_order",
    "startup-time": "dispatch_order",
    "state-active": "state_of_obs",
    "state-blocked": "state_of_obs",
    "state-loaded": "state_of_obs",
    "state-entries": "state_of_obs",
    "state-left": "state_of_obs",
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
        arguments = [str(FOLDER / "scenarios" / f"{what}.json")] if what in SCENARIOS else what.split()
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
    """What a random program shows is explained, to its last event; with every second seed entries and states too."""
    report = judge(run(f"--random {seed} --events 400 --cpu {family}", *(["--diag", "--state"] if seed % 2 else [])))
    assert report.verdict == "accepted", report
    assert report.events >= 400


def choices(program: str) -> list[str]:
    """NAME=VALUE of both values of every choice."""
    text = subprocess.run([program, "--choose", "help"], check=True, capture_output=True, text=True).stdout
    both = re.findall(r"^ +(\S+) *=(\w+) or (\w+):", text, re.MULTILINE)
    assert len(both) == len(text.splitlines())
    return [f"{name}={value}" for name, *values in both for value in values]


def test_choices(program: str, run: Run, judge: Callable[[Path], Report]) -> None:
    """Whatever is chosen where the requirements leave it open, the log is explained."""
    for index, choice in enumerate(choices(program)):
        family = FAMILIES[index % len(FAMILIES)]
        for arguments in ("waiting_delay", "once_and_clock_back", f"--random {index} --events 200 --cpu {family}"):
            report = judge(run(arguments, "--choose", choice))
            assert report.verdict == "accepted", (choice, report)


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
