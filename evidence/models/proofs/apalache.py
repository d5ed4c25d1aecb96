"""Finding Apalache, running it once, and reading its output."""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import subprocess
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from pathlib import Path
from typing import Literal, NamedTuple, Self

from evidence.common.processes import InterruptedRunError, Processes

HOME_VARIABLE = "APALACHE_HOME"
_JVM = ("-Xmx5g", "-XX:+UseSerialGC")
"""Much of a run is short work on a large module; more collectors cost more time."""
PROGRAM = "apalache-mc"

Outcome = Literal["holds", "violated", "nothing checked", "failed", "timeout", "not asked"]

_MADE = re.compile(
    r"Producing verification conditions from the invariant (\w+).*\n.*VCGen produced (\d+) verification condition"
)
_CHECKING = re.compile(r"^State \d+: Checking (\d+) (?:state|action) invariants", re.MULTILINE)
_HOLDS = re.compile(r"^State \d+: ((?:state|action) invariant \d+) holds\.", re.MULTILINE)
_LATE = re.compile(r"^State \d+: ((?:state|action) invariant \d+) => TIMEOUT\.", re.MULTILINE)
_TRANSITIONS = re.compile(r"Found (\d+) transitions")
_DISABLED = re.compile(r"^Step \d+: Transition #\d+ is disabled", re.MULTILINE)
_VIOLATED = re.compile(r"^State \d+: ((?:state|action) invariant \d+) violated\.", re.MULTILINE)
_TRACE = re.compile(r"^Check the trace in: ([^,\s]+)", re.MULTILINE)
_ERROR = re.compile(r"^(.*\S)\s+E@\d\d:", re.MULTILINE)
_VERSION = re.compile(r"APALACHE version: (\S+)")
_EXIT = "@!@!@EXIT "
_MOST_RUNS = 25
"""After so many a process gives its memory back."""
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
    """Runs one after another: their outputs, the exit code of the last one, wall time in seconds, memory in MB.

    `expired` is the time after which the last one was ended, in seconds; 0 if it ended by itself.
    """

    outputs: tuple[str, ...]
    code: int
    expired: float
    seconds: float
    megabytes: int

    @property
    def output(self) -> str:
        """What all of them said."""
        return "".join(self.outputs)


def find_apalache() -> list[str]:
    """The command that runs Apalache for each line of its input: of the release in APALACHE_HOME, else on PATH.

    Raises `ApalacheMissingError`.
    """
    home = os.environ.get(HOME_VARIABLE)
    program = shutil.which(str(Path(home) / "bin" / PROGRAM) if home else PROGRAM)
    jar = Path(program).resolve().parents[1] / "lib" / "apalache.jar" if program else None
    if jar is None or not jar.is_file():
        raise ApalacheMissingError(
            f"not run: {PROGRAM} was not found (release 0.62.1, Java 21 or newer; put it on PATH or name its folder "
            f"in {HOME_VARIABLE})"
        )
    return ["java", *_JVM, "-cp", str(jar), str(Path(__file__).with_name("Runs.java"))]


def answer(run: ApalacheRun, read: Callable[[str, int], Answer]) -> Answer:
    """What `read` says of the output and the exit code, unless the run was ended."""
    if run.expired:
        return Answer("timeout", len(_HOLDS.findall(run.output)), f"ended after {run.expired:.0f} s")
    return read(run.output, run.code)


def interpret(output: str, code: int, asked: Sequence[str]) -> Answer:
    """Read the output of runs, the last of them with this exit code, that were asked to check these formulas.

    It counts as "holds" only where Apalache made conditions of every formula asked, could take a step, and says of
    every condition, and of all that it announced after a transition, that they hold or took too long (`late`): a filter
    that lets none through, a formula that got lost, and an action that can take no step end with exit code 0 too.
    """
    held = _HOLDS.findall(output)
    if violated := _VIOLATED.search(output):
        trace = _TRACE.search(output)
        return Answer("violated", len(held), f"{violated[1]} is violated", trace[1] if trace else "")
    if code != 0:
        told: list[str] = _ERROR.findall(output)[:1] or output.strip().splitlines()[-1:] or ["no message"]
        return Answer("failed", len(held), f"exit code {code}: {told[0].strip()}")
    made = _made(output)
    if lacking := [name for name in asked if not made.get(name)]:
        return Answer("nothing checked", len(held), f"no condition was made of {', '.join(lacking)}")
    announced = sum(map(int, _CHECKING.findall(output)))
    conditions = sum(made.values())
    said = held + _LATE.findall(output)
    if len(set(said)) != conditions or len(said) != announced:
        detail = f"{len(set(said))} of {conditions} conditions were checked, {len(said)} times of {announced} announced"
        return Answer("nothing checked", len(held), detail)
    transitions = _TRANSITIONS.search(output)
    taken = int(transitions[1]) - len(_DISABLED.findall(output)) if transitions else 0
    if taken < 1:
        return Answer("nothing checked", len(held), "no step can be taken")
    return Answer("holds", len(held), taken=taken)


class Late(NamedTuple):
    """A condition to which Z3 had no answer in time: of this formula, in this one of several runs."""

    formula: str
    condition: str
    """As Apalache calls it where the formula is asked alone, such as "state invariant 2"."""
    run: int


def late(outputs: Sequence[str]) -> list[Late]:
    """The conditions that took longer than the limit, in the outputs of runs that were asked for the same formulas.

    Apalache numbers the conditions of each formula from 0, sorts those of all formulas about states by these numbers,
    read as words, and calls each by its place in this order; those about steps likewise. Formulas about states have to
    come first.
    """
    made = _made("".join(outputs))
    found = [(run, label) for run, output in enumerate(outputs) for label in dict.fromkeys(_LATE.findall(output))]
    said = {label for output in outputs for label in [*_HOLDS.findall(output), *_LATE.findall(output)]}
    states = sum(label.startswith("state") for label in said)
    ends = list(accumulate(made.values(), initial=0))
    assert not found or states in ends, "formulas about states do not come first"
    names = list(made)
    first = ends.index(states) if found else 0
    ordered = {"state": _in_order(made, names[:first]), "action": _in_order(made, names[first:])}
    result = []
    for run, label in found:
        kind, number = label.split(" invariant ")
        name, at = ordered[kind][int(number)]
        alone = _in_order(made, [name]).index((name, at))
        result.append(Late(name, f"{kind} invariant {alone}", run))
    return result


def _in_order(made: Mapping[str, int], names: Iterable[str]) -> list[tuple[str, int]]:
    """The conditions of these formulas as Apalache sorts them."""
    return sorted(((name, at) for name in names for at in range(made[name])), key=lambda one: str(one[1]))


def settled(output: str, code: int, condition: str) -> Answer:
    """Read the output of a run, with this exit code, that was asked to check this condition alone."""
    held = _HOLDS.findall(output)
    if code != 0:
        return interpret(output, code, [])
    if _LATE.search(output):
        return Answer("timeout", len(held), f"Z3 had no answer in time about {condition}")
    announced = sum(map(int, _CHECKING.findall(output)))
    if not announced or held != [condition] * announced:
        return Answer("nothing checked", len(held), f"{condition} holds {len(held)} times of {announced} announced")
    return Answer("holds", len(held), taken=len(held))


def _made(output: str) -> dict[str, int]:
    """The formulas in the order of the command, each with the number of its conditions."""
    return {name: int(number) for name, number in _MADE.findall(output)}


def version(output: str) -> str:
    """The version that a run's output names; empty where it names none."""
    found = _VERSION.search(output)
    return found[1] if found else ""


class Apalache:
    """Processes that stay for the next run, since most of a run in a new one is code that is not compiled yet.

    `command` begins one. Safe to use from several threads. Raises `InterruptedRunError` where the harness is ending.
    The end of the block is that of the processes.
    """

    def __init__(self, command: Sequence[str], processes: Processes) -> None:
        """Start with none."""
        self._command = command
        self._processes = processes
        self._idle: list[_Resident] = []

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        for resident in self._idle:
            self._processes.end(resident.process)

    def run(self, arguments: Sequence[Sequence[str]], folder: Path, timeout: float) -> ApalacheRun:
        """Run ``check`` with each of the lists of arguments, one after the other, until a run does not succeed.

        `folder` gets what Apalache writes; `timeout` is for each run, in seconds.
        """
        began = time.monotonic()
        outputs: list[str] = []
        megabytes = code = 0
        ended = False
        for some in arguments:
            try:
                resident = self._idle.pop()
            except IndexError:
                resident = _Resident(self._command, self._processes, folder)
            with self._processes.watched(resident.process, timeout) as expired:
                said, code, most = resident.check([f"--out-dir={folder / 'out'}", *some])
            if resident.may_stay:
                self._idle.append(resident)
            else:
                self._processes.end(resident.process)
            if self._processes.closed:
                raise InterruptedRunError
            outputs.append(said)
            megabytes = max(megabytes, most)
            ended = expired.is_set()
            if ended or code != 0:
                break
        seconds = round(time.monotonic() - began, 1)
        return ApalacheRun(tuple(outputs), code, timeout if ended else 0, seconds, megabytes)


class _Resident:
    """A process of Apalache with a folder for its temporary files: two would be in each other's way."""

    def __init__(self, command: Sequence[str], processes: Processes, folder: Path) -> None:
        options = [f"-Djava.io.tmpdir={folder}"] if command[0] == "java" else []
        self.process = processes.start([command[0], *options, *command[1:]], folder, subprocess.PIPE)
        self._left = _MOST_RUNS
        self.may_stay = True

    def check(self, arguments: Sequence[str]) -> tuple[str, int, int]:
        """The output of a run, its exit code, and the most memory in MB that the process had in it."""
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        proc = Path("/proc", str(self.process.pid))
        output: list[str] = []
        code = None
        with contextlib.suppress(BrokenPipeError):
            (proc / "clear_refs").write_text("5")  # the peak is counted anew
            self.process.stdin.write("\t".join(["check", *arguments]) + "\n")
            self.process.stdin.flush()
        for line in self.process.stdout:
            if line.startswith(_EXIT):
                code = int(line.removeprefix(_EXIT))
                break
            output.append(line)
        self._left -= 1
        self.may_stay = code is not None and self._left > 0
        if code is None:
            return "".join(output), self.process.wait() or 1, 0
        peak = re.search(r"VmHWM:\s*(\d+) kB", (proc / "status").read_text())
        return "".join(output), code, int(peak[1]) // 1024 if peak else 0
