"""The lists of what there is: the tables of docs/rules/requirements.md and docs/rules/readings.md."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from evidence.traceability.errors import UnreadableError
from evidence.traceability.ids import AMBIGUITY, PREFIXES

_REQUIREMENT = re.compile(rf"^\| ((?:{'|'.join(PREFIXES)})-\d+) \|.*\|$", re.MULTILINE)
_QUESTIONS = re.compile(r"^\| AMB \| question \|.*\n((?:\|.*\n?)+)", re.MULTILINE)
_QUESTION = re.compile(r"^\| (\d+) \| ([^|]*) \|", re.MULTILINE)


def read(path: Path) -> str:
    """The text of a document. Raises `UnreadableError`."""
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise UnreadableError(f"{path}: {error}") from error


def requirements(path: Path) -> tuple[str, ...]:
    """The IDs of the requirements in their order. Raises `UnreadableError`, also where there are none."""
    return _distinct(path, _REQUIREMENT.findall(read(path)))


def ambiguities(path: Path) -> dict[str, str]:
    """The ambiguities and their questions. Raises `UnreadableError`, also where there are none."""
    table = _QUESTIONS.search(read(path))
    rows = _QUESTION.findall(table[1]) if table else []
    ids = _distinct(path, [f"{AMBIGUITY}-{number}" for number, _ in rows])
    return dict(zip(ids, (question for _, question in rows), strict=True))


def _distinct(path: Path, ids: list[str]) -> tuple[str, ...]:
    twice = [name for name in ids if ids.count(name) > 1]
    if twice:
        raise UnreadableError(f"{path}: {twice[0]} has more than one row")
    if not ids:
        raise UnreadableError(f"{path}: no rows")
    return tuple(ids)


def with_places(text: str, place: Callable[[str], str]) -> str:
    """The text of docs/rules/requirements.md with another last cell in the row of each requirement."""

    def row(found: re.Match[str]) -> str:
        cells = found[0].split(" | ")
        return " | ".join([*cells[:-1], f"{place(found[1])} |"])

    return _REQUIREMENT.sub(row, text)
