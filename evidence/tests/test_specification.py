"""The shape of the specification: its map, the size of its modules, its readings, its next-state relation."""

import re

from tree_sitter import Node

from evidence.tests.test_witnesses import ROOT
from evidence.tla.actions import acting, disjuncts
from evidence.tla.modules import read_modules
from evidence.tla.syntax import Module, operand, references, token, walk
from s7check.resources import modules


def body(name: str, module: Module) -> Node:
    """The right side of a definition."""
    return operand(module.definitions[name], "definition")


def names_in(node: Node) -> list[str]:
    """The names that an expression is the disjunction of; none where it is no disjunction."""
    found = []
    for part in disjuncts(node):
        assert part.type == "identifier_ref" or disjuncts(part), f"{token(part)} has no name"
        found += names_in(part) or [token(part)]
    return found


def actions_of(name: str, module: Module) -> list[str]:
    """The actions that a definition is the disjunction of; itself where it is none."""
    return [action for part in names_in(body(name, module)) for action in actions_of(part, module)] or [name]


def test_next_is_the_disjunction_of_the_named_actions() -> None:
    """Each action of System that takes a step is in Next, once, by its name."""
    spec = read_modules(ROOT / "spec")
    system = spec["System"]
    steps = (acting("System", spec) & system.definitions.keys()) - {"Seen", "Spec"}
    groups = {name for name in steps if disjuncts(body(name, system))}
    assert sorted(actions_of("Next", system)) == sorted(steps - groups)


def test_each_action_shows_a_step() -> None:
    """Each says by `step` what an observer sees, and all but the responses wait until nothing is pressing."""
    system = read_modules(ROOT / "spec")["System"]
    for name in actions_of("Next", system):
        words = references(body(name, system))
        assert words & {"Seen", "step"}, name
        assert bool(words & {"Settled", "Calling"}) == (name not in actions_of("Respond", system)), name


def test_the_map_has_each_module_once() -> None:
    """The lists of spec/README.md, and the graph, which says which module extends which."""
    page = (ROOT / "spec" / "README.md").read_text(encoding="utf-8")
    spec = read_modules(ROOT / "spec")
    lists = page.partition("\n## The modules")[2]
    assert sorted(re.findall(r"\[(\w+)\]\(\w+/\1\.tla\)", lists)) == sorted(spec)
    edges = {(a, b) for left, b in re.findall(r"^  (.+) --> (\w+)$", page, re.MULTILINE) for a in left.split(" & ")}
    shown = {module for edge in edges for module in edge}
    assert edges == {(a, b) for b in shown for a in spec[b].imports & shown}


LONG = {"Reasons": 725, "StartReasons": 500, "Readings": 590, "LooseLogs": 600, "ReportedData": 470}
"""Lines of the modules that have one case for each kind of line, of start or of field; and a name for each answer."""


def test_modules_are_short() -> None:
    """A module of more than 450 lines is more than one concern."""
    lines = {name: module.text.count(b"\n") for name, module in read_modules(ROOT / "spec").items()}
    assert [name for name, count in lines.items() if count > LONG.get(name, 450)] == []


def test_lines_have_79_columns() -> None:
    """No line of a module of the specification or of a model is longer."""
    files = [*modules(ROOT / "spec"), *modules(ROOT / "models")]
    lines = ((file, line) for file in files for line in file.read_text(encoding="utf-8").splitlines())
    assert [f"{file.name}: {line}" for file, line in lines if len(line) > 79] == []


def test_letters_are_compared_in_readings_alone() -> None:
    """Every other module asks by a name."""
    asking = {
        name
        for name, module in read_modules(ROOT / "spec").items()
        if any("Reading" in references(unit) for unit in module.definitions.values())
    }
    assert asking == {"Readings"}


def test_families_are_named_in_one_module() -> None:
    """Every other module asks for a fact of the family."""
    families = {'"S7-300"', '"S7-400"', '"CPU 318"'}
    naming = {
        name
        for name, module in read_modules(ROOT / "spec").items()
        if families & {token(node) for node in walk(module.root) if node.type == "string"}
    }
    assert naming == {"Families"}


def test_modules_extend_few_others_in_turn() -> None:
    """A reader can follow what a module is built on: the rules are at most eight modules deep, all 14."""
    spec = read_modules(ROOT / "spec")

    def depth(name: str) -> int:
        return 1 + max((depth(each) for each in spec[name].imports & spec.keys()), default=0)

    assert depth("System") <= 8
    assert max(map(depth, spec)) <= 14
