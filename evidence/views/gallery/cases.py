"""gallery/cases.json: the edge cases, each with what TLC looks for."""

from __future__ import annotations

from pathlib import Path

import msgspec

from evidence.common.checkout import ROOT

FOLDER = ROOT / "gallery"
CASES = FOLDER / "cases.json"


class Case(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """An edge case.

    `middle` and `goal` are TLA+ formulas over the state and the past events (models/MCGallery.tla); `kinds` are the
    steps of program and world that may be taken, `budget` how many; `world` has other values for the constants of the
    model, by the names of MCGallery.tla's definitions without "Gallery".
    """

    name: str
    title: str
    told: str
    requirements: list[str]
    goal: str
    kinds: list[str] = []
    budget: int = 2
    middle: str = "TRUE"
    world: dict[str, str] = {}

    @property
    def log(self) -> Path:
        """Where its log is."""
        return FOLDER / f"{self.name}.ndjson"


def cases(path: Path = CASES) -> list[Case]:
    """Read the cases. Raises `msgspec.ValidationError` with the field that does not fit."""
    return msgspec.json.decode(path.read_bytes(), type=list[Case])
