"""The files of the kit: a program a line, and in each what was measured of it."""

from __future__ import annotations

import json
from typing import Any

from evidence.common.checkout import ROOT

PROGRAMS = ROOT / "kit" / "programs"
MEASURED = "reaches"
"""The field that a run writes, and no generator."""


def as_line(program: dict[str, Any]) -> str:
    """A program as a line of its file, without the end of the line."""
    return json.dumps(program, ensure_ascii=False, separators=(",", ":"))


def unmeasured(program: dict[str, Any]) -> dict[str, Any]:
    """The program without what was measured of it."""
    return {name: value for name, value in program.items() if name != MEASURED}


def kept() -> dict[str, dict[str, dict[str, Any]]]:
    """The programs of each file by their names. Raises OSError, ValueError."""
    return {
        file.name: {one["name"]: one for one in map(json.loads, file.read_text(encoding="utf-8").splitlines())}
        for file in sorted(PROGRAMS.glob("*.ndjson"))
    }
