"""The logs of each requirement, from traces/index.json."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import msgspec

from evidence.common.shipped import Shipped, shipped_logs
from evidence.traceability.entries import Entries, entries
from evidence.traceability.errors import UnreadableError


@dataclass(frozen=True)
class Logs:
    """The accepted and the rejected logs of each requirement; direct are those that it decides."""

    accepted: dict[str, Entries]
    rejected: dict[str, Entries]
    files: frozenset[str]
    """All logs, without what follows the first dot of the name."""


def read_logs(traces: Path) -> Logs:
    """Read the index. Raises `UnreadableError`, also where it has no accepted or no rejected logs."""
    try:
        logs = shipped_logs(traces)
    except (OSError, msgspec.MsgspecError) as error:
        raise UnreadableError(f"{traces / 'index.json'}: {error}") from error
    found = {v: _by_requirement([log for log in logs if log.verdict == v]) for v in ("accepted", "rejected")}
    for verdict, by_requirement in found.items():
        if not by_requirement:
            raise UnreadableError(f"{traces / 'index.json'}: no {verdict} log names a requirement")
    return Logs(found["accepted"], found["rejected"], frozenset(log.file.partition(".")[0] for log in logs))


def _by_requirement(logs: list[Shipped]) -> dict[str, Entries]:
    """Logs that are named after the requirement come before the others that it decides."""
    found = {}
    for name in {name: None for log in logs for name in log.requirements}:
        files = sorted((log.file for log in logs if name in log.requirements), key=lambda file: _rank(file, name))
        decided = {log.file for log in logs if log.requirements[:1] == [name]}
        found[name] = entries([file for file in files if file in decided], files)
    return found


def _rank(file: str, name: str) -> tuple[bool, str]:
    return not file.partition("/")[2].startswith(f"{name}-"), file
