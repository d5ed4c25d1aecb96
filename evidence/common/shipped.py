"""The logs that the project ships, and what they must be judged as."""

from pathlib import Path

import msgspec

from s7check.verdict import Report


class Shipped(msgspec.Struct, frozen=True):
    """An entry of ``traces/index.json``; ``line`` is absent where the log is accepted."""

    file: str
    verdict: str
    requirements: list[str]
    reason: str
    line: int | None = None


def shipped_logs(traces: Path) -> list[Shipped]:
    """The entries of ``index.json`` in the folder ``traces``.

    Raises OSError or msgspec.MsgspecError if there is no such index.
    """
    return msgspec.json.decode((traces / "index.json").read_bytes(), type=list[Shipped])


def difference(expected: Shipped, report: Report) -> str | None:
    """What differs between the verdict that a shipped log must have and the one it got."""
    line = report.line if report.verdict != "accepted" else None
    if (report.verdict, line) == (expected.verdict, expected.line):
        return None
    wanted = f"{expected.verdict}, line {expected.line}" if expected.line else expected.verdict
    got = f"{report.verdict}, line {line}" if line else report.verdict
    return f"{expected.file}: expected {wanted}; got {got}: {report.message}"
