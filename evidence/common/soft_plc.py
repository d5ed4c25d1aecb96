"""The soft PLC as an adapter of the kit, with its deliberate faults and its choices."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterator, Sequence

from evidence.common.checkout import SOFT_PLC_PROGRAM
from s7check.kit.adapter import Adapter, Ran
from s7check.kit.program import Program

KIT = ("--kit", "--diag")
"""Its options as an adapter that records everything."""

_SECONDS = 20.0
"""For one program; the soft PLC takes some milliseconds."""

_FAULT = re.compile(r"^  (\S+)", re.MULTILINE)
_CHOICE = re.compile(r"^  (\S+)\s*=(\w+) or (\w+)", re.MULTILINE)


def faults() -> list[str]:
    """The names of its deliberate faults. Raises OSError."""
    return _FAULT.findall(_help("--fault"))


def choices() -> list[str]:
    """What it can do otherwise where the requirements leave a question open, as ``--choose`` takes it. Raises OSError.

    The first value of each question is the default, and is left out.
    """
    return [f"{name}={other}" for name, _, other in _CHOICE.findall(_help("--choose"))]


def _help(option: str) -> str:
    return subprocess.run([SOFT_PLC_PROGRAM, option, "help"], capture_output=True, text=True, check=False).stdout


def run(programs: Sequence[Program], *options: str, command: str = str(SOFT_PLC_PROGRAM)) -> Iterator[Ran]:
    """What comes of each program, in their order. Raises AdapterError."""
    with Adapter((command, *options, *KIT), _SECONDS) as adapter:
        for program in programs:
            yield adapter.run(program)
