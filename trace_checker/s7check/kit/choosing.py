"""Fewer programs: those of a shard, and few that together reach what all reach."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Literal

from s7check.kit.program import Program

Aim = Literal["requirements", "guards"]

_OVERHEAD = 5_000
"""Milliseconds that a program costs beside its duration: loading, a restart."""

_UNITS = {"s": 1, "min": 60, "h": 3600}


def budget_of(text: str) -> int:
    """The milliseconds of a time such as ``90s``, ``30min`` or ``2h``. Raises ValueError."""
    match = re.fullmatch(r"(\d+(?:\.\d+)?)(s|min|h)", text)
    if match is None:
        raise ValueError(f"expected a time such as 90s, 30min or 2h; found {text!r}")
    return round(float(match[1]) * _UNITS[match[2]] * 1000)


def shard(programs: Sequence[Program], part: int, parts: int) -> list[Program]:
    """Every ``parts``-th program, from the one with this place on, from 1."""
    return list(programs[part - 1 :: parts])


def covering(programs: Sequence[Program], aim: Aim, budget: int | None) -> list[Program]:
    """Programs that reach all that any of these reaches, as was measured; greedy, the most for its time first.

    ``budget`` is the sum of their durations in ms, with what loading costs; programs that no longer fit are left out.
    """
    reached = {program.name: frozenset(program.raw.get("reaches", {}).get(aim, ())) for program in programs}
    left = set().union(*reached.values())
    found: list[Program] = []
    open_, spent = list(programs), 0
    while left:
        fitting = [one for one in open_ if budget is None or spent + _cost(one) <= budget]
        best = max(fitting, key=lambda one: len(reached[one.name] & left) / _cost(one), default=None)
        if best is None or not reached[best.name] & left:
            break
        found.append(best)
        open_.remove(best)
        left -= reached[best.name]
        spent += _cost(best)
    return found


def _cost(program: Program) -> int:
    return program.duration + _OVERHEAD
