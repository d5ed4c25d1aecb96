"""The IDs of requirements and ambiguities, and how texts cite them."""

from __future__ import annotations

import re

PREFIXES = ("TINT", "DINT", "IRT", "AIRT", "OBS", "CLK", "T15")
AMBIGUITIES = ("AMB", "A15")

_ANY = rf"(?:{'|'.join((*PREFIXES, *AMBIGUITIES))})-\d+"
_MENTION = re.compile(rf"(?<![\w-]){_ANY}(?!\w)")
_TAG = re.compile(rf"\[({_ANY})\](?:\s*\.\.\s*\[({_ANY})\])?")


def mentioned(text: str) -> list[str]:
    """All IDs in a text, in their order, also IDs that do not exist."""
    return _MENTION.findall(text)


def tagged(text: str) -> list[str]:
    """The IDs that a comment claims for its definition: ``[TINT-14]``, and ranges, ``[TINT-72] .. [TINT-79]``.

    A range is counted through, so that IDs may come out which do not exist. Raises ValueError.
    """
    found: dict[str, None] = {}
    for first, last in _TAG.findall(text):
        found |= dict.fromkeys(_between(first, last) if last else [first])
    return list(found)


def _between(first: str, last: str) -> list[str]:
    prefix, low = first.split("-")
    other, high = last.split("-")
    if prefix != other or int(high) < int(low):
        raise ValueError(f"[{first}] .. [{last}] is no range")
    return [f"{prefix}-{number:02}" for number in range(int(low), int(high) + 1)]
