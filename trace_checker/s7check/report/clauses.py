"""The requirements behind the IDs in a report.

In a checkout ``s7check requirements --write`` makes ``requirements.json`` beside this module from the entries of
docs/rules/requirements.md and docs/rules/readings.md, where each has an anchor with its ID.
"""

import re
from collections.abc import Iterable
from functools import cache
from importlib.resources import files

import msgspec

from s7check.log.errors import ranges

_FILE = "requirements.json"
_NAMED = re.compile(r"\b[A-Z]+-[0-9]{2,}\b")


class Clause(msgspec.Struct, frozen=True):
    """A requirement or, with an ID ``AMB-nn``, a question that the sources leave open, and its readings."""

    id: str
    text: str
    source: str = ""
    confidence: str = ""
    letters: dict[str, str] = {}

    @property
    def place(self) -> str:
        """Where the project's documents have it."""
        page = "readings" if self.id.startswith("AMB-") else "requirements"
        return f"docs/rules/{page}.md#{self.id}"


@cache
def _clauses() -> dict[str, Clause]:
    data = (files(__package__) / _FILE).read_bytes()
    return {clause.id: clause for clause in msgspec.json.decode(data, type=list[Clause])}


def all_clauses() -> list[Clause]:
    """Every requirement and every open question."""
    return list(_clauses().values())


def clause(name: str) -> Clause:
    """The clause with this ID; without a text if there is none."""
    return _clauses().get(name, Clause(name, ""))


def named(text: str) -> list[str]:
    """The IDs in a text that stand for a clause, each once."""
    return [name for name in dict.fromkeys(_NAMED.findall(text)) if name in _clauses()]


def requirements() -> list[str]:
    """The IDs of all requirements, in the order of the documents; questions that the sources leave open are none."""
    return [name for name in _clauses() if not name.startswith("AMB-")]


def by_area(names: Iterable[str]) -> str:
    """IDs in short, such as ``AIRT 3, 6-8; OBS 20``."""
    numbers: dict[str, list[int]] = {}
    for name in names:
        area, _, number = name.partition("-")
        numbers.setdefault(area, []).append(int(number))
    return "; ".join(f"{area} {ranges(found)}" for area, found in numbers.items())
