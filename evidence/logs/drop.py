"""Logs without the events of some kinds."""

from __future__ import annotations

from collections.abc import Iterator, Set
from itertools import combinations

from evidence.logs.damage import KINDS, Log

EVERY_KIND = ("call", "ob", "clock", "mode", "interrupt", "load")
"""The kinds that a header names by default."""

_KINDS = KINDS | {"state": "state"}
"""A `state` line says what somebody saw; it stays whatever is left out."""


def subsets() -> Iterator[frozenset[str]]:
    """Every choice of kinds, one kind at least."""
    for number in range(1, len(EVERY_KIND) + 1):
        yield from map(frozenset, combinations(EVERY_KIND, number))


def without(log: Log, kinds: Set[str]) -> Log:
    """The log without the events of these kinds, which its header no longer names."""
    header = log.header | {"records": [kind for kind in log.header.get("records", EVERY_KIND) if kind not in kinds]}
    if "ob" in kinds:
        header.pop("cycle", None)
    return Log(header, [event for event in log.events if _KINDS.get(event["event"], "call") not in kinds])
