"""The search for the smallest program that tells two headers apart."""

from __future__ import annotations

import time
from collections.abc import Iterable

from s7check.asking.variants import Variant
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.kit.program import Program
from s7check.simulating.reducing import reduced
from s7check.simulating.separation import Separation, separate, size


def distinguished(
    engine: Engine, programs: Iterable[Program], first: Variant, second: Variant, seconds: float
) -> Separation | None:
    """The smallest of ``programs`` that tells the two apart, made smaller; None if none of those tried does.

    The smaller ones are tried first, for some ``seconds``; of each, the log of either side.
    """
    until = time.monotonic() + seconds
    for program in sorted(programs, key=size):
        found = told_apart(engine, program, first, second)
        if found is not None:
            return smallest(engine, found)
        if time.monotonic() > until:
            break
    return None


def told_apart(engine: Engine, program: Program, first: Variant, second: Variant) -> Separation | None:
    """Whether one side refuses the log that the other makes of the program."""
    for allowed, refused in ((first, second), (second, first)):
        try:
            found = separate(engine, program, allowed, refused)
        except EngineError:
            continue  # a program that this side cannot run, too many explanations for instance
        if found is not None:
            return found
    return None


def smallest(engine: Engine, found: Separation) -> Separation:
    """The same difference, by the same requirements, of a smaller program."""

    def again(program: Program) -> Separation | None:
        try:
            other = separate(engine, program, found.allowed, found.refused)
        except EngineError:
            return None
        same = other is not None and other.refusal.requirements == found.refusal.requirements
        return other if same and other is not None and other.log[-1]["event"] == found.log[-1]["event"] else None

    program = reduced(found.program, lambda one: again(one) is not None)
    return again(program) or found
