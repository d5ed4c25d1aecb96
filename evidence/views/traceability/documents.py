"""The requirements and ambiguities: the entries of docs/rules/requirements.md and docs/rules/readings.md."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import msgspec

from evidence.views.traceability.errors import UnreadableError
from s7check.report.clauses import Clause

_ANCHOR = re.compile(r'<a id="([A-Z]+-\d+)">')
_REQUIREMENT = re.compile(r'^- <a id="([A-Z]+-\d+)"></a>\*\*\1\*\* (.*) \*\((.*); (.*)\)\*$', re.MULTILINE)
_QUESTION = re.compile(r'^<a id="([A-Z]+-\d+)"></a>\*\*\1\*\* (.*)\n\n((?:- \(.\) .*\n)+)', re.MULTILINE)
_LETTER = re.compile(r"^- \(([a-d])\) (.*)$", re.MULTILINE)
_BREAK = re.compile(r"(?<=.)\n *(?=[^\n -])")
"""Where a sentence goes on in the next line."""


def read(path: Path) -> str:
    """The text of a document. Raises `UnreadableError`."""
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise UnreadableError(f"{path}: {error}") from error


def requirements(path: Path) -> tuple[Clause, ...]:
    """The requirements in their order, each ``- **ID** text *(sources; confidence)*``. Raises `UnreadableError`."""
    text = _joined(path)
    return _entries(path, text, [Clause(*found) for found in _REQUIREMENT.findall(text)])


def ambiguities(path: Path) -> tuple[Clause, ...]:
    """The ambiguities, each ``**ID** question`` and a list of its letters. Raises `UnreadableError`."""
    text = _joined(path)
    found = [Clause(name, asked, letters=dict(_LETTER.findall(said))) for name, asked, said in _QUESTION.findall(text)]
    return _entries(path, text, found)


def encoded(clauses: Sequence[Clause]) -> str:
    """The clauses as JSON, for the reports of ``s7check trace``."""
    return msgspec.json.format(msgspec.json.encode(clauses), indent=1).decode() + "\n"


def _joined(path: Path) -> str:
    """The text with each paragraph and each item of a list in one line."""
    return _BREAK.sub(" ", read(path))


def _entries(path: Path, text: str, clauses: list[Clause]) -> tuple[Clause, ...]:
    """The clauses, if there is one for each anchor of the page."""
    ids = [clause.id for clause in clauses]
    for name in _ANCHOR.findall(text):
        if name not in ids:
            raise UnreadableError(f"{path}: {name}: expected an entry like the others behind the anchor")
        if ids.count(name) > 1:
            raise UnreadableError(f"{path}: {name} has more than one entry")
    if not ids:
        raise UnreadableError(f"{path}: no entries")
    return tuple(clauses)
