"""The logs of each requirement, from the index of each area of traces/."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path, PurePosixPath

import msgspec

from evidence.common.shipped import Shipped, shipped_logs
from evidence.views.traceability.entries import Entries, entries
from evidence.views.traceability.errors import UnreadableError
from evidence.views.traceability.ids import AMBIGUITY


@dataclass(frozen=True)
class Logs:
    """The accepted and the rejected logs of each requirement; direct are the logs that it decides."""

    accepted: dict[str, Entries]
    rejected: dict[str, Entries]
    files: frozenset[str]
    """All logs, by name up to the first dot."""


def read_logs(traces: Path) -> Logs:
    """Read each index. Raises `UnreadableError`, also where there are no accepted or no rejected logs."""
    try:
        logs = shipped_logs(traces)
    except (OSError, msgspec.MsgspecError) as error:
        raise UnreadableError(str(error)) from error
    found = {v: _by_requirement([log for log in logs if log.verdict == v]) for v in ("accepted", "rejected")}
    for verdict, by_requirement in found.items():
        if not by_requirement:
            raise UnreadableError(f"{traces}: no {verdict} log names a requirement")
    return Logs(found["accepted"], found["rejected"], frozenset(log.file.partition(".")[0] for log in logs))


def _by_requirement(logs: list[Shipped]) -> dict[str, Entries]:
    """A log is decided by the first of its requirements; where that is an ambiguity, by the next one as well."""
    found = {}
    for name in {name: None for log in logs for name in log.requirements}:
        files = sorted((log.file for log in logs if name in log.requirements), key=lambda file: _rank(file, name))
        decided = {log.file for log in logs if name in _deciding(log)}
        found[name] = entries([file for file in files if file in decided], files)
    return found


def _deciding(log: Shipped) -> list[str]:
    first, *others = log.requirements or [""]
    return [first, *others[:1]] if first.startswith(AMBIGUITY) else [first]


def _rank(file: str, name: str) -> tuple[bool, str]:
    """Logs that are named after the requirement come before the others that it decides."""
    return not PurePosixPath(file).name.startswith(f"{name}-"), file
