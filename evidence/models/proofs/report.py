"""The table and the JSON of the proofs."""

from __future__ import annotations

from typing import Any

from rich.console import Console
from rich.table import Table

from evidence.models.proofs.kept import Result
from evidence.models.proofs.making import FOLLOWS, Query
from evidence.models.proofs.queries import Proofs
from evidence.models.proofs.runner import ok

Answers = list[tuple[Query, Result]]


def assumptions(proofs: Proofs) -> str:
    """What every result of the induction assumes, in a sentence."""
    base = proofs.file.induction
    world, smaller = base.world, base.smaller
    elsewhere = "; ".join(f"{', '.join(a.formulas)} of {', '.join(a.actions)} by {a.name}" for a in base.apart)
    return (
        f"One step of System from any state in which {base.invariants[0]} holds, in the world of "
        f"models/{base.module}.tla, "
        f"with at most {world.waiting} start events that wait and {world.running} OBs that run before the step, "
        f"or {smaller.waiting} and {smaller.running} in the queries of letters, refinements and other families; "
        f"{elsewhere}; "
        "the calendar by its lemma; readings by default, of another family by its letters; "
        "by any letter in the queries called letters-."
    )


def as_json(proofs: Proofs, answers: Answers) -> dict[str, Any]:
    """The document that ``--json`` writes."""
    return {
        "assumptions": assumptions(proofs),
        "apalache": next((result.version for _, result in answers if result.version), ""),
        "queries": [
            {
                "name": query.name,
                "kind": query.kind,
                "actions": list(query.actions),
                "formulas": list(query.formulas),
                "expect": query.expect,
                "outcome": result.answer.outcome,
                "ok": ok(query, result),
                "conditions": result.answer.checked,
                "transitions": result.answer.taken,
                "detail": result.answer.detail,
                "seconds": result.seconds,
                "megabytes": result.megabytes,
            }
            for query, result in answers
        ],
        "formulas": standing(proofs, answers),
        "not_proved": [
            {
                "action": cell.action,
                "formula": f"{cell.formula}, {cell.letter}" if cell.letter else cell.formula,
                "tried": cell.tried,
                "log": cell.control if cell in proofs.contradicted else "",
            }
            for cell in proofs.file.not_proved
        ],
    }


def standing(proofs: Proofs, answers: Answers) -> list[dict[str, Any]]:
    """Each property with the actions of which it is proved, of which it is not claimed, and of which nobody knows yet.

    A property of states is proved of an action with the invariants from which it follows.
    """
    base = proofs.file.induction
    holds = {query.name: query for query, result in answers if result.answer.outcome == "holds"}
    proved = [(set(query.formulas), query.actions) for query in holds.values() if query.kind == "step"]
    left = {(cell.action, cell.formula) for cell in proofs.file.not_proved if not cell.letter}
    rows = []
    for kind, modules in (("steps", proofs.steps), ("states", proofs.states)):
        for module, names in modules.items():
            for name in names:
                needed = {name} if kind == "steps" else set(base.invariants)
                whole = kind == "steps" or ("first" in holds and FOLLOWS in holds and name in holds[FOLLOWS].formulas)
                of = {action for formulas, actions in proved if whole and needed <= formulas for action in actions}
                not_claimed = [action for action in proofs.actions if (action, name) in left]
                not_claimed += ["any state"] if (FOLLOWS, name) in left else []
                unknown = [action for action in proofs.actions if action not in of and action not in not_claimed]
                unknown = [] if (FOLLOWS, name) in left else unknown
                row = {"formula": name, "module": module, "of": kind, "proved": len(of), "actions": len(proofs.actions)}
                rows.append(row | {"not claimed": not_claimed, "unknown": unknown})
    return rows


def show(console: Console, proofs: Proofs, answers: Answers) -> None:
    """Print the table, each answer that differs with its counterexample, and what is not claimed of what was asked."""
    console.print(assumptions(proofs), markup=False, highlight=False)
    table = Table("query", "kind", "claimed", "answer", "conditions", "seconds", "MB")
    for query, result in answers:
        numbers = (str(result.answer.checked), f"{result.seconds:.0f}", str(result.megabytes))
        table.add_row(query.name, query.kind, query.expect, result.answer.outcome, *numbers)
    console.print(table)
    for query, result in answers:
        if not ok(query, result):
            where = f"; counterexample: {result.answer.trace}" if result.answer.trace else ""
            said = f"{query.name}: {result.answer.outcome}: {result.answer.detail}{where}"
            console.print(said, markup=False, highlight=False, soft_wrap=True)
    asked = {name for query, _ in answers for name in (query.name, *query.actions)}
    for cell in (one for one in proofs.file.not_proved if one.action in asked):
        formula = f"{cell.formula} by {cell.letter}" if cell.letter else cell.formula
        console.print(f"not proved: {formula} of {cell.action}: {cell.tried}", markup=False, soft_wrap=True)
