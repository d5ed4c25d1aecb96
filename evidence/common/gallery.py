"""gallery/cases.txt: the edge cases, each with what TLC looks for and the log that it found.

The notation is that of ``traces/``, with notes: ``title``, ``goal``, ``middle``, ``budget`` (how many steps, and
of which kinds), and the constants of the model, with a capital letter. The log stands last in each case.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from evidence.common import cases as notation
from evidence.common.checkout import ROOT

CASES = ROOT / "gallery" / "cases.txt"
LOGS = ROOT / "build" / "views" / "gallery"
"""Where `make setup` writes the logs and ``cases.json``, for the explorer; the wheel has them, too."""

_FIELDS = ("title", "goal", "middle", "budget")


@dataclass(frozen=True)
class Case:
    """An edge case.

    `middle` and `goal` are TLA+ formulas over the state and the past events (models/MCGallery.tla); `kinds` are the
    steps of program and world that may be taken, `budget` how many; `world` has other values for the constants of the
    model, by the names of MCGallery.tla's definitions without "Gallery". `log` has the bytes of the log.
    """

    name: str
    title: str
    told: str
    requirements: list[str]
    log: bytes
    goal: str
    kinds: tuple[str, ...]
    budget: int
    middle: str
    world: dict[str, str]

    @property
    def shown(self) -> dict[str, Any]:
        """What the explorer shows of it."""
        return {"name": self.name, "title": self.title, "told": self.told, "requirements": self.requirements}


def cases(path: Path = CASES) -> list[Case]:
    """Read the cases. Raises `evidence.common.cases.CasesError`, OSError."""
    return [_case(path, one) for one in notation.read_cases(path, notes=True)]


def _case(path: Path, one: notation.Case) -> Case:
    notes = one.notes
    unknown = [name for name in notes if name[0].islower() and name not in _FIELDS]
    missing = [name for name in ("title", "goal") if name not in notes]
    budget, *kinds = notes.get("budget", "2").split()
    wrong = [f"not {name}" for name in unknown] + [f"{name}: of {one.name} is missing" for name in missing]
    wrong += [] if budget.isdigit() else ["budget: a number"]
    if wrong:
        raise notation.CasesError(f"{path}:{one.place}: expected one of {', '.join(_FIELDS)}, {wrong[0]}")
    world = {name: text for name, text in notes.items() if name[0].isupper()}
    texts = notes["title"], one.reason, one.requirements, one.log, notes["goal"]
    return Case(one.name, *texts, tuple(kinds), int(budget), notes.get("middle", "TRUE"), world)


def write(folder: Path = LOGS) -> None:
    """Write the logs, and what the explorer shows of them. Raises `evidence.common.cases.CasesError`, OSError."""
    folder.mkdir(parents=True, exist_ok=True)
    found = cases()
    for case in found:
        (folder / f"{case.name}.ndjson").write_bytes(case.log)
    (folder / "cases.json").write_text(json.dumps([case.shown for case in found], indent=1), encoding="utf-8")


def replace_log(name: str, short: Sequence[str], path: Path = CASES) -> None:
    """Put a log in short into the place of that of a case. Raises OSError."""
    before, heading, rest = path.read_text(encoding="utf-8").partition(f"== {name} ")
    case, following, after = rest.partition("\n== ")
    said = case[: case.index("\ncpu=")]
    path.write_text(
        "".join([before, heading, said, "\n", "\n".join(short), following or "\n", after]), encoding="utf-8"
    )


if __name__ == "__main__":
    write()
