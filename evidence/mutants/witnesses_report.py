"""The output: a table by module, the conditions without a witness, and all of it as JSON."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from rich.console import Console

from evidence.common.console import columns, plain, short
from evidence.common.reasons import Excuse, assign
from evidence.mutants.witnesses import Seen

COLUMNS = ("conditions", "by models", "by logs alone", "with reason", "without")


@dataclass(frozen=True)
class Explained:
    """Conditions and reasons side by side; `stale` are the reasons that fit nothing any more, and why."""

    seen: Sequence[Seen]
    reasons: dict[str, Excuse]
    stale: list[str]

    @property
    def ok(self) -> bool:
        """Whether everything has a witness or a reason, and every reason is needed."""
        return not self.stale and all(s.condition.id in self.reasons for s in self.seen if s.missing)


def explain(seen: Sequence[Seen], reasons: Iterable[Excuse], existing: Iterable[str]) -> Explained:
    """Find the reason of each condition without a witness. `existing` are the ids of all conditions."""
    lacking = [s.condition.id for s in seen if s.missing]
    found, gone, needless = assign(reasons, existing, lacking, [s.condition.id for s in seen])
    stale = [f"{reason.id}: there is no such condition" for reason in gone]
    stale += [f"{reason.id}: has its witness" for reason in needless]
    return Explained(seen, found, stale)


def show(console: Console, explained: Explained) -> None:
    """Show the table, the conditions without a witness, and the stale reasons."""
    table = columns(["module"], COLUMNS)
    for module in sorted({s.condition.module for s in explained.seen}):
        table.add_row(module, *map(str, numbers(explained, module).values()))
    total = numbers(explained)
    table.add_row("all", *map(str, total.values()))
    console.print(table)
    for one in explained.seen:
        if one.missing:
            _show_missing(console, one, explained.reasons.get(one.condition.id))
    for line in explained.stale:
        plain(console, f"stale reason: {line}", style="red")
    witnessed = total["by models"] + total["by logs alone"]
    plain(console, f"{witnessed} of {total['conditions']} conditions witnessed, {total['without']} without a reason")


def numbers(explained: Explained, module: str | None = None, kind: str | None = None) -> dict[str, int]:
    """Count the conditions of a module, of a kind, or all, by the headings of the table."""
    seen = [s for s in explained.seen if module in (None, s.condition.module) and kind in (None, s.condition.kind)]
    missing = [s for s in seen if s.missing]
    by_logs = sum(s.by_logs_alone for s in seen)
    reasons = sum(s.condition.id in explained.reasons for s in missing)
    counts = (len(seen), len(seen) - len(missing) - by_logs, by_logs, reasons, len(missing) - reasons)
    return dict(zip(COLUMNS, counts, strict=True))


def as_json(explained: Explained, models: Sequence[str], seconds: float) -> dict[str, Any]:
    """Return everything as a JSON document."""
    modules = sorted({s.condition.module for s in explained.seen})
    kinds = dict.fromkeys(s.condition.kind for s in explained.seen)
    return {
        "ok": explained.ok,
        "seconds": round(seconds, 1),
        "models": list(models),
        "all": numbers(explained),
        "modules": {module: numbers(explained, module) for module in modules},
        "kinds": {kind: numbers(explained, kind=kind) for kind in kinds},
        "stale": explained.stale,
        "conditions": [_condition_as_json(s, explained.reasons.get(s.condition.id)) for s in explained.seen],
    }


def _condition_as_json(seen: Seen, reason: Excuse | None) -> dict[str, Any]:
    condition = seen.condition
    return {
        "id": condition.id,
        "kind": condition.kind,
        "line": condition.line,
        "text": condition.text,
        "seen": {side: list(by) for side, by in seen.by.items()},
        "missing": list(seen.missing),
        "reason": reason.reason if reason else None,
    }


def _show_missing(console: Console, seen: Seen, reason: Excuse | None) -> None:
    condition = seen.condition
    sides = " or ".join(seen.missing)
    plain(console, f"never {sides}: {condition.id}", style=None if reason else "red")
    plain(console, f"  {condition.module}.tla:{condition.line}: {short(condition.text)}")
    plain(console, f"  {reason.reason}" if reason else "  NO REASON")
