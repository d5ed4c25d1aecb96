"""Paths through the graphs of models: together they take every kind of step in every kind of situation."""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import msgspec

from evidence.common.checkout import ROOT
from evidence.common.processes import Processes
from evidence.models.manifest import Model
from evidence.tla import tlc
from evidence.tla.behaviour import as_log
from evidence.tla.modules import module_folders
from evidence.tla.values import assignments
from s7check.engine import pool
from s7check.kit.from_log import Json, program_of

MODELS = ("airt", "queue", "hold", "lost-point", "catch-ups", "last-minutes")
"""Models whose graphs are small enough to be written down."""

CAUSES = ("header", "duration", "outside", "bodies")
"""The parts of a program that a path decides."""

_HEAP = 1500
_LONGEST = 900.0
"""Seconds for a model."""

_STEPS = 40
"""A path gets no longer by steps that are looked for."""

_AHEAD = 4
"""So many steps ahead a path looks for one that is not covered."""

_VIEW = re.compile(r"^VIEW\b.*$", re.MULTILINE)
_NODE = re.compile(r'^(-?\d+) \[label="((?:[^"\\]|\\.)*)"(.*)\]')
_ESCAPED = re.compile(r"\\(.)")
_BEGINS = "style = filled"
"""TLC draws the states without one before them so."""
_EDGE = re.compile(r"^(-?\d+) -> (-?\d+)\b")
_REQUESTED = re.compile(r"\bob \|-> (\d+)")

Step = tuple[str, ...]
"""A kind of step in a kind of situation: equal for steps of which one is as good as another."""


class NoGraphError(RuntimeError):
    """TLC wrote no graph; the message says what it said."""


@dataclass
class Graph:
    """The states of a model as TLC spells them, by their numbers; the first ones, and the steps between all."""

    states: dict[str, str] = field(default_factory=dict)
    steps: dict[str, list[str]] = field(default_factory=dict)
    begins: list[str] = field(default_factory=list)

    @classmethod
    def of(cls, lines: Iterator[str]) -> Graph:
        """Read TLC's dump, of the format ``dot``."""
        graph = cls()
        for line in lines:
            if edge := _EDGE.match(line):
                source, target = edge[1], edge[2]
                if target not in graph.steps.setdefault(source, []):
                    graph.steps[source].append(target)
            elif node := _NODE.match(line):
                graph.states.setdefault(
                    node[1], _ESCAPED.sub(lambda found: "\n" if found[1] == "n" else found[1], node[2])
                )
                if _BEGINS in node[3]:
                    graph.begins.append(node[1])
        return graph


def graph(model: Model, tools: tlc.Toolchain, processes: Processes) -> Graph:
    """The graph of a model. Raises NoGraphError."""
    library = (*module_folders(ROOT / "spec"), ROOT / "models")
    text = (ROOT / "models" / model.module).read_text(encoding="utf-8")
    # With a view the states of one view would share the step of the first that TLC found.
    with tlc.workspace(library, model.module.stem, text, _VIEW.sub("", model.config)) as space:
        dump = space.directory / "graph.dot"
        options = tlc.Options(1, model.deadlock, _HEAP, _LONGEST, args=("-dump", "dot", str(dump)))
        run = tlc.run(tools, space.as_one_module(), options, processes)
        if run.outcome.kind != "passed" or not dump.exists():
            raise NoGraphError(f"{model.name}: {run.outcome.kind}: {run.outcome.detail}")
        with dump.open(encoding="utf-8") as file:
            return Graph.of(line.rstrip("\n") for line in file)


def of_graph(found: Graph) -> Iterator[tuple[int, Json]]:
    """A program for each path with its number, but one for those that differ only in what the CPU does of itself."""
    kinds = {state: variables(text) for state, text in found.states.items()}
    known: set[str] = set()
    for number, path in enumerate(cover(found, kinds), 1):
        log = as_log([assignments(found.states[state]) for state in path])
        lines = map(msgspec.json.encode, log)
        with pool.engine() as engine:
            program = program_of(engine, lines, f"path-{number:04}", "A path.", [])
        causes = {part: program[part] for part in CAUSES if part in program}
        if repr(causes) not in known:
            known.add(repr(causes))
            yield number, causes


def cover(found: Graph, variables: Mapping[str, Mapping[str, str]]) -> Iterator[list[str]]:
    """Paths from the beginning that together have each kind of step; greedy, the nearest kind first."""
    before = _tree(found)
    missing = {
        _kind(variables[source], variables[target])
        for source, targets in found.steps.items()
        if source in before
        for target in targets
    }
    for source in before:
        for target in found.steps.get(source, ()):
            if _kind(variables[source], variables[target]) not in missing:
                continue
            path = [*_way(before, source), target]
            while len(path) < _STEPS and (
                more := _ahead(found, variables, path[-1], missing - _kinds(path, variables))
            ):
                path += more
            missing -= _kinds(path, variables)
            yield path


def _kinds(path: Sequence[str], variables: Mapping[str, Mapping[str, str]]) -> set[Step]:
    return {_kind(variables[one], variables[other]) for one, other in pairwise(path)}


def _tree(found: Graph) -> dict[str, str | None]:
    """The state before each on a shortest way to it, in the order in which they are found."""
    before: dict[str, str | None] = dict.fromkeys(found.begins)
    waiting = deque(before)
    while waiting:
        state = waiting.popleft()
        for target in found.steps.get(state, ()):
            if target not in before:
                before[target] = state
                waiting.append(target)
    return before


def _way(before: Mapping[str, str | None], state: str) -> list[str]:
    way: list[str] = []
    at: str | None = state
    while at is not None:
        way.append(at)
        at = before[at]
    return way[::-1]


def _ahead(found: Graph, variables: Mapping[str, Mapping[str, str]], state: str, missing: set[Step]) -> list[str]:
    """The next steps up to the nearest one of a missing kind; none if none is near."""
    ways: deque[list[str]] = deque([[state]])
    seen = {state}
    while ways:
        way = ways.popleft()
        for target in found.steps.get(way[-1], ()):
            if _kind(variables[way[-1]], variables[target]) in missing:
                return [*way[1:], target]
            if target not in seen and len(way) < _AHEAD:
                seen.add(target)
                ways.append([*way, target])
    return []


_SITUATION = ("mode", "delay", "stack", "loaded")
"""Variables of which each value is a situation of its own; of the requests only whose they are counts."""


def variables(text: str) -> dict[str, str]:
    """The values of a state's variables as TLC spells them, on one line each."""
    parts = (part.partition(" = ") for part in re.split(r"^/\\ ", text, flags=re.MULTILINE) if part)
    return {name.strip(): " ".join(value.split()) for name, _, value in parts}


def _kind(source: Mapping[str, str], target: Mapping[str, str]) -> Step:
    waiting = " ".join(sorted(set(_REQUESTED.findall(source["requests"]))))
    return (target["step"], waiting, *(source[name] for name in _SITUATION))
