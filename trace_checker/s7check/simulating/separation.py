"""A program that tells two headers apart: a log that one allows and the other does not."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from s7check.asking.session import Session
from s7check.asking.variants import Variant
from s7check.engine.answer import Refusal
from s7check.engine.client import Engine
from s7check.kit.program import Program
from s7check.log.values import instant, iso
from s7check.simulating.simulation import LATENCY, simulated


@dataclass(frozen=True)
class Separation:
    """``log`` is a log of the program that ``allowed`` explains; ``refused`` does not explain its line ``line``.

    ``header`` is that of the log without what makes the sides. ``grounds`` are the requirements by which the one has
    the line, ``refusal`` says why the other has not. ``log`` ends with that line.
    """

    program: Program
    allowed: Variant
    refused: Variant
    header: dict[str, Any]
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
    log = simulated(engine, program, variant)
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
    header = {"format": log[0]["format"], **program.header, "latency_ms": log[0]["latency_ms"]}
    return separation_behind(engine, program, header, log[1:], allowed, refused)


def separation_behind(
    engine: Engine,
    program: Program,
    header: dict[str, Any],
    lines: Sequence[dict[str, Any]],
    allowed: Variant,
    refused: Variant,
) -> Separation | None:
    """The same for the lines of a log of ``allowed`` behind a header, which each side changes."""
    log = [allowed.of(header), *lines]
    other = Session(engine, refused.of(header))
    for number, line in enumerate(lines, 2):
        refusal = other.feed(line)
        if refusal is not None:
            other.close()
            grounds = _grounds(engine, log[: number - 1], line)
            if grounds is None:
                return None
            return Separation(program, allowed, refused, header, log[:number], number, grounds, refusal)
    other.close()
    return None


def _grounds(engine: Engine, before: list[dict[str, Any]], line: dict[str, Any]) -> list[str] | None:
    """By which requirements the line is possible behind the others; None if it is not."""
    session = Session(engine, before[0])
    if any(session.feed(each) is not None for each in before[1:]) or session.why(line) is not None:
        session.close()
        return None
    possible = session.possible([line], line["at"])
    session.close()
    return sorted({name for one in possible.lines for name in one.requirements}) if possible.lines else None


def size(program: Program) -> tuple[int, int, int]:
    """Programs are compared by their steps and events, then by how much else they need."""
    steps = [step for body in program.bodies for step in body.steps]
    acts = len(program.outside) + sum("call" in step or "event" in step for step in steps)
    settings = len(program.header.get("step7", {}).get("tod", {})) + len(program.header.get("priority", {}))
    return (acts + settings, len(steps) + len(program.outside), len(program.header["obs"]))
