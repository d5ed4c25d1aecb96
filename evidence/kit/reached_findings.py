"""What of the specification the kit was to reach, and what it did."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from evidence.common.reasons import Excuse, assign
from evidence.kit.reached import Reached, name_of
from s7check.coverage.measure import Guard

LEAST = 0.95
"""Of the outcomes of guards that can be observed."""

_TWO = 2
"""Programs for a requirement."""


@dataclass(frozen=True)
class Findings:
    """The outcomes of guards: ``met`` by the kit, ``shown`` only by a shipped log (with its name), ``excused`` with the
    reason why no log shows them, ``missed``, which something may show. ``stale`` are reasons without a use.

    ``few`` are the requirements that fewer than two programs reach. ``programs`` ran, with ``logs``; ``alarms`` are
    logs of the soft PLC that were not accepted.
    """

    met: Sequence[Guard]
    shown: Mapping[Guard, str]
    excused: Mapping[Guard, str]
    missed: Sequence[Guard]
    stale: Sequence[str]
    requirements: Sequence[str]
    few: Sequence[str]
    programs: int
    logs: int
    alarms: Sequence[str]

    @property
    def observable(self) -> int:
        """The number of outcomes that can be observed, as far as is known."""
        return len(self.met) + len(self.shown) + len(self.missed)

    @property
    def share(self) -> float:
        """The share of them that the kit reaches."""
        return len(self.met) / self.observable

    @property
    def ok(self) -> bool:
        """Whether the kit reaches as much as it is to reach, and every reason has a use."""
        return self.share >= LEAST and not (self.few or self.stale)


def findings(
    reached: Reached,
    shown: Mapping[Guard, str],
    reasons: Iterable[Excuse],
) -> Findings:
    """Put together what was measured. ``shown`` are outcomes that shipped logs show, which no reason excuses."""
    guards, requirements = reached.outcomes, reached.decisions.requirements
    met = [guard for guard in guards if guard in reached.guards]
    left = [guard for guard in guards if guard not in reached.guards]
    dark = [guard for guard in left if guard not in shown]
    known = {name_of(guard) for guard in guards}
    found, gone, needless = assign(reasons, known, {name_of(guard) for guard in dark}, known)
    return Findings(
        met,
        {guard: shown[guard] for guard in left if guard in shown},
        {guard: found[name_of(guard)].reason for guard in dark if name_of(guard) in found},
        [guard for guard in dark if name_of(guard) not in found],
        [f"{one.id}: there is no such condition" for one in gone] + [f"{one.id}: is reached" for one in needless],
        requirements,
        [name for name in requirements if len(reached.requirements.get(name, ())) < _TWO],
        reached.programs,
        reached.logs,
        reached.alarms,
    )


def as_text(found: Findings) -> Iterable[str]:
    """The numbers, and behind them what is missing."""
    for guard, log in found.shown.items():
        yield f"not reached, but {log} shows it: {name_of(guard)}"
    for guard in found.missed:
        yield f"not reached, and no reason says that nothing shows it: {name_of(guard)}"
    yield from (f"not accepted: {alarm}" for alarm in found.alarms)
    yield from (f"reached by fewer than two programs: {name}" for name in found.few)
    yield from (f"a reason without a use: {one}" for one in found.stale)
    yield (
        f"{found.programs} programs, {found.logs} logs: {len(found.met)} of {found.observable} guard outcomes that can "
        f"be observed ({found.share:.1%}; {len(found.excused)} others cannot), "
        f"{len(found.requirements) - len(found.few)} of {len(found.requirements)} requirements by two programs"
    )


def as_json(found: Findings) -> dict[str, Any]:
    """Return everything as a JSON document."""
    return {
        "kit": "reached",
        "ok": found.ok,
        "programs": found.programs,
        "logs": found.logs,
        "met": len(found.met),
        "observable": found.observable,
        "share": round(found.share, 4),
        "shown_by_logs": {name_of(guard): log for guard, log in found.shown.items()},
        "missed": [name_of(guard) for guard in found.missed],
        "excused": {name_of(guard): reason for guard, reason in found.excused.items()},
        "stale": list(found.stale),
        "requirements": len(found.requirements),
        "few": list(found.few),
        "not_accepted": list(found.alarms),
    }
