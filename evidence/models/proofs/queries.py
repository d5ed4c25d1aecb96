"""The queries of the proofs: models/proofs.json, the actions of System, and the properties of spec/properties.

The actions and the properties are read from spec/, so that none is forgotten; models/proofs.json lists the exceptions
from the claim, with the reason.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from pathlib import Path

from msgspec import UNSET, structs
from tree_sitter import Node

from evidence.common.checkout import MANIFEST as MODELS
from evidence.models.entries import Entry
from evidence.models.entries import ManifestError as ModelsError
from evidence.models.entries import read as read_models
from evidence.models.proofs.making import FOLLOWS, Making, Mutant, Query, begun_in
from evidence.models.proofs.manifest import MANIFEST, ManifestError, NotProved, ProofsFile, read
from evidence.tla.actions import acting, disjuncts
from evidence.tla.modules import read_modules
from evidence.tla.syntax import Module, operand, token

BOXED = re.compile(r"^(\w+) ==\s*\[\]\[", re.MULTILINE)
STATED = re.compile(r"^(\w+Inv) ==", re.MULTILINE)


@dataclass(frozen=True)
class Proofs:
    """The manifest with its queries in order, and the properties by module: of steps and of states."""

    file: ProofsFile
    queries: tuple[Query, ...]
    actions: tuple[str, ...]
    steps: dict[str, tuple[str, ...]]
    states: dict[str, tuple[str, ...]]

    @property
    def contradicted(self) -> list[NotProved]:
        """The properties that letters contradict: each has a control for TLC and a log.

        The invariants of the induction have none, since they are no properties of System; nor has a counterexample that
        no behaviour comes to.
        """
        return [
            cell
            for cell in self.file.not_proved
            if cell.letter and not cell.unreached and cell.formula not in self.file.induction.invariants
        ]

    def in_small_world(self) -> Proofs:
        """The same, but the queries of steps begin where those begin that ask for a counterexample; none is divided."""
        base = self.file.induction
        steps = {query.name: replace(query, divided=()) for query in self.queries if query.kind == "step"}
        small = [begun_in(base, base.refuted, steps[q.name]) if q.name in steps else q for q in self.queries]
        file = structs.replace(self.file, induction=structs.replace(base, world=base.refuted))
        return replace(self, file=file, queries=tuple(small))

    def select(self, names: tuple[str, ...]) -> list[Query]:
        """The queries whose name or action a glob matches; all without globs. Raises `ManifestError`."""
        for glob in names:
            if not any(_matches(query, glob) for query in self.queries):
                raise ManifestError(f"no query or action is called {glob}: s7spec prove --list names them")
        return [q for q in self.queries if not names or any(_matches(q, glob) for glob in names)]


def _matches(query: Query, glob: str) -> bool:
    return fnmatchcase(query.name, glob) or (
        query.kind == "step" and any(fnmatchcase(action, glob) for action in query.actions)
    )


def load(root: Path) -> Proofs:
    """The queries of the checkout at `root`. Raises `ManifestError`, OSError."""
    path = root / MANIFEST
    file = read(path)
    modules = read_modules(root / "spec")
    others = {action for family in file.induction.families for action in family.only}
    actions = tuple(action for action in named_actions(modules) if action not in others)
    steps, states = properties(modules)
    models = _models(root / MODELS)
    mutants, claim_mutants = (tuple(_mutants(listed, models)) for listed in (file.mutants, file.claim_mutants))
    making = Making(file, actions, _names(steps), _names(states), mutants, claim_mutants)
    problem = next(_wrong_names(making), "")
    if problem:
        raise ManifestError(f"{path}: {problem}")
    proofs = Proofs(file, making.queries(), actions, steps, states)
    problem = next(_wrong_queries(proofs, models), "")
    if problem:
        raise ManifestError(f"{path}: {problem}")
    return proofs


def _names(by_module: dict[str, tuple[str, ...]]) -> tuple[str, ...]:
    return tuple(name for names in by_module.values() for name in names)


def _wrong_names(making: Making) -> Iterator[str]:
    """What names no action, property, control or claim."""
    file, actions, stated = making.file, making.actions, set(making.states)
    formulas = {*making.steps, *file.induction.invariants}
    refined = {formula for refinement in file.refinements.values() for formula in refinement.steps}
    joined = [action for some in file.induction.together.values() for action in some]
    if len(joined) != len(set(joined)) or not set(joined) <= set(actions):
        yield "induction.together: expected actions of System, each once"
    for cell in file.not_proved:
        if cell.action == FOLLOWS and cell.formula in stated:
            continue
        if cell.action not in actions:
            yield f"{cell.action} is no action of System"
        if cell.formula not in formulas | refined:
            yield f"{cell.formula} is neither a property of steps nor an invariant"
    for mutant in making.mutants:
        if mutant.of not in actions or mutant.formula not in formulas | stated | refined:
            yield f"mutants: expected an action and a property, not {mutant.of} and {mutant.formula}"
    for mutant in making.claim_mutants:
        if mutant.of not in {claim.name for claim in file.claims}:
            yield f"claim_mutants: expected the name of a claim, not {mutant.of}"
    for mutant in (*making.mutants, *making.claim_mutants):
        if not mutant.mutations:
            yield f"mutants: {mutant.control} is no control of {MODELS} that changes a module"


def _wrong_queries(proofs: Proofs, models: dict[str, Entry]) -> Iterator[str]:
    """Where the manifest speaks of queries that there are not, or of models that do not show what it says."""
    for glob, places in proofs.file.induction.divided.items():
        matched = any(query.divided and fnmatchcase(query.name, glob) for query in proofs.queries)
        if not matched or places != sorted(set(places)) or places[0] < 1:
            said = "expected a glob of queries about steps, and numbers above 0 in order"
            yield f"induction.divided: {glob}: {places}: {said}"
    steps = {query.name for query in proofs.queries if query.kind == "step"}
    if unknown := set(proofs.file.induction.unfiltered) - steps:
        yield f"induction.unfiltered: expected queries about steps, not {', '.join(unknown)}"
    for cell in [*proofs.contradicted, *(cell for cell in proofs.file.not_proved if cell.unreached)]:
        name = cell.unreached or cell.control
        if not _shows(models.get(name), cell):
            yield f"not_proved: {MODELS} has no model {name} of {cell.formula} by {cell.letter}"


def _models(path: Path) -> dict[str, Entry]:
    """The entries of the models by their names. Raises `ManifestError`, OSError."""
    try:
        return {entry.name: entry for entry in read_models(path).entries}
    except ModelsError as error:
        raise ManifestError(str(error)) from error


def _mutants(listed: dict[str, list[str]], models: dict[str, Entry]) -> Iterator[Mutant]:
    for of, controls in listed.items():
        for text in controls:
            control, _, formula = text.partition(" ")
            model = models.get(control)
            own, mutations = (model.expect.property or "", tuple(model.mutate)) if model else ("", ())
            yield Mutant(control, of, formula or own, mutations)


def _shows(model: Entry | None, cell: NotProved) -> bool:
    """Whether a control violates this formula by this letter; or whether a model has it hold, where it is unreached."""
    if model is None or model.constants.get("ReadingSets") != f"<- {cell.readings}":
        return False
    if not cell.unreached:
        return model.expect.property == cell.formula
    return model.expect.exit == 0 and model.properties is not UNSET and cell.formula in model.properties


def named_actions(modules: dict[str, Module]) -> tuple[str, ...]:
    """The actions of which Next of System is the disjunction."""
    system = modules["System"]
    steps = acting("System", modules)

    def parts(node: Node) -> list[str]:
        found = [name for part in disjuncts(node) for name in parts(part) or [token(part)]]
        return found if all(name in steps for name in found) else []

    def ends(name: str) -> list[str]:
        return [end for part in parts(operand(system.definitions[name], "definition")) for end in ends(part)] or [name]

    return tuple(ends("Next"))


def properties(modules: dict[str, Module]) -> tuple[dict[str, tuple[str, ...]], dict[str, tuple[str, ...]]]:
    """The properties of steps and of states, by the module of the properties."""
    others = ("PropertiesS71500",)  # TLC alone checks these; a query about an S7-1500 names its formulas
    stating = [name for name in modules if name.startswith("Properties") and name not in others]
    texts = {name: modules[name].text.decode() for name in stating}
    steps = {name: tuple(BOXED.findall(text)) for name, text in texts.items()}
    states = {name: tuple(STATED.findall(text)) for name, text in texts.items()}
    return {k: v for k, v in steps.items() if v}, {k: v for k, v in states.items() if v}
