"""Asking a query: the runs of Apalache, and the answers that are kept for the next time."""

from __future__ import annotations

import shutil
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import Literal

from msgspec import structs

from evidence.models.proofs import apalache
from evidence.models.proofs.kept import KeptAnswers, Pending, Result, Run, still, together, unanswered
from evidence.models.proofs.made import Made, arguments, keys_of, made, names_of, parts
from evidence.models.proofs.making import Query

Kept = Literal["nothing", "claimed", "all"]

PATIENCE = 90
"""So many seconds Z3 has for a condition among others. What stops it is what else it was asked, and luck."""

TRIES = 12
"""So often it is asked a condition alone to which it had no answer: by another seed each time, and after each four
with twice the time."""


@dataclass(frozen=True)
class Asking:
    """Where queries are asked: the checkout, the folder for output, the kept answers, Apalache."""

    root: Path
    build: Path
    answers: KeptAnswers
    apalache: apalache.Apalache


def ok(query: Query, result: Result) -> bool:
    """Whether the result is the expected one."""
    return result.answer.outcome == query.expect


def ask(asking: Asking, query: Query, kept: Kept = "nothing") -> Result:
    """Ask a query, or take the answers that are kept of the same texts.

    Of `kept` answers, "claimed" takes those that are as claimed and asks for the other formulas and conditions; "all"
    takes any, and asks nothing: where a formula has none, the outcome is "not asked".

    Raises `ManifestError`, `evidence.tla.syntax.SyntaxTreeError`, OSError,
    `evidence.common.processes.InterruptedRunError`, msgspec.MsgspecError.
    """
    runs = [] if kept == "nothing" else asking.answers.of(query.name)
    if kept == "all" and not runs:  # to make the text takes a second
        return together(query.name, dict.fromkeys(query.formulas, ""), runs, kept=True)
    whole = made(asking.root, query)
    now = keys_of(query, whole)
    runs = still(runs, now.values())
    if kept == "claimed":
        runs = [run for run in runs if run.answer.outcome == query.expect or run.pending]
    lacking = unanswered(now, runs)
    if kept == "all" or not lacking:
        return together(query.name, now, runs, kept=True)
    begun = {key for run in runs for key in run.keys}
    if new := tuple(name for name in lacking if now[name] not in begun):
        asked = replace(query, formulas=new)
        runs += _asked(asking, asked, whole if asked == query else made(asking.root, asked), now)
    for at, run in enumerate(runs):
        asking.answers.put(query.name, runs)
        if run.pending and all(some.pending or some.answer.outcome == query.expect for some in runs):
            (name,) = (name for name in lacking if now[name] in run.keys)
            runs[at] = _settled(asking, replace(query, formulas=(name,)), runs, at)
    asking.answers.put(query.name, runs)
    return together(query.name, now, runs, kept=False)


def _asked(asking: Asking, query: Query, text: Made, keys_now: Mapping[str, str]) -> list[Run]:
    """Ask Apalache all formulas of the query: a run about those that have an answer, and one for each other one."""
    folder, files = _written(asking, query, text)
    names = names_of(query)
    invariants = f"--inv={','.join(names.values())}"
    limit = [f"--timeout-smt={PATIENCE}"] if query.expect == "holds" else []
    transitions = parts(query.divided)
    asked_of = [[invariants, *limit, *arguments(query, some), *files] for some in transitions]
    done = asking.apalache.run(asked_of, folder, query.timeout)
    (folder / "log").write_text(done.output, encoding="utf-8")
    answer = apalache.answer(done, partial(apalache.interpret, asked=list(names.values())))
    late = apalache.late(done.outputs) if answer.outcome == "holds" else []
    behind = [name for name in query.formulas if names[name] in {one.formula for one in late}]
    run = _told(query, answer, done, [keys_now[name] for name in query.formulas if name not in behind])
    found = [run] if run.keys else []
    for name in behind:
        pending = [Pending(one.condition, transitions[one.run]) for one in late if one.formula == names[name]]
        checked = 0 if found else answer.checked
        lacking = replace(answer, outcome="not asked", checked=checked, detail=_lacking(pending))
        seconds = 0 if found else run.seconds
        found.append(
            structs.replace(run, answer=lacking, seconds=seconds, keys=(keys_now[name],), pending=tuple(pending))
        )
    return found


def _settled(asking: Asking, query: Query, runs: Sequence[Run], at: int) -> Run:
    """Ask the pending conditions of the one formula of the query, each by itself; what is found is kept at once."""
    folder, files = _written(asking, query, made(asking.root, query))
    (name,) = names_of(query).values()
    run = runs[at]
    for one in run.pending:
        done, answer = _tried(asking, query, one, [f"--inv={name}", *files], folder)
        if answer.outcome == "timeout":
            continue
        seconds = round(run.seconds + done.seconds, 1)
        if answer.outcome != "holds":
            return _told(query, answer, done, run.keys)
        pending = tuple(other for other in run.pending if other != one)
        checked = run.answer.checked + answer.checked
        outcome: apalache.Outcome = "not asked" if pending else "holds"
        answer = replace(run.answer, outcome=outcome, checked=checked, detail=_lacking(pending))
        most = max(run.megabytes, done.megabytes)
        run = structs.replace(run, answer=answer, seconds=seconds, megabytes=most, pending=pending)
        asking.answers.put(query.name, [*runs[:at], run, *runs[at + 1 :]])
    return run


def _tried(
    asking: Asking, query: Query, one: Pending, rest: Sequence[str], folder: Path
) -> tuple[apalache.ApalacheRun, apalache.Answer]:
    """Ask a condition by one seed after the other until there is an answer."""
    for seed in range(TRIES):
        limit = f"--timeout-smt={PATIENCE * 2 ** (seed // 4)}"
        asked = arguments(query, one.transitions, one.condition, seed)
        done = asking.apalache.run([[limit, *asked, *rest]], folder, query.timeout)
        answer = apalache.answer(done, partial(apalache.settled, condition=one.condition))
        if answer.outcome != "timeout":
            break
    return done, answer


def _lacking(pending: Sequence[Pending]) -> str:
    return f"Z3 has no answer yet about {', '.join(one.condition for one in pending)}" if pending else ""


def _told(query: Query, answer: apalache.Answer, done: apalache.ApalacheRun, keys: Sequence[str]) -> Run:
    version, today = apalache.version(done.output), datetime.now(UTC).date().isoformat()
    return Run(query.name, answer, done.seconds, done.megabytes, version, today, tuple(keys))


def _written(asking: Asking, query: Query, text: Made) -> tuple[Path, list[str]]:
    """The folder of a query, anew, and the arguments that name the files in it."""
    folder = asking.build / query.name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name, content in {query.module: text.text, **text.instances}.items():
        (folder / f"{name}.tla").write_text(content, encoding="utf-8")
    (folder / "query.cfg").write_text(text.config, encoding="utf-8")
    return folder, [f"--config={folder / 'query.cfg'}", str(folder / f"{query.module}.tla")]
