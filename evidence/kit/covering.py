"""Covering arrays: few choices of levels in which every combination of so many factors is met."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations, product
from random import Random

Choice = dict[str, str]

_CANDIDATES = 12


def covering(
    factors: Mapping[str, Sequence[str]], strength: int, fits: Callable[[Choice], bool], random: Random
) -> Iterator[Choice]:
    """Choices of a level for each factor, such that each combination of levels of ``strength`` factors that some choice
    with ``fits`` has is in one of them. Greedy: each choice is the best of a few that are drawn around a combination
    that is missing.
    """
    missing: dict[tuple[tuple[str, str], ...], None] = {
        tuple(zip(names, levels, strict=True)): None
        for names in combinations(factors, strength)
        for levels in product(*(factors[name] for name in names))
    }
    while missing:
        target = random.choice(list(missing))
        drawn = [one for one in (_drawn(factors, dict(target), random) for _ in range(_CANDIDATES)) if fits(one)]
        if not drawn:
            del missing[target]  # nothing that was tried has it
            continue
        best = max(drawn, key=lambda one: sum(_met(one, strength, missing)))
        for met in combinations(best.items(), strength):
            missing.pop(met, None)
        yield best


def _drawn(factors: Mapping[str, Sequence[str]], target: Choice, random: Random) -> Choice:
    return {name: target.get(name) or random.choice(levels) for name, levels in factors.items()}


def _met(choice: Choice, strength: int, missing: Mapping[tuple[tuple[str, str], ...], None]) -> Iterator[int]:
    return (combination in missing for combination in combinations(choice.items(), strength))
