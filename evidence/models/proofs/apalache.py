"""Finding Apalache, running it once, and reading its output."""

from __future__ import annotations

import os
import re
import shutil
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from evidence.common.processes import Processes

HOME_VARIABLE = "APALACHE_HOME"
JVM_ARGUMENTS = {
    "JVM_ARGS": "-Xmx5g -XX:TieredStopAtLevel=1 -XX:+AutoCreateSharedArchive -XX:SharedArchiveFile=../apalache.jsa",
    "JVM_GC_ARGS": "-XX:+UseSerialGC",
}
"""By the variables that apalache-mc reads. Most of a run is short work on a large module: code that is compiled better,
and more collectors, cost more time. The first run leaves Apalache's classes in an archive, beside the folders of the
queries; the next ones begin a second earlier. Java makes it anew where it does not fit."""
PROGRAM = "apalache-mc"

Outcome = Literal["holds", "violated", "nothing checked", "failed", "timeout", "not asked"]

_MADE = re.compile(
    r"Producing verification conditions from the invariant (\w+).*\n.*VCGen produced (\d+) verification condition"
)
_CHECKING = re.compile(r"^State \d+: Checking (\d+) (?:state|action) invariants", re.MULTILINE)
_HOLDS = re.compile(r"^State \d+: ((?:state|action) invariant \d+) holds\.", re.MULTILINE)
_TRANSITIONS = re.compile(r"Found (\d+) transitions")
_DISABLED = re.compile(r"^Step \d+: Transition #\d+ is disabled", re.MULTILINE)
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
    """What Apalache's output says: `checked` is how often it names a condition as holding.

    It divides an action into transitions, and checks the conditions after each of the `taken` ones: those that it does
    not name as disabled; but not formulas that the transition cannot change. `detail` says why the outcome is not
    "holds"; `trace` is the file of the counterexample.
    """

    outcome: Outcome
    checked: int
    detail: str = ""
    trace: str = ""
    taken: int = 0


@dataclass(frozen=True)
class ApalacheRun:
    """A run: its answer, wall time in seconds, the most memory it had in MB, its whole output."""

    answer: Answer
    seconds: float
    megabytes: int
    output: str


def find_apalache() -> str:
    """apalache-mc in APALACHE_HOME/bin, else on PATH; it gets arguments for its JVM, if the environment has none.

    Raises `ApalacheMissingError`.
    """
    home = os.environ.get(HOME_VARIABLE)
    for variable, arguments in JVM_ARGUMENTS.items():
        os.environ.setdefault(variable, arguments)
    program = shutil.which(str(Path(home) / "bin" / PROGRAM) if home else PROGRAM)
    if program is None:
        raise ApalacheMissingError(
            f"not run: {PROGRAM} was not found (release 0.62.1, Java 21 or newer; put it on PATH or name its folder "
            f"in {HOME_VARIABLE})"
        )
    return program


def interpret(output: str, code: int, asked: Sequence[str]) -> Answer:
    """Read the output of runs, the last of them with this exit code, that were asked to check these formulas.

    It counts as "holds" only where Apalache made conditions of every formula asked, could take a step, and says of
    every condition, and of all that it announced after a transition, that they hold: a filter that lets none through, a
    formula that got lost, and an action that can take no step end with exit code 0 too.
    """
    held = _HOLDS.findall(output)
    if violated := _VIOLATED.search(output):
        trace = _TRACE.search(output)
        return Answer("violated", len(held), f"{violated[1]} is violated", trace[1] if trace else "")
    if code != 0:
        told: list[str] = _ERROR.findall(output)[:1] or output.strip().splitlines()[-1:] or ["no message"]
        return Answer("failed", len(held), f"exit code {code}: {told[0].strip()}")
    made = {name: int(number) for name, number in _MADE.findall(output)}
    if lacking := [name for name in asked if not made.get(name)]:
        return Answer("nothing checked", len(held), f"no condition was made of {', '.join(lacking)}")
    announced = sum(map(int, _CHECKING.findall(output)))
    conditions = sum(made.values())
    if len(set(held)) != conditions or len(held) != announced:
        said = f"{len(set(held))} of {conditions} conditions were checked, {len(held)} times of {announced} announced"
        return Answer("nothing checked", len(held), said)
    transitions = _TRANSITIONS.search(output)
    taken = int(transitions[1]) - len(_DISABLED.findall(output)) if transitions else 0
    if taken < 1:
        return Answer("nothing checked", len(held), "no step can be taken")
    return Answer("holds", len(held), taken=taken)


def version(output: str) -> str:
    """The version that a run's output names; empty where it names none."""
    found = _VERSION.search(output)
    return found[1] if found else ""


def run(
    program: str,
    arguments: Sequence[Sequence[str]],
    asked: Sequence[str],
    folder: Path,
    timeout: float,
    processes: Processes,
) -> ApalacheRun:
    """Run Apalache once with each of the lists of arguments, one after the other, until a run does not succeed.

    The answer is that to all runs; `timeout` is for each, in seconds. Raises `InterruptedRunError` if the command is
    ending.
    """
    began = time.monotonic()
    output = ""
    megabytes = code = 0
    ended = False
    for some in arguments:
        process = processes.start([program, "check", f"--out-dir={folder / 'out'}", *some], folder)
        with processes.limited(process, timeout) as expired:
            assert process.stdout is not None
            output += process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            code = process.returncode = os.waitstatus_to_exitcode(status)
        megabytes = max(megabytes, usage.ru_maxrss // 1024)
        ended = expired.is_set()
        if ended or code != 0:
            break
    if ended:
        answer = Answer("timeout", len(_HOLDS.findall(output)), f"ended after {timeout:.0f} s")
    else:
        answer = interpret(output, code, asked)
    return ApalacheRun(answer, round(time.monotonic() - began, 1), megabytes, output)
