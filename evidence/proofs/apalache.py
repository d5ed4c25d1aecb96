"""Finding Apalache, running it once, and reading what it says."""

from __future__ import annotations

import os
import re
import shutil
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from evidence.common.processes import InterruptedRunError, Processes, kill

HOME_VARIABLE = "APALACHE_HOME"
PROGRAM = "apalache-mc"

Outcome = Literal["holds", "violated", "nothing checked", "failed", "timeout"]

_MADE = re.compile(
    r"Producing verification conditions from the invariant (\w+).*\n.*VCGen produced (\d+) verification condition"
)
_HOLDS = re.compile(r"^State \d+: ((?:state|action) invariant \d+) holds\.", re.MULTILINE)
_VIOLATED = re.compile(r"^State \d+: ((?:state|action) invariant \d+) violated\.", re.MULTILINE)
_TRACE = re.compile(r"^Check the trace in: ([^,\s]+)", re.MULTILINE)
_ERROR = re.compile(r"^(.*\S)\s+E@\d\d:", re.MULTILINE)
_VERSION = re.compile(r"APALACHE version: (\S+)")
VIOLATION = 12
"""Apalache's exit code for a counterexample."""


class ApalacheMissingError(RuntimeError):
    """apalache-mc was not found."""


@dataclass(frozen=True)
class Answer:
    """What Apalache's output says: `checked` is the number of conditions that it names as holding.

    `detail` says why the outcome is not "holds"; `trace` is the file of the counterexample.
    """

    outcome: Outcome
    checked: int
    detail: str = ""
    trace: str = ""


@dataclass(frozen=True)
class ApalacheRun:
    """A run: its answer, wall time in seconds, the most memory it had in MB, its whole output."""

    answer: Answer
    seconds: float
    megabytes: int
    output: str


def find_apalache() -> str:
    """apalache-mc in APALACHE_HOME/bin, else on PATH. Raises `ApalacheMissingError`."""
    home = os.environ.get(HOME_VARIABLE)
    program = shutil.which(str(Path(home) / "bin" / PROGRAM) if home else PROGRAM)
    if program is None:
        raise ApalacheMissingError(
            f"not run: {PROGRAM} was not found (release 0.62.1, Java 21 or newer; put it on PATH or name its folder "
            f"in {HOME_VARIABLE})"
        )
    return program


def interpret(output: str, code: int, asked: Sequence[str]) -> Answer:
    """Read the output of a run with this exit code that was asked to check these formulas.

    It counts as "holds" only where Apalache made conditions of every formula asked and says of every condition that it
    holds: a filter that lets none through, or a formula that got lost, ends with exit code 0 too.
    """
    held = set(_HOLDS.findall(output))
    if violated := _VIOLATED.search(output):
        trace = _TRACE.search(output)
        return Answer("violated", len(held), f"{violated[1]} is violated", trace[1] if trace else "")
    if code != 0:
        errors = _ERROR.findall(output)
        return Answer("failed", len(held), f"exit code {code}: {errors[0] if errors else 'no message'}")
    made = {name: int(number) for name, number in _MADE.findall(output)}
    lacking = [name for name in asked if not made.get(name)]
    expected = sum(made.values())
    if lacking:
        return Answer("nothing checked", len(held), f"no condition was made of {', '.join(lacking)}")
    if len(held) != expected or not held:
        return Answer("nothing checked", len(held), f"{len(held)} of {expected} conditions were checked")
    return Answer("holds", len(held))


def version(output: str) -> str:
    """The version that a run's output names; empty where it names none."""
    found = _VERSION.search(output)
    return found[1] if found else ""


def run(
    program: str, arguments: Sequence[str], asked: Sequence[str], folder: Path, timeout: float, processes: Processes
) -> ApalacheRun:
    """Run Apalache once. Raises `InterruptedRunError` if the command is ending."""
    began = time.monotonic()
    process = processes.start([program, "check", f"--out-dir={folder / 'out'}", *arguments], folder)
    expired = threading.Event()

    def expire() -> None:
        expired.set()
        kill(process)

    watchdog = threading.Timer(timeout, expire)
    watchdog.daemon = True
    watchdog.start()
    try:
        assert process.stdout is not None
        output = process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    finally:
        watchdog.cancel()
        processes.end(process)
    if processes.closed:
        raise InterruptedRunError
    if expired.is_set():
        answer = Answer("timeout", len(set(_HOLDS.findall(output))), f"ended after {timeout:.0f} s")
    else:
        answer = interpret(output, process.returncode, asked)
    return ApalacheRun(answer, round(time.monotonic() - began, 1), usage.ru_maxrss // 1024, output)
