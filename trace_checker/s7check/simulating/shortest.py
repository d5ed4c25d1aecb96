"""The shortest log that one side allows and the other does not: searched below the log of a program, breadth first."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

from s7check.asking.session import Session
from s7check.asking.variants import Variant, fitted
from s7check.engine.client import Engine
from s7check.kit.from_log import program_of
from s7check.kit.program import Program, read_program
from s7check.log.calls import LOG_FORMAT
from s7check.simulating.separation import Separation, separation_behind
from s7check.simulating.simulation import LATENCY

PAIRS = 4000
"""Pairs of explanations that are followed, in each of the searches."""

_LONGEST = 6
"""Events of a log where none is known."""

_FAMILIES = (
    ("SET_TINT", "clock"),
    ("ACT_TINT", "CAN_TINT", "QRY_TINT", "clock"),
    ("SRT_DINT", "CAN_DINT", "QRY_DINT", "clock"),
    ("DIS_IRT", "EN_IRT", "interrupt"),
    ("DIS_AIRT", "EN_AIRT", "interrupt"),
    ("hold", "release", "restart", "load", "delete", "interrupt"),
)
"""Events that are looked at together where no log is known."""

_BY_ITSELF = ("start", "end", "run", "stop")
"""Events that need nobody, and by which a log shows what the CPU does."""

_OBS = (10, 20, 40, 80, 85)

STANDARD: dict[str, Any] = {
    "format": LOG_FORMAT,
    "cpu": "S7-400",
    "obs": [1, 10, 20, 40, 80, 82, 85, 100],
    "clock": "2026-03-02T08:00:30.000",
    "mode": "RUN",
    "latency_ms": LATENCY,
}
"""The header behind which is searched where no log is known, and the same with a time-of-day interrupt."""

WITH_POINTS = STANDARD | {
    "obs": [1, 10, 80],
    "clock": "2026-03-02T08:01:00.000",
    "step7": {"tod": {"10": {"execution": "minute", "start": "2026-03-02T08:00", "active": True}}},
}


@dataclass(frozen=True)
class Bound:
    """No log of up to ``complete`` events tells the sides apart, if its lines are of these ``events``, any if empty.

    So many ``pairs`` of explanations were followed and ``lines`` tried.
    """

    events: tuple[str, ...]
    complete: int
    pairs: int
    lines: int

    def text(self) -> str:
        """In words."""
        what = f"of {', '.join(self.events)}" if self.events else "of any event"
        lines = f"{self.complete} line{'s' if self.complete != 1 else ''}"
        return f"none of up to {lines} {what} ({self.lines} lines tried in {self.pairs} situations)"


def searched(found: int, bounds: Iterable[Bound]) -> list[str]:
    """What was searched for a log with fewer than ``found`` lines, in words."""
    return [bound.text() for bound in bounds] if found > 1 else ["it has one line, so none is shorter"]


def bounded(
    engine: Engine,
    header: dict[str, Any],
    lines: Sequence[dict[str, Any]],
    allowed: Variant,
    refused: Variant,
    pairs: int = PAIRS,
) -> tuple[list[dict[str, Any]] | None, list[Bound]]:
    """A shorter log than the header with ``lines``, if there is one, and the bounds within which there is none.

    Searched are all lines that the specification offers, as far as the ``pairs`` go; then those of the same events as
    ``lines``, which go further. Without ``lines`` any log is looked for. Raises EngineError.
    """
    bounds: list[Bound] = []
    best: list[dict[str, Any]] | None = None  # without its header
    shown = list(lines)
    own = tuple(line["event"] for line in lines)
    for events in ((), own) if lines else ((), *_FAMILIES):
        deepest = len(shown) - 1 if shown else _LONGEST
        if deepest < 1 or (shown and events and deepest <= bounds[0].complete):
            continue
        only = tuple(sorted({*events, *_BY_ITSELF})) if events else ()
        mine, theirs = (Session(engine, one.of(header)) for one in (allowed, refused))
        obs = {*header["obs"], *(line["ob"] for line in shown if "ob" in line), *_OBS}
        found = mine.parting(theirs, shown, only=only, obs=sorted(obs), deepest=deepest, most=pairs)
        mine.close()
        theirs.close()
        bounds.append(Bound(only, found.complete, found.pairs, found.tried))
        if found.lines is not None:
            shown = best = found.lines
    return best, bounds


def shortened(engine: Engine, found: Separation, pairs: int = PAIRS) -> tuple[Separation, list[Bound]]:
    """The same two sides told apart by the shortest log that is found, and what was searched for a shorter one."""
    lines, bounds = bounded(engine, found.header, found.log[1:], found.allowed, found.refused, pairs)
    if lines is None:
        return found, bounds
    old = found.program
    program = program_behind(engine, found.header, lines, old.name, old.about, old.requirements)
    other = separation_behind(engine, program, found.header, lines, found.allowed, found.refused)
    return (found, bounds) if other is None else (other, bounds)


def anywhere(
    engine: Engine, first: Variant, second: Variant, pairs: int = PAIRS
) -> tuple[Separation | None, list[Bound]]:
    """A log behind one of the two headers that one of the sides allows and the other does not."""
    tried: list[Bound] = []
    for header, allowed, refused in product(_headers(engine, first), *[(first, second)] * 2):
        if allowed == refused:
            continue
        lines, bounds = bounded(engine, header, [], allowed, refused, pairs)
        tried += bounds
        if lines is not None:
            program = program_behind(engine, header, lines, "found", "Found by search.")
            return separation_behind(engine, program, header, lines, allowed, refused), bounds
    return None, tried


def _headers(engine: Engine, side: Variant) -> list[dict[str, Any]]:
    """STANDARD and WITH_POINTS; for a question about the S7-1500 on that."""
    if not any(name.startswith("A15-") for name, _ in side.letters):
        return [STANDARD, WITH_POINTS]
    words = engine.alternatives()
    other = [name for name in words.families if name not in words.classic]
    return [fitted(header, name, words) for name in other for header in (STANDARD, WITH_POINTS)]


def program_behind(
    engine: Engine,
    header: dict[str, Any],
    lines: Sequence[dict[str, Any]],
    name: str,
    about: str,
    requirements: Iterable[str] = (),
) -> Program:
    """The program that brings a log about."""
    texts = [json.dumps(line).encode() for line in (header, *lines)]
    return read_program(json.dumps(program_of(engine, texts, name, about, list(requirements))).encode())
