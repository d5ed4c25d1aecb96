"""A program that tells two headers apart: a log that one allows and the other does not."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from s7check.asking.answers import Refusal
from s7check.asking.session import Session
from s7check.asking.variants import Variant
from s7check.engine.client import Engine
from s7check.kit.program import Program
from s7check.log.values import instant, iso
from s7check.simulating.simulation import LATENCY, Simulation


@dataclass(frozen=True)
class Separation:
    """``log`` is a log of the program that ``allowed`` explains; ``refused`` does not explain its line ``line``.

    ``grounds`` are the requirements by which the one has the line, ``refusal`` says why the other has not. ``log`` ends
    with that line.
    """

    program: Program
    allowed: Variant
    refused: Variant
    log: list[dict[str, Any]]
    line: int
    grounds: list[str]
    refusal: Refusal


def separate(engine: Engine, program: Program, allowed: Variant, refused: Variant) -> Separation | None:
    """Whether ``refused`` cannot explain the log that ``allowed`` makes of the program. Raises EngineError."""
    log = log_of(engine, program, allowed)
    return separation(engine, program, log, allowed, refused)


def log_of(engine: Engine, program: Program, variant: Variant) -> list[dict[str, Any]]:
    """The log of the program, with a stop behind it: what had to come before is then seen to be missing."""
    simulation = Simulation(engine, program, variant)
    log = simulation.run()
    simulation.close()
    end = iso(max(instant(log[-1]["at"] if len(log) > 1 else log[0]["clock"]), _end(log, program)) + 2 * LATENCY)
    if len(log) < 2 or log[-1]["event"] != "stop":
        log = [*log, {"at": end, "event": "stop"}]
    return log


def _end(log: list[dict[str, Any]], program: Program) -> int:
    """The CPU clock when the program ends."""
    jumps = sum(instant(line["to"]) - instant(line["at"]) for line in log[1:] if line["event"] == "clock")
    return instant(program.header["clock"]) + program.duration + jumps


def separation(
    engine: Engine, program: Program, log: list[dict[str, Any]], allowed: Variant, refused: Variant
) -> Separation | None:
    """The same for a log of ``allowed``."""
    other = Session(engine, refused.of(program.header) | _own(log[0]))
    for number, line in enumerate(log[1:], 2):
        refusal = other.feed(line)
        if refusal is not None:
            grounds = _grounds(engine, log[: number - 1], line)
            other.close()
            if grounds is None:
                return None
            return Separation(program, allowed, refused, log[:number], number, grounds, refusal)
    other.close()
    return None


def _own(header: dict[str, Any]) -> dict[str, Any]:
    return {name: header[name] for name in ("format", "latency_ms")}


def _grounds(engine: Engine, before: list[dict[str, Any]], line: dict[str, Any]) -> list[str] | None:
    """By which requirements the line is possible behind the others; None if it is not."""
    session = Session(engine, before[0])
    for each in before[1:]:
        session.feed(each)
    possible = session.possible([line], line["at"])
    session.close()
    return sorted({name for one in possible.lines for name in one.requirements}) if possible.lines else None


def size(program: Program) -> tuple[int, int, int]:
    """Programs are compared by their steps and events, then by how much else they need."""
    steps = [step for body in program.bodies for step in body.steps]
    acts = len(program.outside) + sum("call" in step or "event" in step for step in steps)
    settings = len(program.header.get("step7", {}).get("tod", {})) + len(program.header.get("priority", {}))
    return (acts + settings, len(steps) + len(program.outside), len(program.header["obs"]))
