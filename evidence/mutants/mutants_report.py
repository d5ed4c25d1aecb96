"""The output: the list of mutants, progress, the score, the survivors, and all of it as JSON."""

from __future__ import annotations

import difflib
import threading
import time
from collections import Counter
from collections.abc import Sequence
from typing import Any

from rich.console import Console

from evidence.common.console import columns, plain, short
from evidence.mutants.bench import Verdict
from evidence.mutants.findings import KILLS
from evidence.mutants.listing import Mutant
from evidence.mutants.survivors import Explained
from evidence.tla.syntax import Module


def show_list(console: Console, mutants: Sequence[Mutant]) -> None:
    """Show each mutant on a line, and how many there are by kind and module."""
    for mutant in mutants:
        plain(console, f"{mutant.id}  {change(mutant)}")
    modules = sorted({m.module for m in mutants})
    count = Counter((m.kind, m.module) for m in mutants)
    rows = [("", *modules, "all")]
    for kind in sorted({m.kind for m in mutants}):
        row = [count[kind, module] for module in modules]
        rows.append((kind, *map(str, row), str(sum(row))))
    sums = [sum(m.module == module for m in mutants) for module in modules]
    rows.append(("all", *map(str, sums), str(len(mutants))))
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for first, *others in rows:
        cells = [cell.rjust(width) for cell, width in zip(others, widths[1:], strict=True)]
        plain(console, "  ".join([first.ljust(widths[0]), *cells]))


def show_difference(console: Console, mutant: Mutant, module: Module) -> None:
    """Show the change of a mutant, with the lines around it."""
    old, new = (text.decode().splitlines() for text in (module.text, mutant.text))
    file = f"{module.name}.tla"
    plain(console, "\n".join([mutant.id, *difflib.unified_diff(old, new, file, file, lineterm="")]))


def change(mutant: Mutant) -> str:
    """Return the change and its place on one line."""
    return f"{mutant.module}.tla:{mutant.line}: {short(mutant.was)} -> {short(mutant.by)}"


class Progress:
    """A line for each mutant, with the time that is left. Called from several threads."""

    def __init__(self, console: Console, total: int) -> None:
        """Show the progress of `total` mutants."""
        self._console = console
        self._total = total
        self._done = 0
        self._began = time.monotonic()
        self._lock = threading.Lock()

    def __call__(self, verdict: Verdict) -> None:
        """Show the verdict about a mutant."""
        with self._lock:
            self._done += 1
            spent = time.monotonic() - self._began
            left = spent / self._done * (self._total - self._done)
            said = f"{verdict.how} {verdict.by}".rstrip()
            plain(
                self._console,
                f"[{self._done}/{self._total}, {left / 60:.0f} min left] {verdict.mutant.id}: {said}, "
                f"{verdict.seconds:.1f} s",
            )


def show_kit(console: Console, score: dict[str, Any]) -> None:
    """Show how many of the mutants that an accepted log shows the kit shows, and which it does not."""
    for name in score["missed"]:
        plain(console, f"shown by a shipped log, not by the kit: {name}")
    plain(
        console,
        f"{score['by_kit']} of {score['shown']} mutants that an accepted log shows ({_percent(score['share'])}); "
        f"{score['shown_by_none']} of {score['mutants']} none shows, {score['invalid']} are no specification",
    )


def show(console: Console, explained: Explained) -> None:
    """Show the table by module, the survivors, and the score."""
    table = columns(["module"], [*_COLUMNS, "score"])
    rows = {v.mutant.module: numbers(explained, v.mutant.module) for v in explained.verdicts}
    for module, row in sorted(rows.items()):
        table.add_row(module, *(str(row[c]) for c in _COLUMNS), _percent(row["score"]))
    row = numbers(explained)
    table.add_row("all", *(str(row[c]) for c in _COLUMNS), _percent(row["score"]))
    console.print(table)
    for verdict in explained.verdicts:
        if verdict.how == "survived" and not explained.unevaluated(verdict):
            _show_survivor(console, verdict, explained)
    for line in explained.stale:
        plain(console, f"stale reason: {line}", style="red")
    by = " by properties alone" if explained.stated else ""
    plain(console, f"score{by} {_percent(row['score'])}: {row['killed']} of {row['counted']} mutants killed")


_COLUMNS = ("mutants", "invalid", "equivalent", "unevaluated", "killed", *KILLS, "survived")


def numbers(explained: Explained, module: str | None = None) -> dict[str, Any]:
    """Count the verdicts on a module's mutants, or on all. A score is None where no mutant counts.

    Where only properties kill, a mutant that no model evaluates does not count.
    """
    verdicts = [v for v in explained.verdicts if module in (None, v.mutant.module)]
    how: Counter[str] = Counter(v.how for v in verdicts)
    unevaluated = sum(map(explained.unevaluated, verdicts))
    equivalent = sum(explained.equivalent(v) and not explained.unevaluated(v) for v in verdicts)
    killed = sum(how[kill] for kill in KILLS)
    counted = len(verdicts) - how["invalid"] - equivalent - unevaluated
    return {
        "mutants": len(verdicts),
        "invalid": how["invalid"],
        "equivalent": equivalent,
        "unevaluated": unevaluated,
        "counted": counted,
        "killed": killed,
        **{kill: how[kill] for kill in KILLS},
        "survived": how["survived"] - equivalent - unevaluated,
        "score": round(killed / counted, 4) if counted else None,
    }


def as_json(explained: Explained, seconds: float) -> dict[str, Any]:
    """Return everything as a JSON document."""
    modules = sorted({v.mutant.module for v in explained.verdicts})
    return {
        "ok": explained.ok,
        "properties_alone": explained.stated,
        "seconds": round(seconds, 1),
        "all": numbers(explained),
        "modules": {module: numbers(explained, module) for module in modules},
        "stale": explained.stale,
        "mutants": [_mutant_as_json(v, explained) for v in explained.verdicts],
    }


def _mutant_as_json(verdict: Verdict, explained: Explained) -> dict[str, Any]:
    mutant = verdict.mutant
    reason = explained.reasons.get(mutant.id)
    return {
        "id": mutant.id,
        "line": mutant.line,
        "was": mutant.was,
        "by": mutant.by,
        "how": verdict.how,
        "check": verdict.by,
        "detail": verdict.detail,
        "seconds": round(verdict.seconds, 1),
        "got_past": list(verdict.evaluating),
        "reason": reason.reason if reason else None,
        "equivalent": explained.equivalent(verdict),
    }


def _show_survivor(console: Console, verdict: Verdict, explained: Explained) -> None:
    reason = explained.reasons.get(verdict.mutant.id)
    past = ", ".join(verdict.evaluating)
    plain(console, f"survivor {verdict.mutant.id}", style=None if reason or explained.stated else "red")
    plain(console, f"  {change(verdict.mutant)}")
    plain(console, f"  not noticed by {past}" if past else "  no check evaluates it")
    if verdict.detail:
        plain(console, f"  but {verdict.detail}")
    if reason:
        plain(console, f"  {'equivalent: ' if reason.equivalent else ''}{reason.reason}")
    elif not explained.stated:
        plain(console, "  NO REASON")


def _percent(score: float | None) -> str:
    return "-" if score is None else f"{score:.1%}"
