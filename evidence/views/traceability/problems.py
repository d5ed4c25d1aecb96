"""Everything for which the check fails, but for pages that are not up to date."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby, pairwise

from evidence.views.traceability.ids import AMBIGUITIES
from evidence.views.traceability.matrix import COLUMNS, READING, Matrix
from evidence.views.traceability.project import READINGS, REASONS, Project
from evidence.views.traceability.reasons import named


def problems(project: Project, matrix: Matrix) -> list[str]:
    """A line for each."""
    return [
        *_gaps(matrix),
        *_unknown(project),
        *_gaps_in_numbers(list(project.ambiguities)),
        *_void_reasons(project, matrix),
        *_pointing_nowhere(project),
    ]


def notes(project: Project) -> list[str]:
    """Remarks that fail nothing: statements with requirements that do not count, since no model checks them."""
    unchecked = groupby(project.controls.unchecked, key=lambda d: d.module)
    return [f"{module}: no model checks {', '.join(d.name for d in found)}" for module, found in unchecked]


def _gaps(matrix: Matrix) -> list[str]:
    lacking = COLUMNS | {READING: "formula that looks its letter up"}
    return [
        f"{name}: no {lacking[column]}"
        for name, cells in matrix.cells().items()
        for column, cell in cells.items()
        if cell.missing
    ]


def _unknown(project: Project) -> list[str]:
    known = {*project.requirements, *project.ambiguities}
    return [
        f"{path}: {name} does not exist" for path, names in project.cited.items() for name in names if name not in known
    ]


def _gaps_in_numbers(ambiguities: Sequence[str]) -> list[str]:
    """Ambiguities are numbered through, so that a row that is lost can be seen."""
    return [
        f"{READINGS}: no {prefix}-{n:02}"
        for prefix in AMBIGUITIES
        for low, high in pairwise([0, *sorted(int(n.split("-")[1]) for n in ambiguities if n.startswith(prefix))])
        for n in range(low + 1, high)
    ]


def _void_reasons(project: Project, matrix: Matrix) -> list[str]:
    cells = {(name, column): cell for name, row in matrix.cells().items() for column, cell in row.items()}
    return [
        f"{REASONS}: {name}: the reason for no {column} is void, there is {cells[name, column].entries.names[0]}"
        if (name, column) in cells
        else f"{REASONS}: {name} has no column {column}"
        for name, column in project.reasons
        if (name, column) not in cells or cells[name, column].entries.names
    ]


def _pointing_nowhere(project: Project) -> list[str]:
    """A reason may point to a formula, a control or a log, which must then be there."""
    known = {d.name for d in project.controls.properties} | project.controls.names | project.logs.places.keys()
    reasons = dict.fromkeys(project.reasons.values())
    return [
        f"{REASONS}: {reason.ids[0]}: {name} does not exist, or no model checks it"
        for reason in reasons
        for name in named(reason.reason)
        if name not in known
    ]
