"""The requirements behind the IDs in a report: the entries of requirements.md, requirements-s7-1500.md and readings.md
in docs/rules.

A requirement is ``- **ID** text *(sources; confidence)*``, a question ``**ID** text`` and a list of its letters, each
behind an anchor with its ID.
"""

import re
from collections.abc import Iterable
from functools import cache
from typing import Any

import msgspec

from s7check.log.errors import ranges
from s7check.resources import RULES

_NAMED = r"\b[A-Z]+[0-9]*-[0-9]{2,}\b"
_ANCHOR = r'<a id="([A-Z]+\d*-\d+)">'
_REQUIREMENT = r'^- <a id="([A-Z]+\d*-\d+)"></a>\*\*\1\*\* (.*) \*\((.*); (.*)\)\*$'
_QUESTION = r'^<a id="([A-Z]+\d*-\d+)"></a>\*\*\1\*\* (.*)\n\n((?:- \(.\) .*\n)+)'
_LETTER = r"^- \(([a-f])\) (.*)$"
_EVENT_IDS = r"^### [\d.]+ Event IDs$(.*?)^### "
_EVENT = r"^\| ([0-9A-F]{4}) \| ([^|]+?) +\|"
_BREAK = r"(?<=.)\n *(?=[^\n -])"
"""Where a sentence goes on in the next line."""


class Clause(msgspec.Struct, frozen=True):
    """A requirement or, with an ID ``AMB-nn`` or ``A15-nn``, an open question and its readings."""

    id: str
    text: str
    source: str = ""
    confidence: str = ""
    letters: dict[str, str] = {}

    @property
    def place(self) -> str:
        """Where the project's documents have it."""
        return f"docs/rules/{page_of(self.id)}#{self.id}"


def is_question(name: str) -> bool:
    """Whether an ID is that of a question that the sources leave open."""
    return name.startswith(("AMB-", "A15-"))


def page_of(name: str) -> str:
    """The page of docs/rules that has the clause with an ID."""
    if is_question(name):
        return "readings.md"
    return "requirements-s7-1500.md" if name.startswith("T15-") else "requirements.md"


def requirements_of(page: str) -> list[Clause]:
    """The entries of the text of requirements.md. Raises ValueError for an anchor without one."""
    text = re.sub(_BREAK, " ", page)
    return _entries(text, [Clause(*found) for found in re.findall(_REQUIREMENT, text, re.MULTILINE)])


def questions_of(page: str) -> list[Clause]:
    """The entries of the text of readings.md. Raises ValueError for an anchor without one."""
    text = re.sub(_BREAK, " ", page)
    found = re.findall(_QUESTION, text, re.MULTILINE)
    letters = [dict(re.findall(_LETTER, said, re.MULTILINE)) for _, _, said in found]
    return _entries(
        text, [Clause(name, asked, letters=its) for (name, asked, _), its in zip(found, letters, strict=True)]
    )


def _entries(text: str, clauses: list[Clause]) -> list[Clause]:
    """The clauses, if there is one for each anchor of the page."""
    ids = [clause.id for clause in clauses]
    for name in re.findall(_ANCHOR, text):
        if name not in ids:
            raise ValueError(f"{name}: expected an entry like the others behind the anchor")
        if ids.count(name) > 1:
            raise ValueError(f"{name} has more than one entry")
    if not ids:
        raise ValueError("no entries")
    return clauses


@cache
def _clauses() -> dict[str, Clause]:
    pages = [
        (requirements_of, "requirements.md"),
        (requirements_of, "requirements-s7-1500.md"),
        (questions_of, "readings.md"),
    ]
    found = [clause for read, page in pages for clause in read((RULES / page).read_text(encoding="utf-8"))]
    return {clause.id: clause for clause in found}


def all_clauses() -> list[Clause]:
    """Every requirement and every open question."""
    return list(_clauses().values())


def clause(name: str) -> Clause:
    """The clause with this ID; without a text if there is none."""
    return _clauses().get(name, Clause(name, ""))


@cache
def event_texts() -> dict[str, str]:
    """What the event IDs mean, by their four digits."""
    page = (RULES / "requirements.md").read_text(encoding="utf-8")
    found = re.search(_EVENT_IDS, page, re.MULTILINE | re.DOTALL)
    return {} if found is None else dict(re.findall(_EVENT, found[1], re.MULTILINE))


def event_text(number: int) -> str:
    """What an event ID of the diagnostic buffer means, such as ``STOP: OB 80 missing``; empty if no source tells."""
    return event_texts().get(f"{number & 0xFFFF:04X}", "")


def texts() -> dict[str, Any]:
    """The words of the rules and of event IDs, as the engine's message ``texts`` has them."""
    clauses = [msgspec.structs.asdict(one) | {"place": one.place} for one in all_clauses()]
    return {"clauses": clauses, "events": event_texts()}


def named(text: str) -> list[str]:
    """The IDs in a text that stand for a clause, each once."""
    return [name for name in dict.fromkeys(re.findall(_NAMED, text)) if name in _clauses()]


def requirements() -> list[str]:
    """The IDs of all requirements, in the order of the documents; questions that the sources leave open are none."""
    return [name for name in _clauses() if not is_question(name)]


def by_area(names: Iterable[str]) -> str:
    """IDs in short, such as ``AIRT 3, 6-8; OBS 20``."""
    numbers: dict[str, list[int]] = {}
    for name in names:
        area, _, number = name.partition("-")
        numbers.setdefault(area, []).append(int(number))
    return "; ".join(f"{area} {ranges(found)}" for area, found in numbers.items())
