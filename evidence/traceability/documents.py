"""The lists of what there is: the tables of docs/rules/requirements.md and docs/rules/readings.md."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from evidence.traceability.errors import UnreadableError
from evidence.traceability.ids import AMBIGUITY, PREFIXES

_REQUIREMENT = re.compile(rf'^\| <a id="((?:{"|".join(PREFIXES)})-\d+)"></a>\1 \|.*\|$', re.MULTILINE)
_QUESTION = re.compile(rf'^\| <a id="({AMBIGUITY}-\d+)"></a>\1 \| ([^|]*) \|', re.MULTILINE)


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
    rows: list[tuple[str, str]] = _QUESTION.findall(read(path))
    _distinct(path, [name for name, _ in rows])
    return dict(rows)


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
