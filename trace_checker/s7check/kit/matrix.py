"""Requirements and implementations: a page in Markdown from the results of several runs of the kit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from s7check.kit.results import UNDER_ANOTHER, Outcome
from s7check.report.clauses import clause, page_of

_MARKS = {"passed": "passed", "failed": "**failed**", "skipped": "skipped", "not reached": ""}
_MARKS[UNDER_ANOTHER] = UNDER_ANOTHER
SHOWN = 3
"""Failed programs that are named for a requirement."""


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
        failed = [one for one in outcomes.values() if one.state == "failed"]
        if failed:
            lines += ["", f"## Failed on {name}", ""]
            lines += [f"* {one.requirement}: {_programs(one)}. {clause(one.requirement).text}" for one in failed]
    return "\n".join(lines) + "\n"


def _page(requirement: str) -> str:
    return f"{page_of(requirement)}#{requirement}"


def _cell(outcome: Outcome | None) -> str:
    return _MARKS[outcome.state] if outcome is not None else ""


def _programs(outcome: Outcome) -> str:
    more = len(outcome.failed) - SHOWN
    shown = ", ".join(f"`{name}`" for name in outcome.failed[:SHOWN])
    return shown + (" and others" if more > 0 else "")
