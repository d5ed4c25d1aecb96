"""The requirements and ambiguities: the entries of docs/rules/requirements.md and docs/rules/readings.md."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from evidence.views.traceability.errors import UnreadableError
from s7check.report.clauses import Clause, questions_of, requirements_of


def read(path: Path) -> str:
    """The text of a document. Raises `UnreadableError`."""
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise UnreadableError(f"{path}: {error}") from error


def requirements(path: Path) -> dict[str, Clause]:
    """The requirements by their IDs, in their order. Raises `UnreadableError`."""
    return _clauses(path, requirements_of)


def ambiguities(path: Path) -> dict[str, Clause]:
    """The ambiguities by their IDs, each with its question and its letters. Raises `UnreadableError`."""
    return _clauses(path, questions_of)


def _clauses(path: Path, clauses_of: Callable[[str], list[Clause]]) -> dict[str, Clause]:
    try:
        return {clause.id: clause for clause in clauses_of(read(path))}
    except ValueError as error:
        raise UnreadableError(f"{path}: {error}") from error
