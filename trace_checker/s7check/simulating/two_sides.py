"""Two timelines side by side, and the first line that one side does not allow."""

from __future__ import annotations

from itertools import zip_longest
from typing import Any

from s7check.asking.line_text import spelled
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.report.report import clause_text
from s7check.simulating.separation import Separation, log_of

_WIDTH = 76


def difference_text(found: Separation, mine: list[dict[str, Any]], other: list[dict[str, Any]]) -> list[str]:
    """The timelines of both sides, the line that differs, and the clauses; ``mine`` is that of the side that allows."""
    line = found.log[-1]
    instead = ", ".join(one.text for one in found.refusal.expected) or "nothing"
    before = "before it had to come" if found.refusal.late else "it allows"
    return [
        *side_by_side(found.allowed.name, mine, found.refused.name, other, found.line),
        f"first difference: {line['at']} {spelled(line)}",
        f"  {found.allowed.name} allows it: {', '.join(found.grounds)}",
        f"  {found.refused.name} does not ({before}: {instead}): {', '.join(found.refusal.requirements)}",
        *(f"    {clause_text(name)}" for name in sorted({*found.grounds, *found.refusal.requirements})),
    ]


def log_of_refused(engine: Engine, found: Separation) -> list[dict[str, Any]]:
    """The log that the other side makes of the program; where it goes another way, what it has in place of the line."""
    before = found.log[1:-1]
    try:
        log = log_of(engine, found.program, found.refused)
    except EngineError:
        log = []
    if len(log) > len(before) + 1 and log[1 : len(before) + 1] == before and log[len(before) + 1] != found.log[-1]:
        return log
    instead = ", ".join(one.text for one in found.refusal.expected) or "nothing"
    late = "had to come before: " if found.refusal.late else "in its place: "
    return [found.header, *before, {"at": found.log[-1]["at"], "event": f"({late}{instead})"}]


def side_by_side(
    first: str, mine: list[dict[str, Any]], second: str, other: list[dict[str, Any]], mark: int
) -> list[str]:
    """The lines of two logs in two columns; ``mark`` is the number of the line that differs."""
    rows = [(first, second), *((_told(a), _told(b)) for a, b in zip_longest(mine[1:], other[1:]))]
    width = min(_WIDTH, max(len(a) for a, _ in rows))
    return [
        f"{'>' if number == mark else ' '} {a[:width].ljust(width)} | {b}".rstrip()
        for number, (a, b) in enumerate(rows, 1)
    ]


def _told(line: dict[str, Any] | None) -> str:
    return "" if line is None else f"{line['at']} {spelled(line)}"
