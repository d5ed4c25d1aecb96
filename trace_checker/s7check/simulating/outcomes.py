"""Every outcome of a program, as a tree."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from s7check.asking.line_text import spelled
from s7check.engine.command import EngineError
from s7check.simulating.simulation import Choice, Simulation

MOST = 500
"""Places with a choice that a tree may have."""

NOTHING = "it does not come"


@dataclass
class Part:
    """Lines that come one after the other, then the possible continuations, each with the choice that leads there.

    ``goes_on`` is the number of another part that follows in place of these: from there on everything is alike.
    """

    number: int
    lines: list[dict[str, Any]] = field(default_factory=list)
    ways: list[tuple[str, Part]] = field(default_factory=list)
    goes_on: int | None = None


def outcomes(simulation: Simulation) -> Part:
    """All outcomes from here on. Raises EngineError, also where there are too many."""
    return _Tree().part(simulation)


class _Tree:
    def __init__(self) -> None:
        self._known: dict[tuple[object, ...], int] = {}
        self._count = 0

    def part(self, simulation: Simulation) -> Part:
        self._count += 1
        if self._count > MOST:
            raise EngineError(f"the program has more than {MOST} places with a choice: choose readings, or --seed")
        part = Part(self._count)
        begun = len(simulation.log)
        while choices := simulation.choices():
            if len(choices) > 1:
                break
            simulation.take(choices[0])
        part.lines = simulation.log[begun:]
        known = self._known.setdefault(simulation.key(), part.number)
        if known != part.number:
            part.goes_on = known
            return part
        for choice in choices:
            branch = simulation.branch()
            branch.take(choice)
            lines = branch.log[begun + len(part.lines) :]
            below = self.part(branch)
            below.lines = [*lines, *below.lines]
            part.ways.append((_named(choice), below))
            branch.close()
        return part


def _named(choice: Choice) -> str:
    return NOTHING if choice is None else spelled(choice)


def count(part: Part) -> int:
    """How many outcomes the tree has; equal continuations count once."""
    if part.goes_on is not None:
        return 0
    return sum(count(below) for _, below in part.ways) if part.ways else 1


def as_text(part: Part, indent: str = "") -> list[str]:
    """The tree, a line of the log each; a way is indented under the choice that leads to it."""
    text = [f"{indent}{line['at']} {spelled(line)}" for line in part.lines]
    if part.goes_on is not None:
        return [*text, f"{indent}goes on as at ({part.goes_on})"]
    if part.ways:
        text.append(f"{indent}({part.number}) one of {len(part.ways)}:")
    for name, below in part.ways:
        text.append(f"{indent}  - {name}")
        text += as_text(below, indent + "    ")
    return text


def as_object(part: Part) -> dict[str, Any]:
    """The tree for JSON."""
    return {
        "number": part.number,
        "lines": part.lines,
        "goes_on": part.goes_on,
        "ways": [{"choice": name, **as_object(below)} for name, below in part.ways],
    }
