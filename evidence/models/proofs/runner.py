"""Asking a query: its module and configuration, the run, and the answers that are kept for the next time."""

from __future__ import annotations

import re
import shutil
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import Literal

from msgspec import structs

from evidence.models.entries import Mutation
from evidence.models.proofs import apalache
from evidence.models.proofs.kept import KeptAnswers, Result, Run, keys, still, together, unanswered
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

Kept = Literal["nothing", "claimed", "all"]

CHECKED = "search.invariantFilter="
"""The conditions that are checked: those about states after the step, not before, where they are assumed."""

SOLVER = ("z3.smt.relevancy=0", "z3.smt.arith.solver=2")
"""With Z3's own choices a refinement takes two to three times as long, an action up to half as long again."""

UNFILTERED = "--discard-disabled=false"
"""Apalache checks the formulas of a transition without asking first if a state can take it. That the action can take a
step, its control says."""

PATIENCE = 90
"""So many seconds Z3 has for a condition among others. Where it finds no answer, the condition has a run of its own, in
which there is no limit: what stops Z3 is what else it was asked."""

_REPLACED = re.compile(r"^ +(\w+) *<- *(\w+)$", re.MULTILINE)


@dataclass(frozen=True)
class Asking:
    """Where queries are asked: the checkout, the folder for output, the kept answers, Apalache."""

    root: Path
    build: Path
    answers: KeptAnswers
    apalache: apalache.Apalache


@dataclass(frozen=True)
class _Made:
    """What Apalache reads for a query: its module, the configuration, the modules of which it has an instance."""

    text: str
    config: str
    instances: dict[str, str]


def ok(query: Query, result: Result) -> bool:
    """Whether the result is the expected one."""
    return result.answer.outcome == query.expect


def ask(asking: Asking, query: Query, kept: Kept = "nothing") -> Result:
    """Ask a query, or take the answers that are kept of the same texts.

    Of `kept` answers, "claimed" takes those that are as claimed and asks for the other formulas; "all" takes any, and
    asks nothing: where a formula has none, the outcome is "not asked".

    Raises `ManifestError`, `evidence.tla.syntax.SyntaxTreeError`, OSError,
    `evidence.common.processes.InterruptedRunError`, msgspec.MsgspecError.
    """
    runs = [] if kept == "nothing" else asking.answers.of(query.name)
    if kept == "all" and not runs:  # to make the text takes a second
        return together(query.name, dict.fromkeys(query.formulas, ""), runs, kept=True)
    made = _made(asking.root, query)
    now = _keys(query, made)
    runs = still(runs, now.values())
    if kept == "claimed":
        runs = [run for run in runs if run.answer.outcome == query.expect]
    lacking = unanswered(now, runs)
    if kept == "all" or not lacking:
        return together(query.name, now, runs, kept=True)
    asked = replace(query, formulas=lacking)
    first, late = _run(asking, asked, made if asked == query else _made(asking.root, asked), now)
    runs.append(first)
    for formula, conditions in late.items():
        asking.answers.put(query.name, [run for run in runs if run.keys])
        if runs[-1].answer.outcome == query.expect:
            run = _run_apart(asking, replace(query, formulas=(formula,)), conditions, now)
            runs.append(run if runs[-1].keys else _after(runs.pop(), run))
    asking.answers.put(query.name, runs)
    return together(query.name, now, runs, kept=False)


def _after(first: Run, run: Run) -> Run:
    """A run with what an earlier one found, which has no formula whose conditions all held in time."""
    answer = replace(run.answer, checked=first.answer.checked + run.answer.checked)
    return structs.replace(run, answer=answer, seconds=round(first.seconds + run.seconds, 1))


def _made(root: Path, query: Query) -> _Made:
    text, config = texts(root, query)
    return _Made(text, config, instances(root, query, text))


def _run(
    asking: Asking, query: Query, made: _Made, keys_now: Mapping[str, str]
) -> tuple[Run, dict[str, list[apalache.Late]]]:
    """Ask Apalache all formulas of the query; the run is about those of which no condition is late."""
    folder, files = _written(asking, query, made)
    names = _names(query)
    invariants = f"--inv={','.join(names.values())}"
    limit = [f"--timeout-smt={PATIENCE}"] if query.expect == "holds" else []
    asked_of = [[invariants, *limit, *_arguments(query, some), *files] for some in parts(query.divided)]
    done = asking.apalache.run(asked_of, folder, query.timeout)
    (folder / "log").write_text(done.output, encoding="utf-8")
    answer = apalache.answer(done, partial(apalache.interpret, asked=list(names.values())))
    found = apalache.late(done.outputs) if answer.outcome == "holds" else []
    late = {name: [one for one in found if one.formula == names[name]] for name in query.formulas}
    keys = tuple(keys_now[name] for name in query.formulas if not late[name])
    return _told(query, answer, [done], keys), {name: some for name, some in late.items() if some}


def _run_apart(asking: Asking, query: Query, late: Iterable[apalache.Late], keys_now: Mapping[str, str]) -> Run:
    """Ask the late conditions of the one formula of the query, each by itself; the others of it hold."""
    (formula,) = query.formulas
    folder, files = _written(asking, query, _made(asking.root, query))
    divided = parts(query.divided)
    runs, answers = [], []
    for one in late:
        arguments = [f"--inv={one.formula}", *_arguments(query, divided[one.run], one.condition), *files]
        done = asking.apalache.run([arguments], folder, query.timeout)
        runs.append(done)
        answers.append(apalache.answer(done, partial(apalache.settled, condition=one.condition)))
        if answers[-1].outcome != "holds":
            return _told(query, answers[-1], runs, (keys_now[formula],))
    checked, taken = sum(some.checked for some in answers), max(some.taken for some in answers)
    return _told(query, apalache.Answer("holds", checked, taken=taken), runs, (keys_now[formula],))


def _told(query: Query, answer: apalache.Answer, runs: Sequence[apalache.ApalacheRun], keys: tuple[str, ...]) -> Run:
    seconds, most = round(sum(run.seconds for run in runs), 1), max(run.megabytes for run in runs)
    today = datetime.now(UTC).date().isoformat()
    return Run(query.name, answer, seconds, most, apalache.version(runs[-1].output), today, keys)


def _written(asking: Asking, query: Query, made: _Made) -> tuple[Path, list[str]]:
    """The folder of a query, anew, and the arguments that name the files in it."""
    folder = asking.build / query.name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name, content in {query.module: made.text, **made.instances}.items():
        (folder / f"{name}.tla").write_text(content, encoding="utf-8")
    (folder / "query.cfg").write_text(made.config, encoding="utf-8")
    return folder, [f"--config={folder / 'query.cfg'}", str(folder / f"{query.module}.tla")]


def parts(divided: Sequence[int]) -> list[str]:
    """The transitions of each run, as one of Apalache's tuning options: up to the first number, then from each on.

    The last run takes all that follow. Empty where the action is not divided.
    """
    if not divided:
        return [""]
    before = [f"1->({'|'.join(map(str, range(*some)))})" for some in pairwise([0, *divided])]
    rest = f"1->(?!({'|'.join(map(str, range(divided[-1])))})$).*"
    return [f"search.transitionFilter=(0->.*|{some})" for some in [*before, rest]]


def _arguments(query: Query, transitions: str = "", condition: str = "") -> list[str]:
    """The arguments of Apalache that are the same for each formula; with a `condition` this one alone is checked."""
    stepping = query.kind != "claim" and query.length
    checked = [f"{CHECKED}{'1' if stepping else '.*'}->{condition.replace(' invariant ', '') or '.*'}"]
    tuning = [*SOLVER, *(checked if stepping or condition else []), *([transitions] if transitions else [])]
    return [
        *(f"--length={query.length}", "--no-deadlock=true"),
        *([f"--cinit={_initializer(query)}"] if query.constants else []),
        *([UNFILTERED] if query.unfiltered else []),
        f"--tuning-options={':'.join(tuning)}",
    ]


def _initializer(query: Query) -> str:
    """The operator that says which values the constants may have; empty where there are none."""
    return query.constants if query.shown is None else ANY_LETTERS


def _keys(query: Query, made: _Made) -> dict[str, str]:
    """The key of each formula of the query: all that Apalache reads for it.

    A violation is one whether or not Apalache was asked first which transitions a state can take.
    """
    others = [without_comments(other) for other in made.instances.values()]
    replaced = [word for pair in _REPLACED.findall(made.config) for word in pair]
    roots = [query.init, query.next, query.constants, ANY_LETTERS, *replaced]
    names = _names(query)
    arguments = _arguments(query if query.expect == "holds" else replace(query, unfiltered=False))
    found = keys(made.text, names.values(), roots, [*others, made.config, *arguments])
    return {formula: found[name] for formula, name in names.items()}


def _names(query: Query) -> dict[str, str]:
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
