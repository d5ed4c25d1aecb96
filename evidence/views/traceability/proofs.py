"""Of how many actions a property has been proved: the kept summary of the last run of ``s7spec prove``."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import msgspec

from evidence.views.traceability.errors import UnreadableError

TITLE = "Each property"
PROVED = "proved of actions"
ACTIONS = "actions"


@dataclass(frozen=True)
class Proof:
    """A property is proved of `proved` actions of `actions`."""

    proved: int
    actions: int


class _Table(msgspec.Struct):
    columns: list[str]
    rows: list[list[str | int | float | None]]
    title: str = ""


class _Record(msgspec.Struct):
    tables: list[_Table]


def read_proofs(path: Path) -> dict[str, Proof]:
    """The proofs by the name of the property; none before the first run. Raises `UnreadableError`."""
    if not path.exists():
        return {}
    try:
        record = msgspec.json.decode(path.read_bytes(), type=_Record)
    except (OSError, msgspec.MsgspecError) as error:
        raise UnreadableError(f"{path}: {error}") from error
    found: dict[str, Proof] = {}
    for table in record.tables:
        if table.title == TITLE:
            proved, actions = table.columns.index(PROVED), table.columns.index(ACTIONS)
            found |= {str(row[0]): Proof(int(row[proved] or 0), int(row[actions] or 0)) for row in table.rows}
    return found
