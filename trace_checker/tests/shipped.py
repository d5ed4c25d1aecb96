"""The logs that the project ships, from the index of each area."""

import json
from pathlib import Path
from typing import Any

TRACES = Path(__file__).parents[2] / "traces"

INDEX: list[dict[str, Any]] = [
    entry | {"file": f"{index.parent.name}/{entry['file']}"}
    for index in sorted(TRACES.glob("*/index.json"))
    for entry in json.loads(index.read_text(encoding="utf-8"))
]
"""All entries; `file` is counted from `TRACES`."""
