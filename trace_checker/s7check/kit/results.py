"""The result of a run of the kit: of each program, and of each requirement."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Literal

import msgspec

from s7check.kit.identity import Run
from s7check.report.clauses import requirements as all_requirements
from s7check.report.report import Report

Status = Literal["passed", "failed", "passed under another reading", "skipped", "no verdict"]
State = Literal["passed", "failed", "passed under another reading", "not reached", "skipped"]

UNDER_ANOTHER: Literal["passed under another reading"] = "passed under another reading"
"""Rejected, but accepted under another reading of an open question, or another edition of the manual."""

FAILED: frozenset[Status] = frozenset({"failed", UNDER_ANOTHER})
"""Statuses with which a run fails."""

STATES: tuple[State, ...] = ("failed", UNDER_ANOTHER, "passed", "skipped", "not reached")


class Result(msgspec.Struct, frozen=True):
    """The outcome of a program: ``reason`` of a failure or a skip, ``deciding`` the requirements for which its log was
    rejected, ``report`` the text of the verdict, ``seconds`` that the run took, ``events`` of its log.

    ``about`` are the requirements of the program, ``decided`` the requirements that decided something in its accepted
    log; ``digest`` says which program it was. ``reduced`` is the smallest log that is rejected alike; empty if there
    are others for its requirement. ``cause`` is what failures have in common: the rejected line, what was expected and
    the rule; ``passes_under`` are the readings and editions under which a rejected log passes.
    """

    name: str
    digest: str
    status: Status
    about: tuple[str, ...]
    reason: str = ""
    deciding: tuple[str, ...] = ()
    decided: tuple[str, ...] = ()
    report: str = ""
    seconds: float = 0.0
    events: int = 0
    reduced: str = ""
    cause: str = ""
    passes_under: tuple[str, ...] = ()


class Outcome(msgspec.Struct, frozen=True):
    """The state of a requirement: names of the programs about it by their status, and why it was skipped.

    ``under`` are those that pass under another reading.
    """

    requirement: str
    state: State
    passed: tuple[str, ...] = ()
    failed: tuple[str, ...] = ()
    skipped: tuple[str, ...] = ()
    reasons: tuple[str, ...] = ()
    under: tuple[str, ...] = ()


class Kept(msgspec.Struct, frozen=True):
    """The content of a result as JSON."""

    programs: list[Result]
    requirements: list[Outcome]
    run: Run = Run()


def outcomes(results: Iterable[Result]) -> list[Outcome]:
    """Every requirement with its state, in the order of the documents.

    A requirement is passed if it decided something in an accepted log, as `s7check coverage` measures it, whatever the
    program says it is about.

    A requirement is failed if the specification rejected a log for it, or if a program about it crashed or hung; a
    program whose log was rejected for another requirement says nothing about it. If all these logs pass under another
    reading, so does the requirement.
    """
    found: dict[str, dict[str, list[str]]] = {}
    reasons: dict[str, Counter[str]] = {}
    for result in results:
        for name in _concerned(result):
            found.setdefault(name, {}).setdefault(result.status, []).append(result.name)
            if result.status in ("skipped", "no verdict"):
                reasons.setdefault(name, Counter())[result.reason] += 1
    # Questions that decided about a failure come behind the requirements.
    rejected = {name for name, statuses in found.items() if FAILED & statuses.keys()}
    names = [*all_requirements(), *sorted(rejected - {*all_requirements()})]
    return [_outcome(name, found.get(name, {}), reasons.get(name, Counter())) for name in names]


def _concerned(result: Result) -> tuple[str, ...]:
    """The requirements for which a result says something."""
    if result.status == "passed":
        return result.decided
    return result.deciding or result.about if result.status in FAILED else result.about


def _outcome(name: str, by_status: dict[str, list[str]], reasons: Counter[str]) -> Outcome:
    skipped = (*by_status.get("skipped", ()), *by_status.get("no verdict", ()))
    parts: dict[State, tuple[str, ...]] = {
        "failed": tuple(by_status.get("failed", ())),
        UNDER_ANOTHER: tuple(by_status.get(UNDER_ANOTHER, ())),
        "passed": tuple(by_status.get("passed", ())),
        "skipped": skipped,
    }
    return Outcome(
        name,
        next((state for state, programs in parts.items() if programs), "not reached"),
        parts["passed"],
        parts["failed"],
        skipped,
        tuple(reason for reason, _ in reasons.most_common()),
        parts[UNDER_ANOTHER],
    )


def result_of(report: Report, name: str, about: Sequence[str], seconds: float) -> Result:
    """The result for a verdict about the log of a program, without its ``digest``."""
    status: Status = {"accepted": "passed", "rejected": "failed", "unusable": "failed"}.get(
        report.verdict, "no verdict"
    )  # type: ignore[assignment]
    reason = "" if status == "passed" else f"{report.verdict}: {report.message}"
    return Result(
        name,
        "",
        status,
        tuple(about),
        reason,
        tuple(report.requirements),
        tuple(report.decided) if status == "passed" else (),
        "" if status == "passed" else str(report),
        seconds,
        report.events,
        cause="" if status == "passed" else _cause(report),
    )


def _cause(report: Report) -> str:
    if report.verdict != "rejected" or report.event is None:
        return ""
    event = msgspec.json.decode(report.event).get("event")
    ob = msgspec.json.decode(report.event).get("ob")
    expected = ", ".join(sorted(report.expected)[:3])
    line = f"{event}" + (f" of OB {ob}" if ob is not None else "")
    place = "before" if report.late else "in place of"
    return f"{report.requirements[0] if report.requirements else ''}: {expected} expected {place} {line}"
