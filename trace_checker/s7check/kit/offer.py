"""What a CPU offers: programs that need more are skipped."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
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

    def lacks(self, program: Program) -> str:
        """Why the program is skipped; empty if it is not."""
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
