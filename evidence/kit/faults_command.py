"""``s7spec kit faults``: the kit against the deliberate faults of the soft PLC, known and held out."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import click

from evidence.common import soft_plc
from evidence.common.checkout import SOFT_PLC, SOFT_PLC_PROGRAM
from evidence.common.console import plain
from evidence.common.options import json_option, write_json
from evidence.common.processes import Processes
from evidence.common.session import session
from s7check.api import check
from s7check.engine.command import EngineError
from s7check.kit.adapter import AdapterError, Ran
from s7check.kit.collection import programs_of
from s7check.kit.program import Program

HELD_OUT = SOFT_PLC / "held_out"
NOT_FOUND = 1

_LONG = 100
"""Lines of a log; the longer ones have 99 % of all lines."""


@dataclass(frozen=True)
class Fault:
    """A fault, the command and the options that have it, and whether it is held out from the kit."""

    name: str
    command: str
    options: tuple[str, ...]
    held_out: bool


@dataclass(frozen=True)
class Found:
    """How a fault shows: in the first ``program`` whose log is rejected, by ``requirements`` or by a ``failure``.

    Of the programs that were run, ``differ`` have another log than without the fault; ``judged`` were looked at.
    """

    fault: Fault
    differ: int
    judged: int
    program: str = ""
    requirements: tuple[str, ...] = ()
    failure: str = ""


@click.command(name="faults", short_help="Does the kit find the faults of the soft PLC?")
@json_option
@click.argument("names", nargs=-1, metavar="[FAULT]...")
def faults_command(json_path: Path | None, names: tuple[str, ...]) -> int:
    """Run the kit on the soft PLC with each of its faults, or the named ones.

    Logs that are those of the faultless soft PLC tell nothing; of the others the first rejected one counts. Programs
    with long logs are run for a fault that the others do not find.
    """
    with session(Processes(), (ValueError, OSError), (AdapterError, EngineError, _BuildError)) as console:
        chosen = _chosen(names)
        programs = programs_of()
        usual = list(zip(programs, soft_plc.run(programs), strict=True))
        parts = [[pair for pair in usual if (len(pair[1].log) > _LONG) == long] for long in (False, True)]
        found = []
        for fault in chosen:
            found.append(_look(fault, parts))
            plain(console, _line(found[-1]))
        missed = [one for one in found if not one.program]
        held_out = [one for one in found if one.fault.held_out]
        plain(
            console,
            f"{len(found) - len(missed)} of {len(found)} faults found; of {len(held_out)} held out "
            f"{sum(bool(one.program) for one in held_out)}",
        )
        write_json(json_path, {"faults": [_object(one) for one in found]})
    return NOT_FOUND if missed else 0


class _BuildError(RuntimeError):
    """The held-out faults cannot be built."""


def _chosen(names: Sequence[str]) -> list[Fault]:
    """The faults, of which those held out are built. Raises ValueError for a name that is none."""
    faults = {name: Fault(name, str(SOFT_PLC_PROGRAM), ("--fault", name), held_out=False) for name in soft_plc.faults()}
    for change in json.loads((HELD_OUT / "changes.json").read_text(encoding="utf-8")):
        program = SOFT_PLC / "build" / "held_out" / change["name"]
        faults[change["name"]] = Fault(change["name"], str(program), (), held_out=True)
    if unknown := [name for name in names if name not in faults]:
        raise ValueError(f"no such fault: {', '.join(unknown)}")
    chosen = [faults[name] for name in names] if names else list(faults.values())
    if held_out := [fault.name for fault in chosen if fault.held_out]:
        command = [sys.executable, str(HELD_OUT / "build.py"), *held_out]
        build = subprocess.run(command, capture_output=True, text=True, check=False)
        if build.returncode:
            raise _BuildError(build.stderr.strip())
    return chosen


def _look(fault: Fault, parts: Sequence[Sequence[tuple[Program, Ran]]]) -> Found:
    """Run the programs, which stand beside their usual runs, part by part until one finds the fault."""
    differ = judged = 0
    for part in parts:
        runs = soft_plc.run([program for program, _ in part], *fault.options, command=fault.command)
        differing = [(program, ran) for (program, usual), ran in zip(part, runs, strict=True) if ran != usual]
        differ += len(differing)
        for program, ran in sorted(differing, key=lambda pair: len(pair[1].log)):
            judged += 1
            if ran.failed:
                return Found(fault, differ, judged, program.name, failure=ran.failed)
            report = check(ran.log, name=program.name)
            if report.verdict == "rejected":
                return Found(fault, differ, judged, program.name, tuple(report.requirements))
    return Found(fault, differ, judged)


def _line(one: Found) -> str:
    if not one.program:
        return f"{one.fault.name}: NOT FOUND ({one.differ} programs differ)"
    return f"{one.fault.name}: {one.program}, {', '.join(one.requirements) or one.failure}"


def _object(one: Found) -> dict[str, object]:
    return {
        "fault": one.fault.name,
        "held_out": one.fault.held_out,
        "differ": one.differ,
        "judged": one.judged,
        "program": one.program,
        "requirements": list(one.requirements),
        "failure": one.failure,
    }
