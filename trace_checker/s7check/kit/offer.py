"""What a CPU offers: programs are fitted to it, and those that need more are skipped."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from s7check.engine import pool
from s7check.engine.answer import Alternatives
from s7check.kit.program import OF_S7_1500, Program
from s7check.log.calls import WITHOUT_NUMBER
from s7check.log.errors import ranges


@dataclass(frozen=True)
class Offer:
    """Families, OBs, SFCs, events from outside and modes at the beginning that an implementation has, None for all;
    ``longest`` is the duration in ms of the longest program that it is to run, 0 for any.

    ``deselected``: OBs of class 0, or deselected in STEP 7, can be had; ``cycle``: starts and ends of OB 1 can be
    logged; ``diag``: every entry of the diagnostic buffer is. ``loaded`` are OBs that the CPU has whatever a program
    says.
    """

    cpu: frozenset[str] | None = None
    obs: frozenset[int] | None = None
    calls: frozenset[str] | None = None
    outside: frozenset[str] | None = None
    modes: frozenset[str] | None = None
    longest: int = 0
    deselected: bool = True
    cycle: bool = True
    diag: bool = False
    loaded: frozenset[int] = frozenset()

    def fitted(self, program: Program) -> Program:
        """The program on a CPU of an offered family, without loaded OBs that the CPU lacks and that nothing can start,
        with those that it always has, and without a log of the cycles if there is none.

        A program has no expected output, so it is one on any CPU. Only families in which its priority classes can be
        set take the place of one, and of an S7-1500 none where the program needs what only that has.
        """
        header, cpu = program.header, program.header["cpu"]
        if _missing([cpu], self.cpu):
            cpu = min((one for one in self.cpu or () if _may_run(one, program)), default=cpu)
        started = _started(program)
        lacking = _missing(header["obs"], self.obs) - started
        obs = [ob for ob in header["obs"] if ob not in lacking]
        obs += sorted(self.loaded - started - {*obs})
        changed: dict[str, Any] = {"cpu": cpu, "obs": obs}
        if header.get("cycle") and not self.cycle:
            changed["cycle"] = False
        if changed.items() <= header.items():
            return program
        raw, plain = (each | {"header": each["header"] | changed} for each in (program.raw, program.plain))
        return replace(program, header=header | changed, raw=raw, plain=plain)

    def lacks(self, program: Program) -> str:
        """Why the program, which is fitted, is skipped; empty if it is not."""
        header = program.header
        if _missing([header["cpu"]], self.cpu):
            return f"no {header['cpu']}"
        steps = [step for body in program.bodies for step in body.steps]
        if self.obs is not None and (missing := {*header["obs"], *_named(program.outside), *_called(steps)} - self.obs):
            return f"no OB {ranges(missing)}"
        if there := {*self.loaded} - {*header["obs"]}:
            return f"OB {ranges(there)} cannot be missing"
        if not self.deselected and (missing := _deselected(header)):
            return f"no deselected OB {ranges(missing)}"
        mode = header.get("mode", "STOP")
        if _missing([mode], self.modes):
            return f"no beginning in {mode}"
        for call in dict.fromkeys(step["call"] for step in steps if "call" in step):
            if _missing([call], self.calls):
                return f"no {call}"
        for event in dict.fromkeys(event["event"] for event in program.outside):
            if _missing([event], self.outside):
                return f"no {event} from outside"
        if self.longest and program.duration > self.longest:
            return f"lasts {program.duration / 1000:g} s, more than {self.longest / 1000:g} s"
        return ""


def _may_run(family: str, program: Program) -> bool:
    """Whether the family has all that the program needs but for OBs."""
    words = pool.alternatives()
    header = program.header
    local = any(fields.get("local") for fields in header.get("step7", {}).get("tod", {}).values())
    steps = [step for body in program.bodies for step in body.steps]
    local = local or any(event.get("event") == "zone" for event in (*steps, *program.outside))
    local = local or any(step.get("call") == WITHOUT_NUMBER for step in steps)
    if family not in words.local and (local or not header.keys().isdisjoint(OF_S7_1500)):
        return False
    return _may_have(words, family, header.get("priority", {}))


def _may_have(words: Alternatives, family: str, priority: Mapping[str, int]) -> bool:
    """Whether the family can have these priority classes."""
    classes = dict(dict(words.classes).get(family, [])) if family in words.settable else {}
    return all(number in classes.get(int(ob), ()) for ob, number in priority.items())


def _missing(needed: Iterable[Any], offered: frozenset[Any] | None) -> set[Any]:
    return set() if offered is None else set(needed) - offered


_BY_RULE = frozenset({1, 80, 85})
"""OBs that start in RUN without an event or a call that names them. A startup OB without a body does nothing."""


def _started(program: Program) -> set[int]:
    """The loaded OBs that may start, or of which the program sees whether they are there."""
    steps = (step for body in program.bodies for step in body.steps)
    configured = (int(ob) for part in program.header.get("step7", {}).values() if isinstance(part, dict) for ob in part)
    named = [event["ob"] for event in (*steps, *program.outside) if "ob" in event]
    return {*_BY_RULE, *(body.ob for body in program.bodies), *named, *configured}


def _deselected(header: dict[str, Any]) -> set[int]:
    """The OBs of class 0, and those that STEP 7 has deselected."""
    classes = {int(ob) for ob, number in header.get("priority", {}).items() if number == 0}
    parameters = (one for part in header.get("step7", {}).values() if isinstance(part, dict) for one in part.items())
    return classes | {int(ob) for ob, fields in parameters if fields.get("deselected")}


def _named(events: Iterable[dict[str, Any]]) -> Iterator[int]:
    """The OBs that events from outside start, load, delete or ask about."""
    yield from (event["ob"] for event in events if "ob" in event)


def _called(steps: Iterable[dict[str, Any]]) -> Iterator[int]:
    """The OBs whose interrupt a call sets or asks about: a CPU without them refuses it. Other OBs are wrong ones."""
    words = pool.alternatives()
    for step in steps:
        if str(step.get("call")).endswith(("_TINT", WITHOUT_NUMBER)):
            yield from {step["ob"]} & {*words.tod_obs}
        elif str(step.get("call")).endswith("_DINT"):
            yield from {step["ob"]} & {*words.dint_obs}


def read_offer(file: Path) -> Offer:
    """The offer in a file, a JSON object of which every field may be left out.

    Raises EngineError, UnusableLogError and OSError.
    """
    with pool.engine() as engine:
        read = engine.checked("offer", file.read_bytes())
    fields: dict[str, Any] = {
        name: frozenset(value) if isinstance(value, list) else value for name, value in read.items()
    }
    return Offer(**fields)
