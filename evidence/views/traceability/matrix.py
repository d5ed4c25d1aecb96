"""Each requirement beside its entries, or the reason why it has none."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from evidence.views.traceability.entries import Entries, entries
from evidence.views.traceability.modules import Definition, Module
from evidence.views.traceability.project import Project
from evidence.views.traceability.reasons import Column, Reason
from evidence.views.traceability.roles import lookups, rules

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
    """The entries of a requirement in a column; if there are none, the reason and its kind, if there is one."""

    entries: Entries = NOTHING
    kind: str = ""
    reason: str = ""

    @property
    def missing(self) -> bool:
        """Whether there is neither an entry nor a reason."""
        return not (self.entries.names or self.reason)


@dataclass(frozen=True)
class Row:
    """A requirement; `models` are the models that name it."""

    id: str
    cells: Mapping[Column, Cell]
    properties: tuple[Definition, ...]
    models: tuple[str, ...]


@dataclass(frozen=True)
class Matrix:
    """All requirements, and the formulas that look up each ambiguity."""

    rows: tuple[Row, ...]
    readings: Mapping[str, Cell]

    def cells(self) -> dict[str, Mapping[Column, Cell]]:
        """The cells of all requirements and ambiguities."""
        return {row.id: row.cells for row in self.rows} | {n: {READING: cell} for n, cell in self.readings.items()}


def counts(matrix: Matrix) -> list[tuple[str, int, int, int, int, int]]:
    """For each column, and for the ambiguities: how many requirements have an entry, of these only one that touches
    them, a reason, of these for work that is not done, and neither.
    """
    columns = {title: [row.cells[column] for row in matrix.rows] for column, title in COLUMNS.items()}
    columns["formula that looks an ambiguity up"] = list(matrix.readings.values())
    return [
        (
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
    """Put all sources side by side."""
    ruling = rules(project.spec)
    rows = tuple(_row(name, project, ruling) for name in project.requirements)
    readings = {
        name: _cell(_definitions(lookups(name, ruling)), project.reasons.get((name, READING)))
        for name in project.ambiguities
    }
    return Matrix(rows, readings)


def _row(name: str, project: Project, ruling: Sequence[Module]) -> Row:
    formulas = tuple(d for m in ruling for d in m.definitions if name in d.tags)
    properties = tuple(d for d in project.controls.properties if name in d.tags)
    found = {
        "formula": _definitions(formulas),
        "property": _definitions(properties),
        "model": project.controls.controls.get(name, NOTHING),
        "accepted": project.logs.accepted.get(name, NOTHING),
        "rejected": project.logs.rejected.get(name, NOTHING),
    }
    cells = {column: _cell(found[column], project.reasons.get((name, column))) for column in COLUMNS}
    texts = [m.left_out[name] for m in ruling if name in m.left_out]
    if texts and not formulas:  # a module may leave out a part that another module specifies: that excuses nothing
        cells = {column: Cell(NOTHING, MODULE, texts[0]) if cell.missing else cell for column, cell in cells.items()}
    return Row(name, cells, properties, project.controls.models.get(name, ()))


def _definitions(definitions: Sequence[Definition]) -> Entries:
    return entries([f"{d.module}.{d.name}" for d in definitions], [])


def _cell(found: Entries, reason: Reason | None) -> Cell:
    return Cell(found) if found.names or reason is None else Cell(NOTHING, reason.kind, reason.reason)
