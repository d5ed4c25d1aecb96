"""The output: a table, each difference, and all of it as JSON."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from rich.console import Console

from evidence.common.console import columns, plain
from evidence.common.reasons import Excuse
from evidence.logs.since import Comparison, Difference


@dataclass(frozen=True)
class Explained:
    """All comparisons with an earlier `commit`, the expected differences by id, and the entries that fit nothing."""

    commit: str
    comparisons: Sequence[Comparison]
    expected: Mapping[str, Excuse]
    stale: Sequence[Excuse]

    def unexpected(self, comparison: Comparison) -> list[Difference]:
        """The differences that nothing explains."""
        return [one for one in comparison.differences if one.id not in self.expected]

    @property
    def ok(self) -> bool:
        """Whether every difference is expected."""
        return not any(map(self.unexpected, self.comparisons))


def show(console: Console, explained: Explained) -> None:
    """Show the table, then notes and differences."""
    counted = ("same", "of these moved", "differ", "expected", "new")
    table = columns([f"since {explained.commit[:12]}"], counted)
    for one in explained.comparisons:
        unexpected = len(explained.unexpected(one))
        counts = (one.same, one.moved, unexpected, len(one.differences) - unexpected, one.new)
        table.add_row(one.what, *(f"{count:,}" for count in counts))
    console.print(table)
    for one in explained.comparisons:
        for note in one.notes:
            plain(console, f"note: {note}")
        for difference in one.differences:
            reason = explained.expected.get(difference.id)
            said = f"{difference.id}: {difference.text}"
            plain(console, f"expected: {said} ({reason.reason})" if reason else said, style=None if reason else "red")
    for entry in explained.stale:
        plain(console, f"note: {entry.id}: expected to differ, and nothing does")
    plain(console, "no unexpected difference" if explained.ok else "UNEXPECTED DIFFERENCES")


def as_json(explained: Explained) -> dict[str, Any]:
    """Return everything as a JSON document."""
    return {
        "ok": explained.ok,
        "since": explained.commit,
        "compared": [
            {
                "what": one.what,
                "same": one.same,
                "moved": one.moved,
                "new": one.new,
                "differences": [
                    {"id": d.id, "text": d.text, "expected": d.id in explained.expected} for d in one.differences
                ],
                "notes": one.notes,
            }
            for one in explained.comparisons
        ],
    }
