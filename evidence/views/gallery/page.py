"""docs/rules/gallery.md, as text."""

from __future__ import annotations

from evidence.common.gallery import Case, cases
from s7check.report.clauses import page_of

_INTRODUCTION = """# Gallery of edge cases

Each case is a shortest behaviour of the specification that fulfils the predicates of the case. It is the shortest in a
small world: [cases.txt](../../gallery/cases.txt) says which OBs, times and interventions of program and world TLC may
use, and has the logs. `s7spec views gallery` finds all cases again. `s7check explore` opens each by one click: its
timeline, the events that may come at any line, and why others may not. [review.md](review.md) tells eighteen longer
cases step by step.
"""


def page() -> str:
    """The page of the cases: each with its text, its requirements and its log."""
    parts = [_INTRODUCTION]
    for case in cases():
        heading = f'## <a id="{case.name}"></a>{case.title}'
        parts.append(f"{heading}\n\n{case.told}\n\n{_clauses(case)}\n")
    return "\n".join(parts)


def _clauses(case: Case) -> str:
    return ", ".join(f"[{name}]({page_of(name)}#{name})" for name in case.requirements)
