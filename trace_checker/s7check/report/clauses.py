"""The requirements: what the IDs in a report stand for.

``requirements.json`` beside this module is made from the tables of docs/rules/requirements.md and
docs/rules/readings.md, where each row has an anchor with its ID: ``python -m s7check.report.clauses``.
"""

import re
from functools import cache
from importlib.resources import files
from pathlib import Path

import msgspec

_FILE = "requirements.json"
_ROW = re.compile(r'^\| <a id="([A-Z]+-[0-9]+)"></a>\1 \| (.*) \|$', re.MULTILINE)
_NAMED = re.compile(r"\b[A-Z]+-[0-9]{2,}\b")
_LETTER = re.compile(r"\(([a-d])\) (.*?)(?=;? \([a-d]\) |$)")
_CELL = re.compile(r"(?<!\\)\|")


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


def clause(name: str) -> Clause:
    """The clause with this ID; without a text if there is none."""
    return _clauses().get(name, Clause(name, ""))


def named(text: str) -> list[str]:
    """The IDs in a text that stand for a clause, each once."""
    return [name for name in dict.fromkeys(_NAMED.findall(text)) if name in _clauses()]


def read_documents(requirements: str, readings: str) -> list[Clause]:
    """The clauses of the two documents."""
    found: list[Clause] = []
    for name, row in _ROW.findall(requirements):
        text, source, confidence = (cell.strip() for cell in _CELL.split(row)[:3])
        found.append(Clause(name, text, source, confidence))
    for name, row in _ROW.findall(readings):
        question, letters = (cell.strip() for cell in _CELL.split(row)[:2])
        found.append(Clause(name, question, letters=dict(_LETTER.findall(letters))))
    return found


def _encoded(clauses: list[Clause]) -> bytes:
    return msgspec.json.format(msgspec.json.encode(clauses), indent=1) + b"\n"


def main() -> None:
    """Writes the file from the documents of the checkout."""
    docs = Path(__file__).resolve().parents[3] / "docs" / "rules"
    texts = [(docs / name).read_text(encoding="utf-8") for name in ("requirements.md", "readings.md")]
    Path(str(files(__package__) / _FILE)).write_bytes(_encoded(read_documents(*texts)))


if __name__ == "__main__":
    main()
