"""What may come next under one header and not, or otherwise, under another."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from s7check.asking.answers import Possible
from s7check.asking.line_text import spelled
from s7check.asking.rows import answer, when

_NOT = "not possible"


@dataclass(frozen=True)
class Difference:
    """Lines, by an ``example`` and the number of the ``others`` that are like it, and what each header says of them."""

    example: str
    others: int
    cells: tuple[str, ...]


def differences(columns: Mapping[str, Possible]) -> list[Difference]:
    """The lines about which the columns do not agree; ``cells`` are in the order of the columns."""
    tables = [_table(possible) for possible in columns.values()]
    keys = dict.fromkeys(key for table in tables for key in table)
    groups: dict[tuple[str, tuple[str, ...]], list[str]] = {}
    for name, text in keys:
        cells = tuple("; or ".join(table.get((name, text), [])) or _NOT for table in tables)
        if len(set(cells)) > 1:
            groups.setdefault((name, cells), []).append(text)
    return [Difference(texts[0], len(texts) - 1, cells) for (_, cells), texts in groups.items()]


def _table(possible: Possible) -> dict[tuple[str, str], list[str]]:
    """Name and operands of each line, and its possible values and times."""
    table: dict[tuple[str, str], set[str]] = {}
    for line in possible.lines:
        event = line.event
        cell = ", ".join(part for part in (answer(event), str(when(line, possible))) if part)
        table.setdefault((event["event"], _operands(event)), set()).add(cell)
    return {key: sorted(cells) for key, cells in table.items()}


def _operands(event: dict[str, Any]) -> str:
    return spelled({name: value for name, value in event.items() if name not in ("ret", "status")})
