"""The result of a run of the kit: of each program, and of each requirement."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Literal

import msgspec

from s7check.kit.identity import Run
from s7check.report.clauses import requirements as all_requirements
from s7check.report.report import Report, Verdict

Status = Literal["passed", "failed", "skipped", "no verdict"]
State = Literal["passed", "failed", "not reached", "skipped"]

STATES: tuple[State, ...] = ("failed", "passed", "skipped", "not reached")


class Result(msgspec.Struct, frozen=True):
    """The outcome of a program: ``reason`` of a failure or a skip, ``deciding`` the requirements for which its log was
    rejected, ``report`` the text of the verdict, ``seconds`` that the run took, ``events`` of its log.

    ``about`` are the requirements of the program, ``decided`` the requirements that decided something in its accepted
    log; ``digest`` says which program it was. ``reduced`` is the smallest log that is rejected alike; empty if there
    are others for its requirement. ``cause`` is what failures have in common: the rejected line, what was expected and
    the rule; ``passes_under`` are the readings and editions under which the log would pass, where they were tried.
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
    """The state of a requirement: names of the programs about it by their status, and why it was skipped."""

    requirement: str
    state: State
    passed: tuple[str, ...] = ()
    failed: tuple[str, ...] = ()
    skipped: tuple[str, ...] = ()
    reasons: tuple[str, ...] = ()


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
    program whose log was rejected for another requirement says nothing about it.
    """
    passed: dict[str, list[str]] = {}
    failed: dict[str, list[str]] = {}
    skipped: dict[str, list[str]] = {}
    reasons: dict[str, Counter[str]] = {}
    for result in results:
        if result.status == "passed":
            for name in result.decided:
                passed.setdefault(name, []).append(result.name)
        elif result.status == "failed":
            for name in result.deciding or result.about:
                failed.setdefault(name, []).append(result.name)
        else:
            for name in result.about:
                skipped.setdefault(name, []).append(result.name)
                reasons.setdefault(name, Counter())[result.reason] += 1
    names = [*all_requirements(), *sorted(set(failed) - set(all_requirements()))]
    return [
        Outcome(
            name,
            "failed"
            if name in failed
            else "passed"
            if name in passed
            else "skipped"
            if name in skipped
            else "not reached",
            tuple(passed.get(name, ())),
            tuple(failed.get(name, ())),
            tuple(skipped.get(name, ())),
            tuple(reason for reason, _ in reasons.get(name, Counter()).most_common()),
        )
        for name in names
    ]


_STATUSES: dict[Verdict, Status] = {
    "accepted": "passed",
    "rejected": "failed",
    "unusable": "failed",
    "no verdict": "no verdict",
}


def result_of(report: Report, name: str, digest: str, about: Sequence[str], seconds: float) -> Result:
    """The result for a verdict about the log of a program."""
    status: Status = {"accepted": "passed", "rejected": "failed", "unusable": "failed"}.get(
        report.verdict, "no verdict"
    )  # type: ignore[assignment]
    reason = "" if status == "passed" else f"{report.verdict}: {report.message}"
    return Result(
        name,
        digest,
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
