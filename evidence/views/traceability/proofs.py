"""Of how many actions a property has been proved: the kept summary of the last run of ``s7spec prove``."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import msgspec

from evidence.views.results.records import Table


@dataclass(frozen=True)
class Proof:
    """A property is proved of `proved` actions of `actions`."""

    proved: int
    actions: int


class _Record(msgspec.Struct):
    tables: list[Table]


def read_proofs(path: Path) -> dict[str, Proof]:
    """The proofs by the name of the property; none before the first run. Raises ValueError."""
    if not path.exists():
        return {}
    try:
        record = msgspec.json.decode(path.read_bytes(), type=_Record)
    except (OSError, msgspec.MsgspecError) as error:
        raise ValueError(f"{path}: {error}") from error
    found: dict[str, Proof] = {}
    for table in record.tables:
        if table.title == "Each property":
            proved, actions = table.columns.index("proved of actions"), table.columns.index("actions")
            found |= {str(row[0]): Proof(int(row[proved] or 0), int(row[actions] or 0)) for row in table.rows}
    return found
