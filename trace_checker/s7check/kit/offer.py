"""What a CPU offers: programs are fitted to it, and those that need more are skipped."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from s7check.kit.program import OUTSIDE, Program
from s7check.log import tables
from s7check.log.errors import ranges
from s7check.log.events import OPERANDS
from s7check.log.fields import Fields, list_of
from s7check.log.jsonline import decode_object
from s7check.log.values import choice, integer

_CPUS = ("S7-300", "S7-400", "CPU 318")
_MODES = ("STOP", "STARTUP", "RUN")
_EVERY_OB = frozenset(tables.OB_NUMBERS)

_OFFER = Fields(
    "offer",
    {},
    {
        "cpu": list_of(choice(*_CPUS)),
        "obs": list_of(integer(tables.OB_NUMBERS.start, tables.OB_NUMBERS.stop - 1)),
        "calls": list_of(choice(*OPERANDS)),
        "outside": list_of(choice(*OUTSIDE)),
        "modes": list_of(choice(*_MODES)),
        "longest": integer(1, 1 << 53),
    },
)


@dataclass(frozen=True)
class Offer:
    """Families, OBs, SFCs, events from outside and modes at the beginning that an implementation has; ``longest`` is
    the duration in ms of the longest program that it is to run, 0 for any.
    """

    cpu: frozenset[str] = frozenset(_CPUS)
    obs: frozenset[int] = _EVERY_OB
    calls: frozenset[str] = frozenset(OPERANDS)
    outside: frozenset[str] = frozenset(OUTSIDE)
    modes: frozenset[str] = frozenset(_MODES)
    longest: int = 0

    def fitted(self, program: Program) -> Program:
        """The program on a CPU of an offered family, without loaded OBs that the CPU lacks and that nothing can start.

        A program has no expected output, so it is one on any CPU. Only families with priority classes that can be set
        take the place of one.
        """
        header = program.header
        others = sorted(self.cpu & tables.PRIORITY_CPUS if "priority" in header else self.cpu)
        cpu = header["cpu"] if header["cpu"] in self.cpu or not others else others[0]
        obs = [ob for ob in header["obs"] if ob in self.obs or ob in _started(program)]
        if (cpu, obs) == (header["cpu"], header["obs"]):
            return program
        changed = {"cpu": cpu, "obs": obs}
        raw = {**program.raw, "header": program.raw["header"] | changed}
        return replace(program, header=header | changed, raw=raw)

    def lacks(self, program: Program) -> str:
        """Why the program, which is fitted, is skipped; empty if it is not."""
        header = program.header
        if header["cpu"] not in self.cpu:
            return f"no {header['cpu']}"
        steps = [step for body in program.bodies for step in body.steps]
        if missing := {*header["obs"], *_named(program.outside), *_called(steps)} - self.obs:
            return f"no OB {ranges(missing)}"
        if (mode := header.get("mode", "STOP")) not in self.modes:
            return f"no beginning in {mode}"
        for call in dict.fromkeys(step["call"] for step in steps if "call" in step):
            if call not in self.calls:
                return f"no {call}"
        for event in dict.fromkeys(event["event"] for event in program.outside):
            if event not in self.outside:
                return f"no {event} from outside"
        if self.longest and program.duration > self.longest:
            return f"lasts {program.duration / 1000:g} s, more than {self.longest / 1000:g} s"
        return ""


_BY_RULE = frozenset({1, 80, 85})
"""OBs that start in RUN without an event or a call that names them. A startup OB without a body does nothing."""


def _started(program: Program) -> set[int]:
    """The loaded OBs that may start, or of which the program sees whether they are there."""
    steps = (step for body in program.bodies for step in body.steps)
    configured = (int(ob) for part in program.header.get("step7", {}).values() if isinstance(part, dict) for ob in part)
    named = [event["ob"] for event in (*steps, *program.outside) if "ob" in event]
    return {*_BY_RULE, *(body.ob for body in program.bodies), *named, *configured}


def _named(events: Iterable[dict[str, Any]]) -> Iterator[int]:
    """The OBs that events from outside start, load, delete or ask about."""
    yield from (event["ob"] for event in events if "ob" in event)


def _called(steps: Iterable[dict[str, Any]]) -> Iterator[int]:
    """The OBs whose interrupt a call sets or asks about: a CPU without them refuses it. Other OBs are wrong ones."""
    for step in steps:
        if str(step.get("call")).endswith("_TINT"):
            yield from {step["ob"]} & {*tables.TIME_OF_DAY_OBS}
        elif str(step.get("call")).endswith("_DINT"):
            yield from {step["ob"]} & {*tables.TIME_DELAY_OBS}


def read_offer(file: Path) -> Offer:
    """The offer in a file, a JSON object of which every field may be left out.

    Raises UnusableLogError and OSError.
    """
    raw = decode_object(file.read_bytes().strip())
    read: dict[str, Any] = _OFFER.read(raw)
    longest = read.pop("longest", 0)
    return Offer(**{name: frozenset(values) for name, values in read.items()}, longest=longest)
