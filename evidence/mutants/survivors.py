"""Why mutants survive: ``models/survivors.json``.

An entry names a mutant, or several by a glob, and says why nothing notices them: because they are `equivalent`, that
is because no behaviour differs, or for a reason that leaves something to be done.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from evidence.common.reasons import Excuse, assign
from evidence.mutants.bench import Verdict


class Reason(Excuse, frozen=True, forbid_unknown_fields=True):
    """One entry of the file."""

    equivalent: bool = False


@dataclass(frozen=True)
class Explained:
    """Verdicts and reasons side by side; `stale` are the reasons that fit nothing any more, and why.

    `stated`: only properties killed, so that a survivor may be noticed otherwise, and needs no reason.
    """

    verdicts: list[Verdict]
    reasons: dict[str, Reason]
    stale: list[str]
    stated: bool = False

    @property
    def unexplained(self) -> list[Verdict]:
        """The survivors without a reason."""
        return [v for v in self.verdicts if v.how == "survived" and v.mutant.id not in self.reasons]

    @property
    def ok(self) -> bool:
        """Whether every survivor that needs a reason has one, and every reason a survivor."""
        return self.stated or not (self.unexplained or self.stale)

    def unevaluated(self, verdict: Verdict) -> bool:
        """Whether a mutant does not count, since no property can notice it: no model evaluates its change."""
        return self.stated and verdict.how == "survived" and not verdict.evaluating

    def equivalent(self, verdict: Verdict) -> bool:
        """Whether a mutant survived because it changes nothing."""
        reason = self.reasons.get(verdict.mutant.id)
        return verdict.how == "survived" and reason is not None and reason.equivalent


def explain(
    verdicts: list[Verdict], reasons: Iterable[Reason], existing: Iterable[str], *, stated: bool = False
) -> Explained:
    """Find the reason of each survivor. `existing` are the ids of all mutants, judged or not.

    A count makes no reason stale why a mutant is equivalent: TLC also counts a step that two formulas allow.
    """
    entries = list(reasons)
    same = [reason for reason in entries if reason.equivalent]
    lacking = [
        v.mutant.id
        for v in verdicts
        if v.how == "survived" or (v.how == "count" and any(reason.fits(v.mutant.id) for reason in same))
    ]
    found, gone, needless = assign(entries, existing, lacking, [v.mutant.id for v in verdicts])
    stale = [f"{reason.id}: there is no such mutant" for reason in gone]
    stale += [f"{reason.id}: does not survive" for reason in needless]
    return Explained(verdicts, found, [] if stated else stale, stated)
