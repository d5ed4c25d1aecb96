"""The requirements and ambiguities: the tables of docs/rules/requirements.md and docs/rules/readings.md."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import msgspec

from evidence.traceability.errors import UnreadableError
from evidence.traceability.ids import AMBIGUITY, PREFIXES
from s7check.report.clauses import Clause

_REQUIREMENT = re.compile(rf'^\| <a id="((?:{"|".join(PREFIXES)})-\d+)"></a>\1 \|.*\|$', re.MULTILINE)
_QUESTION = re.compile(rf'^\| <a id="({AMBIGUITY}-\d+)"></a>\1 \|.*\|$', re.MULTILINE)
_CELL = re.compile(r"(?<!\\) *\| *")
_LETTER = re.compile(r"\(([a-d])\) (.*?)(?=;? \([a-d]\) |$)")


def read(path: Path) -> str:
    """The text of a document. Raises `UnreadableError`."""
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise UnreadableError(f"{path}: {error}") from error


def requirements(path: Path) -> tuple[Clause, ...]:
    """The requirements in their order. Raises `UnreadableError`, also where there are none."""
    rows = _rows(path, _REQUIREMENT, 3)
    return _distinct(path, [Clause(name, text, source, confidence) for name, (text, source, confidence) in rows])


def ambiguities(path: Path) -> tuple[Clause, ...]:
    """The ambiguities, each with its question and its letters. Raises `UnreadableError`, also where there are none."""
    rows = _rows(path, _QUESTION, 2)
    return _distinct(
        path, [Clause(name, text, letters=dict(_LETTER.findall(letters))) for name, (text, letters) in rows]
    )


def encoded(clauses: Sequence[Clause]) -> str:
    """The clauses as JSON, for the reports of ``s7check trace``."""
    return msgspec.json.format(msgspec.json.encode(clauses), indent=1).decode() + "\n"


def _rows(path: Path, pattern: re.Pattern[str], count: int) -> list[tuple[str, list[str]]]:
    """The ID of each row, and so many cells after it."""
    rows = [(row[1], _CELL.split(row[0])[2:-1][:count]) for row in pattern.finditer(read(path))]
    for name, cells in rows:
        if len(cells) < count:
            raise UnreadableError(f"{path}: {name}: expected {count} cells after the ID, found {len(cells)}")
    return rows


def _distinct(path: Path, clauses: list[Clause]) -> tuple[Clause, ...]:
    ids = [clause.id for clause in clauses]
    twice = [name for name in ids if ids.count(name) > 1]
    if twice:
        raise UnreadableError(f"{path}: {twice[0]} has more than one row")
    if not ids:
        raise UnreadableError(f"{path}: no rows")
    return tuple(clauses)
