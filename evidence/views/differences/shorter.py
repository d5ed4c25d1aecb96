"""Shorter logs than those of the kit's programs, and logs for the letters that no program of the kit tells apart."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import permutations
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import msgspec

from evidence.common.cases import all_cases
from evidence.views.differences.search import sides_of
from s7check.asking.log_prefix import Prefix, read_prefix
from s7check.asking.variants import Variant
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.kit.program import Program, read_program
from s7check.log.errors import UnusableLogError
from s7check.simulating.kept import Gap, Kept, Side, kept
from s7check.simulating.separation import Separation, separation_behind
from s7check.simulating.shortest import STANDARD, anywhere, bounded, program_behind, shortened
from s7check.simulating.simulation import LATENCY

_BEGINNINGS = 3
"""Logs of two sides behind whose headers a shorter one is searched."""

SHORTEST = "shortest-"
"""The names of the programs of `shortest_of_sides` begin with it."""

Say = Callable[[str], None]


def shorter(engine: Engine, all_kept: Iterable[Kept], say: Say) -> Iterator[Kept]:
    """Each with the shortest log that is found for it, and with what was searched."""
    for one in all_kept:
        found = one.again(engine)
        if found is None:
            continue
        less, bounds = shortened(engine, found)
        if less.line < found.line:
            less = _renamed(less)
        sides = f"{one.allowed.variant.name} against {one.refused.variant.name}"
        say(f"{sides}: {found.line - 1} to {less.line - 1} events")
        yield kept(less, bounds)


def _renamed(found: Separation) -> Separation:
    """The same with a program of its own: it is no longer that of the kit."""
    sides = found.allowed.name, found.refused.name
    name = "-".join("-".join(side.replace(",", "").split()) for side in (sides[0], "and not", sides[1]))
    about = f"Found by search: {sides[0]} allows its log, {sides[1]} does not."
    return replace(found, program=read_program(msgspec.json.encode(found.program.raw | {"name": name, "about": about})))


def shortest_of_sides(engine: Engine, all_kept: Sequence[Kept], say: Say) -> Iterator[Kept]:
    """For each two CPUs or editions the shortest log that one allows and the other does not."""
    for sides in sides_of(engine):
        for pair in permutations(sides, 2):
            these = [one for one in all_kept if (one.allowed, one.refused) == pair]
            best = min(shorter(engine, sorted(these, key=_length)[:_BEGINNINGS], say), default=None, key=_length)
            if best is not None:
                name = f"{SHORTEST}{'-'.join(side.variant.name.replace(' ', '-') for side in pair)}"
                yield msgspec.structs.replace(best, program=best.program | {"name": name})


def _length(one: Kept) -> int:
    return one.line


def of_logs(engine: Engine, ambiguity: str, pair: tuple[str, str]) -> Separation | None:
    """The smallest separation by a shipped log that names the ambiguity, without the lines that it does not need."""
    found: list[Separation] = []
    for prefix in _logs(engine, ambiguity):
        header = _without(prefix.header, ambiguity)
        lines = [line for _, line in prefix.events]
        for one, other in permutations(pair):
            sides = _letter(ambiguity, one), _letter(ambiguity, other)
            separated = _separated(engine, _program(engine, header, lines, ambiguity), header, lines, *sides)
            if separated is not None:
                found.append(separated)
    best = min(found, key=lambda each: each.line, default=None)
    return None if best is None else _smaller(engine, best)


def _logs(engine: Engine, ambiguity: str) -> Iterator[Prefix]:
    with TemporaryDirectory(prefix="s7check-") as folder:
        for case in sorted(all_cases(), key=lambda case: case.file):
            if case.name.startswith(f"{ambiguity}-") or ambiguity in case.requirements:
                yield read_prefix(engine, str(case.put(Path(folder))))


def _without(header: dict[str, Any], ambiguity: str) -> dict[str, Any]:
    """The header without the letter of the ambiguity; a letter goes before an edition's."""
    readings = {name: letter for name, letter in header.get("readings", {}).items() if name != ambiguity}
    rest = {name: value for name, value in header.items() if name != "readings"}
    return {"latency_ms": LATENCY, **rest, **({"readings": readings} if readings else {})}


def _letter(ambiguity: str, letter: str) -> Variant:
    return Side(letters=((ambiguity, letter),)).variant


def _program(engine: Engine, header: dict[str, Any], lines: Sequence[dict[str, Any]], ambiguity: str) -> Program:
    return program_behind(engine, header, lines, ambiguity, f"A log of {ambiguity}.", [ambiguity])


def _separated(
    engine: Engine,
    program: Program,
    header: dict[str, Any],
    lines: Sequence[dict[str, Any]],
    allowed: Variant,
    refused: Variant,
) -> Separation | None:
    try:
        return separation_behind(engine, program, header, lines, allowed, refused)
    except (EngineError, UnusableLogError):
        return None


def _smaller(engine: Engine, found: Separation) -> Separation:
    lines = found.log[1:]
    for place in reversed(range(len(lines) - 1)):
        less = lines[:place] + lines[place + 1 :]
        other = _separated(engine, found.program, found.header, less, found.allowed, found.refused)
        if other is not None and other.line == len(less) + 1:
            lines = less
    program = _program(engine, found.header, lines, found.program.name)
    other = _separated(engine, program, found.header, lines, found.allowed, found.refused)
    return found if other is None else _renamed(other)


def filled(
    engine: Engine, experiments: Sequence[Kept], untold: dict[str, list[tuple[str, str]]], say: Say
) -> tuple[list[Kept], list[Gap]]:
    """Experiments for pairs of letters without one, as far as they are found, and what was searched for the others."""
    choices = {name: set(letters) for name, letters in engine.alternatives().letters}
    more: list[Kept] = []
    gaps: list[Gap] = []
    for ambiguity, pairs in untold.items():
        for pair in pairs:
            if not set(pair) <= choices.get(ambiguity, set()):
                gaps.append(Gap(ambiguity, pair, []))
                continue
            one = of_logs(engine, ambiguity, pair)
            if one is not None:
                say(f"{ambiguity} {pair[0]} against {pair[1]}: a shipped log")
                more += shorter(engine, [kept(one)], say)
                continue
            found, gap = _searched(engine, ambiguity, pair, experiments)
            say(f"{ambiguity} {pair[0]} against {pair[1]}: {'found' if found else 'none'}")
            if found is None:
                gaps.append(gap)
            else:
                more.append(kept(found, gap.bounds))
    return more, gaps


def _searched(
    engine: Engine, ambiguity: str, pair: tuple[str, str], experiments: Sequence[Kept]
) -> tuple[Separation | None, Gap]:
    """A search where no log is known: behind the header of the shortest experiment with the same question."""
    these = [one for one in experiments if one.allowed.letters[0][0] == ambiguity]
    shortest = min(these, key=_length, default=None)
    first, second = (_letter(ambiguity, letter) for letter in pair)
    if shortest is None:
        anything, bounds = anywhere(engine, first, second)
        if anything is not None:
            named = anything.program.raw | {"requirements": [ambiguity]}
            renamed = _renamed(replace(anything, program=read_program(msgspec.json.encode(named))))
            return renamed, Gap(ambiguity, pair, bounds, anything.header)
        return None, Gap(ambiguity, pair, bounds, STANDARD)
    bounds = []
    for one, other in ((first, second), (second, first)):
        # Logs longer than the known one by up to three lines.
        found, tried = bounded(engine, shortest.header, [*shortest.lines, *shortest.lines[-1:] * 3], one, other)
        bounds += tried
        if found is not None:
            program = _program(engine, shortest.header, found, ambiguity)
            separated = _separated(engine, program, shortest.header, found, one, other)
            if separated is not None:
                return _renamed(separated), Gap(ambiguity, pair, tried, shortest.header)
    return None, Gap(ambiguity, pair, bounds, shortest.header)
