"""Rewriting the pinned counts of the manifest (``--update``): counts and depth, never an exit code or a property."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from evidence.models.judge import COUNTS, Result
from evidence.models.manifest import parse_json

WIDTH = 118


def update(path: Path, results: list[Result]) -> list[str]:
    """Set the counts of the results that differ in nothing else; return a line for each change, none: file untouched.

    A violation's counts are set only where some are pinned already.
    """
    document = parse_json(path, path.read_text(encoding="utf-8"))
    changes = []
    entries = {entry["name"]: entry for entry in document["models"]}
    for result in results:
        if result.problems or not result.count_problems:
            continue
        expect = entries[result.model.name]["expect"]
        for name in COUNTS:
            came = getattr(result.outcome.counts, name)
            several = name == "depth" and result.model.workers > 1
            wanted = name in expect or (result.outcome.kind == "passed" and not several)
            if wanted and came is not None and expect.get(name) != came:
                changes.append(f"{result.model.name}: {name} {expect.get(name, 'not pinned')} -> {came}")
                expect[name] = came
    if changes:
        path.write_text(render(document) + "\n", encoding="utf-8")
    return changes


def render(value: Any, indent: int = 0) -> str:
    """Return JSON with every value that fits on one line, so that a manifest stays readable and diffs small."""
    flat = json.dumps(value, ensure_ascii=False)
    if len(flat) + indent <= WIDTH and indent > 0:
        return flat
    inner = " " * (indent + 2)
    if isinstance(value, dict) and value:
        parts = [f"{inner}{json.dumps(k, ensure_ascii=False)}: {render(v, indent + 2)}" for k, v in value.items()]
        return "{\n" + ",\n".join(parts) + f"\n{' ' * indent}}}"
    if isinstance(value, list) and value:
        return "[\n" + ",\n".join(inner + render(v, indent + 2) for v in value) + f"\n{' ' * indent}]"
    return flat
