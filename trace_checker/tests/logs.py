"""Small logs for the tests."""

import json
from typing import Any

HEADER: dict[str, Any] = {
    "format": "s7-interrupt-log/1",
    "cpu": "S7-400",
    "obs": [1, 10, 80, 85, 100],
    "clock": "2026-11-21T05:59:30.000",
}
RUN = HEADER | {"mode": "RUN"}
BEGIN = 19_401_479
"""The minute of the header's clock, counted from 1990."""


def at(second: float) -> str:
    """A time of the minute in which the logs begin."""
    return f"2026-11-21T05:59:{second:06.3f}"


def event(name: str, second: float = 31, **fields: object) -> dict[str, Any]:
    """An event of a log."""
    return {"event": name, "at": at(second), **fields}


def log_text(*entries: dict[str, Any] | str, header: dict[str, Any] = HEADER) -> bytes:
    """A log as bytes; strings become lines as they are."""
    lines = [entry if isinstance(entry, str) else json.dumps(entry) for entry in (header, *entries)]
    return "".join(line + "\n" for line in lines).encode()
