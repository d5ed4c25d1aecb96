"""Requirements and implementations: a page in Markdown from the results of several runs of the kit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from s7check.kit.results import UNDER_ANOTHER, Outcome
from s7check.report.clauses import clause, page_of

_MARKS = {"passed": "passed", "failed": "**failed**", "skipped": "skipped", "not reached": ""}
_MARKS[UNDER_ANOTHER] = UNDER_ANOTHER
SHOWN = 3
"""Programs that are named for a requirement that failed, or passed under another reading."""


def to_matrix(runs: Mapping[str, Sequence[Outcome]]) -> str:
    """A row for each requirement, a column for each implementation, and what failed."""
    by_name = {name: {one.requirement: one for one in outcomes} for name, outcomes in runs.items()}
    order = list(dict.fromkeys(one.requirement for outcomes in runs.values() for one in outcomes))
    lines = [
        "# Implementations and requirements",
        "",
        "Made by `s7check kit matrix` from runs of the [conformance kit](kit.md). Empty: not reached.",
        "",
        f"| requirement | {' | '.join(runs)} |",
        f"|---{'|---' * len(runs)}|",
    ]
    for requirement in order:
        cells = [_cell(outcomes.get(requirement)) for outcomes in by_name.values()]
        lines.append(f"| [{requirement}](../rules/{_page(requirement)}) | {' | '.join(cells)} |")
    for name, outcomes in by_name.items():
        for state in ("failed", UNDER_ANOTHER):
            some = [one for one in outcomes.values() if one.state == state]
            if some:
                lines += ["", f"## {state[:1].upper()}{state[1:]} on {name}", ""]
                lines += [f"* {one.requirement}: {_programs(one)}. {clause(one.requirement).text}" for one in some]
    return "\n".join(lines) + "\n"


def _page(requirement: str) -> str:
    return f"{page_of(requirement)}#{requirement}"


def _cell(outcome: Outcome | None) -> str:
    return _MARKS[outcome.state] if outcome is not None else ""


def _programs(outcome: Outcome) -> str:
    names = outcome.failed or outcome.under
    more = len(names) - SHOWN
    shown = ", ".join(f"`{name}`" for name in names[:SHOWN])
    return shown + (" and others" if more > 0 else "")
