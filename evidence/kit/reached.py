"""The kit, run on the soft PLC in all its ways, and judged by all readings: which programs reach what."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import msgspec

from evidence.common import soft_plc
from evidence.common.cases import Case
from s7check.asking.variants import Variant
from s7check.coverage.measure import COMPLETE, Guard, judged
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.judging.decisions import Decisions, decisions_of
from s7check.kit.adapter import Ran
from s7check.kit.program import Program
from s7check.log.chosen import NOTHING, Chosen
from s7check.log.errors import UnusableLogError
from s7check.report.report import Report
from s7check.simulating.simulation import simulated


@dataclass
class Reached:
    """By requirement and by outcome of a guard the names of the programs that reach it, in their order.

    ``programs`` ran, ``logs`` were judged in all; ``alarms`` tell of logs of the soft PLC that were not accepted.
    """

    decisions: Decisions
    requirements: defaultdict[str, list[str]] = field(default_factory=lambda: defaultdict(list))
    guards: defaultdict[Guard, list[str]] = field(default_factory=lambda: defaultdict(list))
    programs: int = 0
    logs: int = 0
    alarms: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        """Name the outcomes once: there are a thousand, and as many in every log."""
        guards = self.decisions.guards.items()
        self._names = {2 * number + side: Guard.of(one, not side) for number, one in guards for side in (0, 1)}

    @property
    def outcomes(self) -> list[Guard]:
        """All outcomes of guards that there are."""
        return list(self._names.values())

    def add(self, program: str, report: Report) -> None:
        """Note what a log of the program shows."""
        shown: list[tuple[defaultdict[Any, list[str]], Any]] = [
            *((self.requirements, name) for name in self.decisions.requirements_of(report.outcomes)),
            *((self.guards, guard) for guard in self.shown(report)),
        ]
        for of, what in shown:
            if not of[what] or of[what][-1] != program:
                of[what].append(program)

    def shown(self, report: Report) -> list[Guard]:
        """The outcomes of guards that a log shows."""
        return [self._names[number] for number in report.outcomes if number in self._names]

    def by_program(self) -> Mapping[str, dict[str, list[str]]]:
        """What each program reaches: requirements, and the outcomes of guards of which few smaller programs do."""
        found: defaultdict[str, dict[str, set[str]]] = defaultdict(lambda: {"requirements": set(), "guards": set()})
        for requirement, programs in self.requirements.items():
            for program in programs:
                found[program]["requirements"].add(requirement)
        for guard, programs in self.guards.items():
            for program in programs[:_FEW]:
                found[program]["guards"].add(name_of(guard))
        return {program: {kind: sorted(names) for kind, names in of.items()} for program, of in found.items()}


def name_of(guard: Guard) -> str:
    """The id of an outcome, for people and for reasons; two conditions of the same text in a definition share it."""
    return f"{guard.module}/{guard.definition}/{str(guard.outcome).upper()}/{' '.join(guard.text.split())}"


_FEW = 2
"""Programs that a guard's outcome is named in, the smallest of those that reach it."""

_HOUR = 3_600_000

_OF_A_LOG = 100
"""Lines that cost the engine as much as the beginning and the end of a log."""

_UP = ("--up",)
"""The option of the soft PLC that changes its logs, and not what it does."""


def reach(programs: Sequence[Program], engine: Engine, tell: Callable[[str], None]) -> Reached:
    """Run the programs, the smallest first. Raises AdapterError, EngineError, OSError."""
    reached = Reached(decisions_of(engine))
    # Without what was measured before: a run would name other programs than the one before it.
    ordered = sorted(programs, key=lambda one: (len(one.plain_line()), one.name))
    usual = list(soft_plc.run(ordered))
    for program, ran in zip(ordered, usual, strict=True):
        reached.programs += not ran.skipped
        _judge(program, ran, engine, (), reached)
    tell(f"the soft PLC as it is: {_numbers(reached)}")
    few = _covering(reached, {program.name: len(ran.log) for program, ran in zip(ordered, usual, strict=True)})
    for options in [_UP, *(("--choose", choice) for choice in soft_plc.choices())]:
        for program, ran, same in zip(ordered, soft_plc.run(ordered, *options), usual, strict=True):
            if ran != same and (options != _UP or program.name in few):
                _judge(program, ran, engine, options, reached)
    tell(f"and with each of its options and choices: {_numbers(reached)}")
    for program, ran in zip(ordered, usual, strict=True):
        if program.name in few:
            for chosen in _readings(engine):
                report = judged(ran.log, engine, chosen)
                reached.logs += 1
                if report.verdict == "accepted":
                    reached.add(program.name, report)
    tell(f"and {len(few)} of them judged by each other reading: {_numbers(reached)}")
    for program in ordered:
        for variant in _variants(program, engine):
            if log := _simulated(program, variant, engine):
                reached.logs += 1
                reached.add(program.name, judged(log, engine))
    tell(f"and those about readings simulated by each of them: {_numbers(reached)}")
    return reached


def _judge(program: Program, ran: Ran, engine: Engine, options: Sequence[str], reached: Reached) -> None:
    """Note what the log of a run shows, or that it is a false alarm."""
    if ran.skipped:
        return
    # By the reading of its choice; a choice without one is open under every reading.
    name, _, letter = options[-1].partition("=") if options else ("", "", "")
    report = judged(ran.log, engine, Chosen(None, {name: letter}) if name.startswith("AMB-") else NOTHING)
    reached.logs += 1
    if ran.failed or report.verdict != "accepted":
        reached.alarms.append(f"{' '.join([program.name, *options])}: {ran.failed or report.verdict}")
    else:
        reached.add(program.name, report)


def _variants(program: Program, engine: Engine) -> Iterator[Variant]:
    """The program's CPU by each letter of the questions that the program is about.

    Not of those about an S7-1500, whose calls may answer any code, or longer than an hour, in which each point may
    count in several ways [AMB-56]: to simulate one takes minutes.
    """
    if program.duration > _HOUR or program.header["cpu"] not in engine.alternatives().classic:
        return
    for name, letters in engine.alternatives().letters:
        if name in program.requirements:
            yield from (Variant("", None, None, ((name, letter),)) for letter in letters)


def _simulated(program: Program, variant: Variant, engine: Engine) -> list[bytes]:
    """The log of a CPU that keeps the specification by these letters; none if the program cannot run on it."""
    try:
        lines = simulated(engine, program, variant)
    except (EngineError, UnusableLogError):
        return []
    return [msgspec.json.encode(line) for line in lines]


def _covering(reached: Reached, lines: Mapping[str, int]) -> set[str]:
    """Programs with few ``lines`` of log that together reach every outcome of a guard that any reaches; greedy."""
    left = dict(reached.guards)
    chosen: set[str] = set()
    while left:
        counts = Counter(name for names in left.values() for name in names)
        best = max(counts, key=lambda name: counts[name] / (_OF_A_LOG + lines[name]))
        chosen.add(best)
        left = {guard: names for guard, names in left.items() if best not in names}
    return chosen


def _readings(engine: Engine) -> list[Chosen]:
    """Each edition, and each letter that is not the default, one at a time."""
    others = engine.alternatives()
    defaults = dict(others.defaults)
    letters = [(name, letter) for name, known in others.letters for letter in known if letter != defaults.get(name)]
    editions = [Chosen(profile) for profile in others.profiles]
    return [*editions, *(Chosen(None, {name: letter}) for name, letter in letters)]


def _numbers(reached: Reached) -> str:
    return f"{reached.logs} logs, {len(reached.requirements)} requirements, {len(reached.guards)} guard outcomes"


def shown_by_logs(cases: Iterable[Case], engine: Engine, reached: Reached) -> Mapping[Guard, str]:
    """The outcomes of guards that a case shows which is accepted and records everything, each with such a case.

    Raises EngineError.
    """
    shown: dict[Guard, str] = {}
    with TemporaryDirectory(prefix="s7check-") as folder:
        for case in cases:
            if case.verdict == "accepted" and set(case.header.get("records", COMPLETE)) >= COMPLETE:
                for guard in reached.shown(judged(str(case.put(Path(folder))), engine)):
                    shown.setdefault(guard, case.id)
    return shown
