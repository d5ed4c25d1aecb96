"""A program runs on the specification, in the engine."""

from __future__ import annotations

from typing import Any

from s7check.asking.variants import AS_IT_IS, Variant
from s7check.engine.client import Engine
from s7check.kit.program import Program

LATENCY = 10
"""``latency_ms`` of a log, by default."""


def simulated(
    engine: Engine, program: Program, variant: Variant = AS_IT_IS, latency: int = LATENCY, seed: int | None = None
) -> list[dict[str, Any]]:
    """The lines of the log of one run, the header first; ``variant`` changes the program's CPU.

    Everything happens as early as it may: OBs before events from outside, those before the steps of the program. With
    ``seed`` is chosen at random, and OBs start up to ``latency`` ms late. Raises EngineError and UnusableLogError.
    """
    how = {} if seed is None else {"seed": seed}
    log: list[dict[str, Any]] = engine.simulated(program.line(), variant.of(program.header), latency, **how)["log"]
    return log


def outcomes(engine: Engine, program: Program, variant: Variant = AS_IT_IS, latency: int = LATENCY) -> dict[str, Any]:
    """Every outcome, as a tree with the ``header`` of the logs and the number of ``outcomes``.

    It and each of its ``ways`` have a ``number``, ``lines`` that come one after the other, and the possible
    continuations, each with the ``choice`` that leads there; ``goes_on`` is the number of another part that follows
    in place of these; ``text`` has lines for people. Raises EngineError, also where there are too many, and
    UnusableLogError.
    """
    return engine.simulated(program.line(), variant.of(program.header), latency, all=True)
