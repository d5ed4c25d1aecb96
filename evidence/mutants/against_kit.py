"""Mutants before the logs of the kit: does a CPU that keeps the rules show that a rule was changed?

Its logs are accepted, so they cannot show that a mutant allows more. Counted are the mutants that some accepted log
shows: a log of the kit, or a shipped one that records everything and needs no reading other than the default.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import msgspec

from evidence.common import soft_plc
from evidence.common.cases import Case
from evidence.mutants.bench import Verdict
from evidence.mutants.checks import Check
from evidence.mutants.listing import Mutant
from s7check.coverage.measure import COMPLETE
from s7check.kit.collection import programs_of

KIT, SHIPPED, REST = "kit", "accepted logs", "rest of the kit"
"""The names of the checks, in their order."""

_LONGEST = 100
"""Lines of a log. A sixth of the programs has longer ones, nearly all of it cycles of OB 1, and 99 % of all lines.
Without them the kit shows no more than it does.
"""

LEAST = 0.95
"""Of the mutants that some accepted log shows."""


def kit_logs() -> tuple[list[Case], list[Case]]:
    """The logs of the soft PLC running the kit, but for long ones, in two parts.

    In the first are those of programs that were measured to reach guards: together they reach all that the kit
    reaches, so most mutants need no other logs. In the rest are also those that the choices of the soft PLC change,
    where every reading allows both, and the first ones as another implementation may write them. Raises AdapterError.
    """
    cases: tuple[list[Case], list[Case]] = [], []

    def keep(part: int, name: str, log: Sequence[bytes]) -> None:
        text = b"".join(line + b"\n" for line in log)
        cases[part].append(Case("KIT", name, "accepted", None, [], "", text))

    everything = programs_of()
    ran_all = zip(everything, soft_plc.run(everything), strict=True)
    short = [(program, ran) for program, ran in ran_all if 0 < len(ran.log) <= _LONGEST]
    for program, ran in short:
        if program.raw.get("reaches", {}).get("guards"):
            keep(0, program.name, ran.log)
            if (brief := without_startup_obs(ran.log)) != ran.log:
                keep(1, f"{program.name}-brief", brief)
        else:
            keep(1, program.name, ran.log)
    for choice in soft_plc.choices():
        if not choice.startswith("AMB-"):
            otherwise = soft_plc.run([program for program, _ in short], "--choose", choice)
            for (program, usual), ran in zip(short, otherwise, strict=True):
                if ran != usual:
                    keep(1, f"{program.name}-{choice}", ran.log)
    return _smallest_first(cases[0]), _smallest_first(cases[1])


def without_startup_obs(log: Sequence[bytes]) -> tuple[bytes, ...]:
    """The log without the lines of startup OBs, which may be left out; the soft PLC always writes them."""

    def may_be_left_out(line: bytes) -> bool:
        fields = msgspec.json.decode(line)
        return fields.get("event") in ("start", "end") and fields["ob"] in (100, 101, 102)

    return tuple(line for line in log if not may_be_left_out(line))


def accepted_logs(cases: Sequence[Case]) -> list[Case]:
    """The cases whose log a CPU as the kit's could have written."""
    return _smallest_first(case for case in cases if case.verdict == "accepted" and _plain(case.header))


def _plain(header: dict[str, Any]) -> bool:
    """Whether everything is recorded, but for what an implementation need not have, and no reading is named."""
    return set(header.get("records", COMPLETE)) >= COMPLETE and not {"readings", "profile"} & header.keys()


def _smallest_first(cases: Iterable[Case]) -> list[Case]:
    return sorted(cases, key=lambda case: len(case.log))


def before_the_kit(
    checks: Sequence[Check], chosen: list[Mutant], judge: Callable[[Check, list[Mutant]], list[Verdict]]
) -> dict[str, Any]:
    """The score of the kit by the three checks: the rest of the kit is tried where only a shipped log notices.

    ``judge`` tries one check, whatever another one said.
    """
    verdicts: dict[str, Verdict] = {}
    left = chosen
    for check in checks:
        if not left:
            break
        for verdict in judge(check, left):
            if verdict.how != "survived" or verdict.mutant.id not in verdicts:
                verdicts[verdict.mutant.id] = verdict
        noticed_by = SHIPPED if check.name == SHIPPED else ""
        left = [mutant for mutant in left if verdicts[mutant.id].by == noticed_by]
    return score([verdicts[mutant.id] for mutant in chosen])


def score(verdicts: Sequence[Verdict]) -> dict[str, Any]:
    """Of the mutants that an accepted log shows, how many a log of the kit shows."""
    shown = [verdict for verdict in verdicts if verdict.how not in ("survived", "invalid")]
    missed = [verdict.mutant.id for verdict in shown if verdict.by == SHIPPED]
    return {
        "mutants": len(verdicts),
        "invalid": sum(verdict.how == "invalid" for verdict in verdicts),
        "shown": len(shown),
        "by_kit": len(shown) - len(missed),
        "by_time": sum(verdict.how == "timeout" and verdict.by != SHIPPED for verdict in shown),
        "share": round(1 - len(missed) / len(shown), 4) if shown else None,
        "missed": missed,
        "shown_by_none": sum(verdict.how == "survived" for verdict in verdicts),
    }
