"""Why a requirement lacks a formula, a property, a model or a log: docs/rules/left_out.json.

The file is a list of ``{"ids": [...], "columns": [...], "kind": ..., "reason": ...}``.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated, Literal

import msgspec

Column = Literal["formula", "property", "model", "accepted", "rejected", "reading"]
Kind = Literal["text", "unseen", "outside", "follows", "table", "free", "not done"]

KINDS: dict[Kind, str] = {
    "text": "about the words of a source or of an edition, not about what a CPU does",
    "unseen": "neither a log nor a state of the specification can show it",
    "outside": "belongs to a function, a mode or a CPU that is not specified",
    "follows": "nothing of its own: it follows from what the reason names",
    "table": "a list of numbers or codes: a property could only repeat the formula",
    "free": "allows something and demands nothing, so nothing can violate it",
    "not done": "could be there and is not: work that is still to be done",
}


class Reason(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One entry of the file."""

    ids: Annotated[tuple[str, ...], msgspec.Meta(min_length=1)]
    columns: Annotated[tuple[Column, ...], msgspec.Meta(min_length=1)]
    kind: Kind
    reason: Annotated[str, msgspec.Meta(min_length=20)]


_NAME = re.compile(r"\bneg-[\w-]+|\b[A-Z]+/[\w-]+|\b[A-Z]\w*(?:Prop|Inv)\b")


def named(reason: str) -> list[str]:
    """The negative controls, logs and properties that a reason points to."""
    return _NAME.findall(reason)


Reasons = dict[tuple[str, Column], Reason]


def read_reasons(path: Path) -> Reasons:
    """The reason of each requirement and column. Raises ValueError, also where a reason is given twice."""
    try:
        entries = msgspec.json.decode(path.read_bytes(), type=list[Reason])
    except (OSError, msgspec.MsgspecError) as error:
        raise ValueError(f"{path}: {error}") from error
    found: Reasons = {}
    for entry in entries:
        for name in entry.ids:
            for column in entry.columns:
                if (name, column) in found:
                    raise ValueError(f"{path}: {name}, {column}: two reasons")
                found[name, column] = entry
    return found
