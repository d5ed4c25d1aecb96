"""The logs that the project ships, with the verdicts that they must get."""

from pathlib import Path
from typing import Any

import msgspec

from s7check.judging.verdict import Report
from s7check.log.objects import objects


class Shipped(msgspec.Struct, frozen=True):
    """An entry of ``traces/AREA/index.json``; ``line`` is absent where the log is accepted.

    ``file`` is counted from the area's folder in the index, and from ``traces`` in what `shipped_logs` returns.
    """

    file: str
    verdict: str
    requirements: list[str]
    reason: str
    line: int | None = None


def index_files(traces: Path) -> list[Path]:
    """The ``index.json`` of each area. Raises FileNotFoundError if there is none."""
    found = sorted(traces.glob("*/index.json"))
    if not found:
        raise FileNotFoundError(f"{traces}: no folder with an index.json")
    return found


def shipped_logs(traces: Path) -> list[Shipped]:
    """The entries of all areas below the folder ``traces``.

    Raises OSError or msgspec.MsgspecError, which name the index.
    """
    return [
        msgspec.structs.replace(log, file=f"{index.parent.name}/{log.file}")
        for index in index_files(traces)
        for log in _entries(index)
    ]


def _entries(index: Path) -> list[Shipped]:
    try:
        return msgspec.json.decode(index.read_bytes(), type=list[Shipped])
    except msgspec.MsgspecError as error:
        raise msgspec.DecodeError(f"{index}: {error}") from error


def difference(expected: Shipped, report: Report) -> str | None:
    """The difference between the verdict that a shipped log must get and its actual verdict."""
    line = report.line if report.verdict != "accepted" else None
    if (report.verdict, line) == (expected.verdict, expected.line):
        return None
    wanted = f"{expected.verdict}, line {expected.line}" if expected.line else expected.verdict
    got = f"{report.verdict}, line {line}" if line else report.verdict
    return f"{expected.file}: expected {wanted}; got {got}: {report.message}"


def header_of(log: Path) -> dict[str, Any]:
    """The header of a log as it stands there, packed or not. Raises UnusableLogError."""
    _, _, header = next(objects(str(log)))
    return header
