"""What Apalache is given for a query: the module, its configuration, the arguments; and the key of each formula."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

from evidence.models.entries import Mutation
from evidence.models.proofs.kept import keys
from evidence.models.proofs.making import TOGETHER, Query
from evidence.models.proofs.manifest import ManifestError
from evidence.models.proofs.text import (
    ANY_LETTERS,
    but_for,
    definitions,
    fixed_constants,
    module_text,
    without_comments,
)
from evidence.tla.binding import bind_arguments
from evidence.tla.modules import module_folders
from evidence.tla.syntax import Module
from s7check.resources import modules

CHECKED = "search.invariantFilter="
"""The conditions that are checked: those about states after the step, not before, where they are assumed."""

SOLVER = ("z3.smt.relevancy=0", "z3.smt.arith.solver=2")
"""With Z3's own choices a refinement takes two to three times as long, an action up to half as long again."""

UNFILTERED = "--discard-disabled=false"
"""Apalache checks the formulas of a transition without asking first if a state can take it. That the action can take a
step, its control says."""

_REPLACED = re.compile(r"^ +(\w+) *<- *(\w+)$", re.MULTILINE)


@dataclass(frozen=True)
class Made:
    """What Apalache reads for a query: its module, the configuration, the modules of which it has an instance."""

    text: str
    config: str
    instances: dict[str, str]


def made(root: Path, query: Query) -> Made:
    """Make them. Raises `ManifestError`, `evidence.tla.syntax.SyntaxTreeError`, OSError."""
    text, config = texts(root, query)
    return Made(text, config, instances(root, query, text))


def parts(divided: Sequence[int]) -> list[str]:
    """The transitions of each run, as one of Apalache's tuning options: up to the first number, then from each on.

    The last run takes all that follow. Empty where the action is not divided.
    """
    if not divided:
        return [""]
    before = [f"1->({'|'.join(map(str, range(*some)))})" for some in pairwise([0, *divided])]
    rest = f"1->(?!({'|'.join(map(str, range(divided[-1])))})$).*"
    return [f"search.transitionFilter=(0->.*|{some})" for some in [*before, rest]]


def arguments(query: Query, transitions: str = "", condition: str = "", seed: int = 0) -> list[str]:
    """The arguments of Apalache that are the same for each formula; with a `condition` this one alone is checked."""
    stepping = query.kind != "claim" and query.length
    checked = [f"{CHECKED}{'1' if stepping else '.*'}->{condition.replace(' invariant ', '') or '.*'}"]
    tuning = [*SOLVER, *(checked if stepping or condition else []), *([transitions] if transitions else [])]
    tuning += [f"z3.smt.random_seed={seed}"] if seed else []
    return [
        *(f"--length={query.length}", "--no-deadlock=true"),
        *([f"--cinit={_initializer(query)}"] if query.constants else []),
        *([UNFILTERED] if query.unfiltered else []),
        f"--tuning-options={':'.join(tuning)}",
    ]


def _initializer(query: Query) -> str:
    """The operator that says which values the constants may have; empty where there are none."""
    return query.constants if query.shown is None else ANY_LETTERS


def keys_of(query: Query, made: Made) -> dict[str, str]:
    """The key of each formula of the query: all that Apalache reads for it.

    A violation is one whether or not Apalache was asked first which transitions a state can take.
    """
    others = [without_comments(other) for other in made.instances.values()]
    replaced = [word for pair in _REPLACED.findall(made.config) for word in pair]
    roots = [query.init, query.next, query.constants, ANY_LETTERS, *replaced]
    names = names_of(query)
    said = arguments(query if query.expect == "holds" else replace(query, unfiltered=False))
    found = keys(made.text, names.values(), roots, [*others, made.config, *said])
    return {formula: found[name] for formula, name in names.items()}


def names_of(query: Query) -> dict[str, str]:
    """What stands in the module for each formula: itself, or the formula that leaves letters out."""
    left = {name for name, _ in query.unless}
    return {name: but_for(name) if name in left else name for name in query.formulas}


def texts(root: Path, query: Query) -> tuple[str, str]:
    """The module and the configuration of a query.

    Raises `ManifestError`, `evidence.tla.syntax.SyntaxTreeError`, OSError.
    """
    world = root / "models" / f"{query.world or query.module}.cfg"
    replaced = dict(_REPLACED.findall(world.read_text(encoding="utf-8")))
    words = (query.init, query.next, query.constants, query.history, *query.actions, *query.formulas)
    with tempfile.TemporaryDirectory(prefix="s7check-prove-") as changed:
        for change in query.mutations:
            _mutate(root, query.name, change, Path(changed))
        folders = [Path(changed), root / "models", *module_folders(root / "spec")]
        roots = {*words, *replaced, *replaced.values()} - {""}
        text = module_text(query, folders, roots)
    if query.next == TOGETHER:
        either = " \\/ ".join(query.actions)
        following = f"({either}) /\\ {query.history}" if query.history else either
        text = text.replace("\n====\n", f"\n{TOGETHER} == {following}\n====\n")
    lacking = sorted({query.init, query.next, *query.formulas} - definitions(text))
    if lacking:
        raise ManifestError(f"query {query.name}: {query.module} does not define {', '.join(lacking)}")
    initializer = _initializer(query)
    if fixed := ", ".join(sorted(fixed_constants(text, initializer))):
        raise ManifestError(
            f"query {query.name}: {initializer} compares {fixed} by =; Apalache takes that as the only value, say \\in"
        )
    constants = "".join(f"    {name} <- {by}\n" for name, by in replaced.items())
    return bind_arguments(text), f"INIT {query.init}\nNEXT {query.next}\n" + (
        f"CONSTANTS\n{constants}" if constants else ""
    )


def instances(root: Path, query: Query, text: str) -> dict[str, str]:
    """The modules of spec/ of which the query's module has an instance, with their texts. Raises OSError."""
    imported = Module(query.module, text.encode()).imports
    paths = [path for path in modules(root / "spec") if path.stem in imported]
    return {path.stem: bind_arguments(path.read_text(encoding="utf-8")) for path in paths}


def _mutate(root: Path, query: str, change: Mutation, folder: Path) -> None:
    """Write the changed module. Raises `ManifestError` where the text to replace is not there once."""
    path = folder / change.module
    source = path if path.exists() else next((root / "spec").rglob(change.module))
    text = source.read_text(encoding="utf-8")
    if text.count(change.replace) != 1:
        raise ManifestError(f"query {query}: {change.module} has not once the text {change.replace!r}")
    path.write_text(text.replace(change.replace, change.by), encoding="utf-8")
