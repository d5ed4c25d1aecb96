"""The coverage of a log, and of several together."""

import os
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import dataclass, field
from functools import reduce
from typing import Any, Self

import msgspec

from s7check.engine import pool
from s7check.engine.answer import Decision
from s7check.engine.client import Engine
from s7check.judging.check import Judging
from s7check.judging.decisions import Decisions, decisions_of
from s7check.log.calls import OPERANDS
from s7check.log.chosen import NOTHING, Chosen
from s7check.log.errors import UnusableLogError
from s7check.log.objects import decoded
from s7check.log.profile_file import folder_of
from s7check.log.source import open_log
from s7check.report.report import Report, Verdict

COMPLETE = frozenset({"call", "ob", "clock", "mode", "interrupt", "load"})
"""The kinds of event that a log may leave out, and then is judged by less."""


@dataclass(frozen=True, order=True)
class Guard:
    """An outcome of a condition in an action: where the condition stands in ``spec/``, and whether it held."""

    module: str
    definition: str
    line: int
    column: int
    text: str
    outcome: bool

    @classmethod
    def of(cls, decision: Decision, outcome: bool) -> Self:
        """The outcome of a decision."""
        place = decision.module, decision.definition, decision.line, decision.column
        return cls(*place, decision.text, outcome)


@dataclass(frozen=True)
class Coverage:
    """The parts of the specification that logs exercise, as far as they are explained.

    ``requirements`` decided something in every explanation of a log, ``open`` ones in some explanations only.
    ``answers`` are calls with the RET_VALs that came, ``periods`` the PERIODs of successful SET_TINT, ``obs`` those
    that started, ``classes`` the priority classes in which they did. ``left_out`` are the kinds of event that a log
    does not record completely. ``a | b`` is the coverage of both.
    """

    requirements: frozenset[str] = frozenset()
    open: frozenset[str] = frozenset()
    guards: frozenset[Guard] = frozenset()
    answers: frozenset[tuple[str, int]] = frozenset()
    periods: frozenset[int] = frozenset()
    obs: frozenset[int] = frozenset()
    classes: frozenset[int] = frozenset()
    left_out: frozenset[str] = frozenset()
    verdicts: tuple[Verdict, ...] = field(default=())

    def __or__(self, other: "Coverage") -> "Coverage":
        requirements = self.requirements | other.requirements
        return Coverage(
            requirements,
            (self.open | other.open) - requirements,
            self.guards | other.guards,
            self.answers | other.answers,
            self.periods | other.periods,
            self.obs | other.obs,
            self.classes | other.classes,
            self.left_out | other.left_out,
            self.verdicts + other.verdicts,
        )


def measure(
    log: str | os.PathLike[str] | Iterable[bytes], engine: Engine | None = None, chosen: Chosen = NOTHING
) -> Coverage:
    """The coverage of a log, a file or its lines; of a log that is not accepted, that of the lines before the verdict.

    ``engine`` is one from the pool if none is given. Raises EngineError.
    """
    if engine is None:
        with pool.engine() as own:
            return measure(log, own, chosen)
    decisions = decisions_of(engine)
    taken = _Taken()
    report = judged(log, engine, chosen, taken.take)
    taken.take(b"\n")
    return coverage_of(report, decisions, taken.answers, taken.periods, taken.obs, taken.left_out)


def coverage_of(
    report: Report,
    decisions: Decisions,
    answers: Iterable[tuple[str, int]] = (),
    periods: Iterable[int] = (),
    obs: Iterable[int] = (),
    left_out: Iterable[str] = (),
) -> Coverage:
    """The coverage that a report shows, with what its log says itself."""
    sure = frozenset(decisions.requirements_of(report.outcomes))
    outcomes = frozenset(report.outcomes)
    return Coverage(
        sure,
        frozenset(decisions.requirements_of(report.open)) - sure,
        frozenset(
            Guard.of(one, outcome)
            for number, one in decisions.guards.items()
            for outcome in (True, False)
            if 2 * number + (not outcome) in outcomes
        ),
        frozenset(answers),
        frozenset(periods),
        frozenset(obs),
        frozenset(report.classes),
        frozenset(left_out),
        (report.verdict,),
    )


def together(coverages: Iterable[Coverage]) -> Coverage:
    """The coverage of all."""
    return reduce(Coverage.__or__, coverages, Coverage())


class _Said(msgspec.Struct):
    """The fields of a line that a coverage counts, as they are spelled."""

    event: Any = None
    ret: Any = None
    ob: Any = None
    period: Any = None


_said = msgspec.json.Decoder(_Said).decode


class _Taken:
    """The part of a coverage that the lines say themselves; what cannot be read is not counted."""

    def __init__(self) -> None:
        self.answers: set[tuple[str, int]] = set()
        self.periods: set[int] = set()
        self.obs: set[int] = set()
        self.left_out: frozenset[str] = frozenset()
        self._begun = False
        self._rest = b""

    def take(self, chunk: bytes) -> None:
        *lines, self._rest = (self._rest + chunk).split(b"\n")
        for text in lines:
            with suppress(UnusableLogError, msgspec.MsgspecError, TypeError):
                if self._begun:
                    self._line(_said(text))
                elif text.strip():
                    self._begun = True
                    self.left_out = COMPLETE - frozenset(decoded(text).get("records", COMPLETE))

    def _line(self, said: _Said) -> None:
        if said.event == "start":
            self.obs.add(said.ob)
        elif said.event in OPERANDS and said.ret is not None:
            self.answers.add((said.event, _word(said.ret)))
            if said.event == "SET_TINT" and _word(said.ret) == 0:
                self.periods.add(_word(said.period))


def _word(spelled: int | str) -> int:
    """The number of a word that the engine has read."""
    return int(spelled.rpartition("#")[2], 16) if isinstance(spelled, str) else spelled & 0xFFFF


def judged(
    log: str | os.PathLike[str] | Iterable[bytes],
    engine: Engine,
    chosen: Chosen = NOTHING,
    taken: Callable[[bytes], None] = lambda _: None,
) -> Report:
    """The verdict about a log, a file or its lines, with its outcomes; ``taken`` gets each part of it.

    Raises EngineError.
    """
    name = os.fspath(log) if isinstance(log, str | os.PathLike) else "-"
    judging = Judging("log", engine, chosen, folder_of(name), decided=True)
    try:
        if isinstance(log, str | os.PathLike):
            with open_log(name) as source:
                judging.take_all(source.chunks(engine.wait), taken)
        else:
            judging.take_all([b"".join(line.removesuffix(b"\n") + b"\n" for line in log)], taken)
    except UnusableLogError as error:
        judging.refuse(error)
    return judging.report()
