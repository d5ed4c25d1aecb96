"""Finds, among programs, the smallest for each difference between CPUs or editions and for each pair of letters."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import combinations, permutations

from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.kit.program import Program
from s7check.simulating.kept import Kept, Side, kept
from s7check.simulating.search import told_apart
from s7check.simulating.separation import Separation, log_of, separation, size

Say = Callable[[str], None]

_TRIED = 12
"""Programs tried for a pair of letters, beside the programs that name the ambiguity."""


def sides_of(engine: Engine) -> list[list[Side]]:
    """The CPUs, and the editions."""
    words = engine.alternatives()
    return [[Side(cpu=name) for name in words.families], [Side(profile=name) for name in words.profiles]]


def differences(engine: Engine, programs: Iterable[Program], say: Say) -> Iterator[Kept]:
    """One for each pair of CPUs or editions, kind of line and requirements that decide."""
    by_size = sorted(programs, key=size)
    for sides in sides_of(engine):
        found: set[tuple[str, str, str, tuple[str, ...]]] = set()
        for program in by_size:
            if "priority" in program.header and sides[0].cpu:
                continue  # an S7-300 has no such parameter
            for one in _of(engine, program, sides):
                key = (one.allowed.name, one.refused.name, one.log[-1]["event"], tuple(one.refusal.requirements))
                if key not in found:
                    found.add(key)
                    yield kept(one)
                    say(f"{one.allowed.name} against {one.refused.name}: {program.name}")


def _of(engine: Engine, program: Program, sides: list[Side]) -> Iterator[Separation]:
    try:
        logs = {side: log_of(engine, program, side.variant) for side in sides}
    except EngineError:
        return
    for one, other in permutations(sides, 2):
        try:
            found = separation(engine, program, logs[one], one.variant, other.variant)
        except EngineError:
            continue
        if found is not None:
            yield found


def experiments(engine: Engine, programs: Iterable[Program], say: Say) -> Iterator[Kept]:
    """One for each pair of letters of an ambiguity that some program tells apart."""
    by_size = sorted(programs, key=size)
    for ambiguity, letters in sorted(engine.alternatives().readings.items()):
        naming = [one for one in by_size if ambiguity in one.requirements or one.name.startswith(ambiguity)]
        others = [one for one in by_size if one not in naming][:: max(1, len(by_size) // _TRIED)]
        for pair in combinations(letters, 2):
            first, second = (Side(letters=((ambiguity, letter),)).variant for letter in pair)
            found = next(filter(None, (told_apart(engine, one, first, second) for one in [*naming, *others])), None)
            say(f"{ambiguity} {pair[0]} against {pair[1]}: {found.program.name if found else 'none'}")
            if found is not None:
                yield kept(found)
