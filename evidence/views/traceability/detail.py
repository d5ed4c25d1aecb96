"""Where single requirements and ambiguities are treated, with files and lines, as text."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from evidence.views.traceability.matrix import Cell, Matrix
from evidence.views.traceability.modules import Definition
from evidence.views.traceability.project import MODELS, Project
from evidence.views.traceability.reasons import Column
from s7check.resources import modules


def detail(root: Path, project: Project, matrix: Matrix, ids: Sequence[str]) -> str:
    """The entries of these IDs, a line for each. Raises ValueError for an ID that does not exist."""
    rows = matrix.cells()
    unknown = [name for name in ids if name not in rows]
    if unknown:
        raise ValueError(f"{unknown[0]}: no such requirement or ambiguity")
    places = _places(root, project) | project.logs.places
    lines = []
    for name in ids:
        lines.append(name)
        lines += [line for column, cell in rows[name].items() for line in _lines(column, cell, places)]
    return "\n".join(lines)


def _places(root: Path, project: Project) -> dict[str, str]:
    """File and line of each definition."""
    definitions: list[Definition] = [d for module in project.spec for d in module.definitions]
    definitions += project.controls.properties
    files = {path.stem: path.relative_to(root) for folder in ("spec", MODELS) for path in modules(root / folder)}
    return {f"{d.module}.{d.name}": f"{files[d.module]}:{d.line}: {d.name}" for d in definitions}


def _lines(column: Column, cell: Cell, places: dict[str, str]) -> list[str]:
    if not cell.entries.names:
        return [f"  {column:9} {f'[{cell.kind}] {cell.reason}' if cell.reason else 'missing'}"]
    if column == "model":
        return [f"  {column:9} {MODELS}: {entry}" for entry in cell.entries.names]
    return [f"  {column:9} {places[entry]}" for entry in cell.entries.names]
