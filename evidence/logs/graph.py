"""The state graph of a model, exported by TLC, with a line of a log at each edge that a log shows."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass, field

import msgspec

from evidence.common.checkout import MANIFEST, ROOT
from evidence.common.processes import Processes
from evidence.models.manifest import load
from evidence.tla import tlc
from evidence.tla.behaviour import Line, State, as_log, event_of
from evidence.tla.cfg import replacements
from evidence.tla.modules import module_folders
from evidence.tla.values import assignments

MODULE = "Edges"
_HEAP = 1500
_NODE = re.compile(r'^(-?\d+) \[label="(.*?)"(,style = filled)?\]', re.MULTILINE)
_EDGE = re.compile(r"^(-?\d+) -> (-?\d+) ", re.MULTILINE)
_LAST = ("step", "entered")
"""Variables that only say how a state was reached."""


@dataclass(frozen=True)
class World:
    """A model of models/ with other values for some of its constants, and no states beyond `bound`."""

    model: str
    constants: dict[str, str]
    bound: str


WORLDS = {
    "delay": World(
        "MCAirt",
        {"Loads": "{{10, 40}}", "Moments": "{Moment(0, 30000), Moment(1, 0), Moment(1, 30000)}"},
        "delay <= 1 /\\ Waiting(1)",
    ),
    "hold": World(
        "MCHold",
        {
            "Loads": "{{10, 80}}",
            "Interrupts": "{}",
            "Moments": "{Moment(0, 30000), Moment(1, 0), Moment(1, 30000)}",
            "ClockTargets": "{Moment(1, 30000)}",
        },
        "Waiting(1)",
    ),
    "job": World(
        "MCDint",
        {
            "Loads": "{{20, 40}}",
            "ObNumbers": "{20}",
            "Dtimes": "{30000}",
            "Signs": "{1}",
            "StatusWords": "{}",
            "Moments": "{Moment(0, 0), Moment(0, 30000), Moment(1, 0)}",
            "ClockTargets": "{}",
            "HoldPossible": "FALSE",
        },
        "Waiting(1)",
    ),
}
"""What is exported."""


class NotExportedError(RuntimeError):
    """TLC has exported no graph; the message says what it said."""


@dataclass
class Graph:
    """States by number; `shown` has the edges with a line, at the clock `at` of its state, `unseen` the others.

    Nothing is known of what follows a state of the `border`.
    """

    headers: dict[int, Line] = field(default_factory=dict)
    at: list[str] = field(default_factory=list)
    shown: list[set[tuple[bytes, int]]] = field(default_factory=list)
    unseen: list[set[int]] = field(default_factory=list)
    border: set[int] = field(default_factory=set)

    @property
    def edges(self) -> int:
        """How many edges show a line."""
        return sum(map(len, self.shown))


def exported(world: World, tools: tlc.Toolchain, processes: Processes, timeout: float) -> Graph:
    """The graph of a model in its world. Raises `NotExportedError`."""
    library = (*module_folders(ROOT / "spec"), ROOT / "models")
    with tlc.workspace(library, MODULE, _module(world), _configuration(world)) as space:
        dot = space.directory / "graph.dot"
        options = tlc.Options(1, False, _HEAP, timeout, args=("-dump", "dot", str(dot)))
        run = tlc.run(tools, space.as_one_module(), options, processes)
        if run.outcome.kind != "passed":
            said = run.outcome.errors[0] if run.outcome.errors else run.outcome.detail
            raise NotExportedError(f"{world.model}: no graph: {run.outcome.kind}: {said}")
        return read(dot.read_text())


def _module(world: World) -> str:
    """States outside the bound are in the graph, and nothing follows them."""
    own = "".join(f"Own{name} == {text}\n" for name, text in world.constants.items())
    return (
        f"---- MODULE {MODULE} ----\nEXTENDS {world.model}\n{own}"
        f"Inside == Bounded /\\ {world.bound} /\\ Next\nInsideSpec == Init /\\ [][Inside]_vars\n====\n"
    )


def _configuration(world: World) -> str:
    """The model's constants, without what it checks."""
    model = next(m for m in load(ROOT / MANIFEST).models if m.module.stem == world.model)
    constants = replacements(model.config) | {name: f"Own{name}" for name in world.constants}
    lines = "\n".join(f"    {name} <- {value}" for name, value in constants.items())
    return f"SPECIFICATION InsideSpec\nCHECK_DEADLOCK FALSE\nCONSTANTS\n{lines}\n"


def read(dot: str) -> Graph:
    """The graph in the language of Graphviz, as TLC writes it; states that differ only in how they came are one."""
    states = {int(name): assignments(_text(label)) for name, label, _ in _NODE.findall(dot)}
    graph = Graph()
    numbers: dict[str, int] = {}
    of: dict[int, int] = {}
    for name, state in states.items():
        key = json.dumps({name: value for name, value in state.items() if name not in _LAST}, sort_keys=True)
        number = of[name] = numbers.setdefault(key, len(numbers))
        if number == len(graph.at):
            graph.at.append(str(as_log([state])[0]["clock"]))
            graph.shown.append(set())
            graph.unseen.append(set())
        if state["step"]["event"] == "power on":
            graph.headers[number] = as_log([state])[0]
    followed = set()
    for one, other in _EDGE.findall(dot):
        begin, end = of[int(one)], of[int(other)]
        followed.add(begin)
        for line in _lines(states[int(one)], states[int(other)]):
            if line is None:
                graph.unseen[begin].add(end)
            else:
                graph.shown[begin].add((line, end))
    graph.border = set(range(len(graph.at))) - followed
    return graph


def _text(label: str) -> str:
    return label.replace("\\n", "\n").replace('\\"', '"').replace("\\\\", "\\")


def _lines(before: State, after: State) -> Iterator[bytes | None]:
    """The line of a step without its time; a STOP by a rule may be logged without its cause."""
    event = event_of(before, after)
    if event is None:
        yield None
        return
    line = {name: value for name, value in event.items() if name != "at"}
    yield msgspec.json.encode(line, order="sorted")
    if "cause" in line:
        yield b'{"event":"stop"}'
