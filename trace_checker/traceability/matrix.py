"""Each requirement beside what it has, and what is missing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from trace_checker.traceability.entries import Entries, entries
from trace_checker.traceability.modules import Definition, Module
from trace_checker.traceability.project import READINGS, REASONS, Project
from trace_checker.traceability.reasons import Column, Reason, named

COLUMNS: dict[Column, str] = {
    "formula": "formula",
    "property": "property that a model checks",
    "model": "model that would fail without it",
    "accepted": "accepted log",
    "rejected": "rejected log",
}
READING: Column = "reading"
NOT_DONE = "not done"
MODULE = "module"
"""The kind of a reason that the box of a module gives."""


NOTHING = Entries()


@dataclass(frozen=True)
class Cell:
    """What a requirement has in a column; where that is nothing, the reason for it and its kind, if there is one."""

    entries: Entries = NOTHING
    kind: str = ""
    reason: str = ""

    @property
    def missing(self) -> bool:
        """Whether there is neither an entry nor a reason."""
        return not (self.entries.names or self.reason)


@dataclass(frozen=True)
class Row:
    """A requirement; `models` are those that say they show it."""

    id: str
    cells: Mapping[Column, Cell]
    formulas: tuple[Definition, ...]
    properties: tuple[Definition, ...]
    models: tuple[str, ...]


@dataclass(frozen=True)
class Matrix:
    """All requirements, the formulas that look up each ambiguity, and everything that is wrong."""

    rows: tuple[Row, ...]
    readings: Mapping[str, Cell]
    problems: tuple[str, ...]


@dataclass(frozen=True)
class Count:
    """How many requirements have an entry, of these only one that touches them, a reason, of these for work that is not
    done, and neither.
    """

    name: str
    filled: int
    indirect: int
    excused: int
    not_done: int
    missing: int


def counts(matrix: Matrix) -> list[Count]:
    """One count a column, and one for the ambiguities."""
    columns = {title: [row.cells[column] for row in matrix.rows] for column, title in COLUMNS.items()}
    columns["formula that looks an ambiguity up"] = list(matrix.readings.values())
    return [
        Count(
            title,
            sum(bool(cell.entries.names) for cell in cells),
            sum(bool(cell.entries.names) and not cell.entries.direct for cell in cells),
            sum(bool(cell.reason) for cell in cells),
            sum(cell.kind == NOT_DONE for cell in cells),
            sum(cell.missing for cell in cells),
        )
        for title, cells in columns.items()
    ]


def build(project: Project) -> Matrix:
    """Put side by side what was read."""
    rules = [m for m in project.spec if m.states_rules]
    rows = tuple(_row(name, project, rules) for name in project.requirements)
    lookups = {
        name: _definitions([d for m in rules for d in m.definitions if name in d.readings])
        for name in project.ambiguities
    }
    readings = {name: _cell(found, project.reasons.get((name, READING))) for name, found in lookups.items()}
    problems = [
        *_gaps(rows, readings),
        *_unknown(project),
        *_gaps_in_numbers(list(project.ambiguities)),
        *_unchecked(project.controls.unchecked),
        *_void_reasons(project, rows, readings),
        *_pointing_nowhere(project),
    ]
    return Matrix(rows, readings, tuple(problems))


def _row(name: str, project: Project, rules: Sequence[Module]) -> Row:
    formulas = tuple(d for m in rules for d in m.definitions if name in d.tags)
    properties = tuple(d for d in project.controls.properties if name in d.tags)
    found = {
        "formula": _definitions(formulas),
        "property": _definitions(properties),
        "model": project.controls.controls.get(name, NOTHING),
        "accepted": project.logs.accepted.get(name, NOTHING),
        "rejected": project.logs.rejected.get(name, NOTHING),
    }
    cells = {column: _cell(found[column], project.reasons.get((name, column))) for column in COLUMNS}
    texts = [m.left_out[name] for m in rules if name in m.left_out]
    if texts and not formulas:  # a part that a module leaves out of what another one specifies excuses nothing
        cells = {column: Cell(NOTHING, MODULE, texts[0]) if cell.missing else cell for column, cell in cells.items()}
    return Row(name, cells, formulas, properties, project.controls.models.get(name, ()))


def _definitions(definitions: Sequence[Definition]) -> Entries:
    return entries([f"{d.module}.{d.name}" for d in definitions], [])


def _cell(found: Entries, reason: Reason | None) -> Cell:
    return Cell(found) if found.names or reason is None else Cell(NOTHING, reason.kind, reason.reason)


def _gaps(rows: Sequence[Row], readings: Mapping[str, Cell]) -> list[str]:
    gaps = [f"{row.id}: no {COLUMNS[column]}" for row in rows for column, cell in row.cells.items() if cell.missing]
    return gaps + [f"{name}: no formula looks its letter up" for name, cell in readings.items() if cell.missing]


def _unknown(project: Project) -> list[str]:
    known = {*project.requirements, *project.ambiguities}
    return [
        f"{path}: {name} does not exist" for path, names in project.cited.items() for name in names if name not in known
    ]


def _gaps_in_numbers(ambiguities: Sequence[str]) -> list[str]:
    """Ambiguities are numbered through, so that a row that is lost can be seen."""
    numbers = [0, *sorted(int(name.split("-")[1]) for name in ambiguities)]
    return [f"{READINGS}: no AMB-{n:02}" for low, high in pairwise(numbers) for n in range(low + 1, high)]


def _unchecked(definitions: Sequence[Definition]) -> list[str]:
    return [f"{d.module}.{d.name}: names {', '.join(d.tags)}, and no model checks it" for d in definitions]


def _void_reasons(project: Project, rows: Sequence[Row], readings: Mapping[str, Cell]) -> list[str]:
    cells = {(row.id, column): cell for row in rows for column, cell in row.cells.items()}
    cells |= {(name, READING): cell for name, cell in readings.items()}
    return [
        f"{REASONS}: {name}: the reason for no {column} is void, there is {cells[name, column].entries.names[0]}"
        if (name, column) in cells
        else f"{REASONS}: {name} has no column {column}"
        for name, column in project.reasons
        if (name, column) not in cells or cells[name, column].entries.names
    ]


def _pointing_nowhere(project: Project) -> list[str]:
    """A reason that points to another formula, control or log is worth no more than what it points to."""
    known = {d.name for d in project.controls.properties} | project.controls.names | project.logs.files
    reasons = dict.fromkeys(project.reasons.values())
    return [
        f"{REASONS}: {reason.ids[0]}: {name} does not exist, or no model checks it"
        for reason in reasons
        for name in named(reason.reason)
        if name not in known
    ]
