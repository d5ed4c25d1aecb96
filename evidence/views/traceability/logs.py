"""The logs of each requirement, from the cases of traces/."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from evidence.common.cases import Case, all_cases
from evidence.views.traceability.entries import Entries, entries
from evidence.views.traceability.ids import AMBIGUITIES


@dataclass(frozen=True)
class Logs:
    """The accepted and the rejected logs of each requirement; direct are the logs that it decides."""

    accepted: dict[str, Entries]
    rejected: dict[str, Entries]
    places: dict[str, str]
    """File and line of each case, by its id."""


def read_logs(traces: Path) -> Logs:
    """Read all cases. Raises OSError; ValueError, also where there are no accepted or no rejected logs."""
    cases = all_cases(traces)
    found = {v: _by_requirement([case for case in cases if case.verdict == v]) for v in ("accepted", "rejected")}
    for verdict, by_requirement in found.items():
        if not by_requirement:
            raise ValueError(f"{traces}: no {verdict} log names a requirement")
    places = {case.id: f"{traces.name}/{case.area}.txt:{case.place}: {case.name}" for case in cases}
    return Logs(found["accepted"], found["rejected"], places)


def _by_requirement(cases: list[Case]) -> dict[str, Entries]:
    """A log is decided by the first of its requirements; where that is an ambiguity, by the next one as well."""
    found = {}
    for name in {name: None for case in cases for name in case.requirements}:
        ids = sorted((case.id for case in cases if name in case.requirements), key=lambda each: _rank(each, name))
        decided = {case.id for case in cases if name in _deciding(case)}
        found[name] = entries([each for each in ids if each in decided], ids)
    return found


def _deciding(case: Case) -> list[str]:
    first, *others = case.requirements or [""]
    return [first, *others[:1]] if first.startswith(AMBIGUITIES) else [first]


def _rank(case: str, name: str) -> tuple[bool, str]:
    """Logs that are named after the requirement come before the others that it decides."""
    return f"/{name}-" not in case, case
