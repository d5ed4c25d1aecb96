"""A mutant before its checks."""

from __future__ import annotations

import contextlib
import hashlib
import shutil
import tempfile
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_EXCEPTION, ThreadPoolExecutor, wait
from dataclasses import dataclass, field
from pathlib import Path

from evidence.mutants.checks import LONGEST, Check
from evidence.mutants.findings import STATED, WEAK, Finding, Findings, How
from evidence.mutants.listing import Mutant
from evidence.mutants.order import Experience
from evidence.tla.marks import marked, when_evaluated
from evidence.tla.syntax import Module

PATIENCE = 6
"""A check that takes so many times longer than on the unchanged specification has another result."""

LEAST_TIMEOUT = 30.0
"""Seconds that a check has in any case; the machine may be busy with other things."""

OF_TEMPORAL_FORMULAS = frozenset({"Liveness", "Calendar"})
"""Modules of temporal formulas and of the constants that they range over: TLC refuses some formulas with marks."""

UNCHANGED = "unchanged"
MARKED = "marked"
"""In place of a mutant's id: a finding about the specification itself, or about its marked copy."""


class UnsoundBaselineError(RuntimeError):
    """The unchanged specification does not pass a check; the text says which and how."""


@dataclass(frozen=True)
class Verdict:
    """The verdict about a mutant: `by` names the check that killed it, `evaluating` the checks that it got past.

    A check that does not evaluate the changed expression is not among them. The `detail` of a survivor names the checks
    that noticed it otherwise, where only properties kill. `seconds` is the time of the checks, now or when they were
    run.
    """

    mutant: Mutant
    how: How
    by: str
    detail: str
    seconds: float
    evaluating: tuple[str, ...]


@dataclass
class Bench:
    """The unchanged specification, the calibrated checks, and the experience with them.

    `thorough`: after a kill that says only that something changed, the other checks are tried too. `stated`: only what
    a model states kills a mutant; past other kills the next check is tried.
    """

    spec: Path
    modules: Mapping[str, Module]
    findings: Findings
    thorough: bool = False
    stated: bool = False
    _checks: list[Check] = field(default_factory=list)
    _experience: Experience = field(default_factory=Experience)
    _seconds: dict[str, float] = field(default_factory=dict)
    _evaluated: dict[str, set[str]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Learn from the findings of earlier runs."""
        for kept in self.findings.all():
            self._learn(kept.check, kept.mutant, kept.finding)

    def calibrate(self, checks: Sequence[Check], mutants: Sequence[Mutant], tell: Callable[[str], None]) -> None:
        """Run each check on the unchanged specification, and find out which of `mutants` it evaluates.

        Raises `UnsoundBaselineError`, `CheckFailedError`, `InterruptedRunError`.
        """
        for check in checks:
            finding = self._find(check, UNCHANGED, None)
            if finding.how != "survived":
                raise UnsoundBaselineError(
                    f"the unchanged specification does not pass {check.name}: {finding.how}: {finding.detail}"
                )
            self._seconds[check.name] = finding.seconds
            concerned = [m for m in mutants if m.module in check.modules]
            evaluated = self._evaluated_by(check, concerned)
            self._evaluated[check.name] = evaluated
            self._checks.append(check)
            reach = f"evaluates what {len(evaluated)} of {len(mutants)} mutants change"
            tell(f"{check.name}: {finding.seconds:.1f} s, {reach}")

    def judge_all(self, mutants: Sequence[Mutant], jobs: int, tell: Callable[[Verdict], None]) -> list[Verdict]:
        """Judge mutants, `jobs` at a time, and return the verdicts in their order. `tell` is called from threads.

        Those of one definition are judged one after the other: each tells which check is best for the next. Raises
        `CheckFailedError`, `InterruptedRunError`.
        """
        groups: defaultdict[tuple[str, str], list[Mutant]] = defaultdict(list)
        for mutant in mutants:
            groups[mutant.module, mutant.definition].append(mutant)
        verdicts: dict[str, Verdict] = {}

        def judge(group: list[Mutant]) -> None:
            for mutant in group:
                verdicts[mutant.id] = self.judge(mutant)
                tell(verdicts[mutant.id])

        pool = ThreadPoolExecutor(jobs)
        try:
            tasks = [pool.submit(judge, group) for group in sorted(groups.values(), key=len, reverse=True)]
            for task in wait(tasks, return_when=FIRST_EXCEPTION).done:
                task.result()
        finally:
            pool.shutdown(wait=False, cancel_futures=True)
        return [verdicts[mutant.id] for mutant in mutants]

    def decided(self, verdict: Verdict) -> bool:
        """Whether further checks would make no difference to a verdict."""
        return verdict.how != "survived" and not (self.thorough and verdict.how in WEAK)

    def judge(self, mutant: Mutant) -> Verdict:
        """Try the checks, the most promising first, until one kills the mutant."""
        changed = Module(mutant.module, mutant.text)
        seconds = 0.0
        weak: Verdict | None = None
        past: list[str] = []
        otherwise: list[str] = []
        for check in self._promising(mutant):
            finding = self._find(check, mutant.id, changed)
            seconds += finding.seconds
            if finding.how == "survived" or (self.stated and finding.how not in STATED | {"invalid"}):
                past.append(check.name)
                otherwise += [] if finding.how == "survived" else [f"{finding.how} {check.name}"]
                continue
            verdict = Verdict(mutant, finding.how, check.name, finding.detail, seconds, tuple(past))
            if self.decided(verdict):
                return verdict
            weak = weak or verdict
        return weak or Verdict(mutant, "survived", "", ", ".join(otherwise), seconds, tuple(past))

    def _promising(self, mutant: Mutant) -> list[Check]:
        def value(check: Check) -> float:
            return self._experience.likelihood(check.name, mutant.id) / max(self._seconds[check.name], 1.0)

        return sorted((c for c in self._checks if mutant.id in self._evaluated[c.name]), key=value, reverse=True)

    def _evaluated_by(self, check: Check, mutants: Sequence[Mutant]) -> set[str]:
        """The ids of the mutants whose expressions a check evaluates, or may evaluate.

        A mutant of any other expression changes nothing for the check, which then need not be run.
        """
        for unmarked in (frozenset[str](), OF_TEMPORAL_FORMULAS):
            marking = [m for m in mutants if m.module not in unmarked]
            spans = sorted({(m.module, m.span) for m in marking})
            number = {place: index for index, place in enumerate(spans, 1)}
            around = {place: when_evaluated(index) for place, index in number.items()}
            told = self._told(check, marked(self.modules, around, len(spans)))
            if told is not None:
                silent = {m.id for m in marking if number[m.module, m.span] not in told}
                return {m.id for m in mutants} - silent
        return {m.id for m in mutants}

    def _told(self, check: Check, texts: Mapping[str, bytes]) -> frozenset[int] | None:
        """The marks in these texts that a check evaluates, kept as a finding; None if that cannot be found out."""
        key = hashlib.sha256(repr((check.key(None), sorted(texts.items()))).encode()).hexdigest()[:32]
        known = self.findings.known(key)
        if known is None:
            with self._copy(texts) as spec:
                told = check.marks(spec)
            detail = "?" if told is None else " ".join(map(str, sorted(told)))
            known = Finding("survived", detail, 0.0)
            self.findings.keep(key, check.name, MARKED, known)
        return None if known.detail == "?" else frozenset(map(int, known.detail.split()))

    def _find(self, check: Check, name: str, changed: Module | None) -> Finding:
        key = check.key(changed)
        if (known := self.findings.known(key)) is not None:
            return known
        with self._copy({changed.name: changed.text} if changed else {}) as spec:
            finding = self._run(check, spec) if changed else check.run(spec, LONGEST)
        if changed is None and finding.how != "survived":
            return finding  # the next run asks again: the reason may be outside of the specification
        self.findings.keep(key, check.name, name, finding)
        self._learn(check.name, name, finding)
        return finding

    def _run(self, check: Check, spec: Path) -> Finding:
        """Run a check; a timeout counts only if the unchanged specification, run after it, is not slower too."""
        while True:
            limit = max(LEAST_TIMEOUT, PATIENCE * self._seconds[check.name])
            finding = check.run(spec, limit)
            if finding.how != "timeout":
                return finding
            now = check.run(self.spec, LONGEST).seconds
            if PATIENCE * now <= limit:
                return finding
            self._seconds[check.name] = now

    @contextlib.contextmanager
    def _copy(self, texts: Mapping[str, bytes]) -> Iterator[Path]:
        """A copy of the specification with other modules in the place of these, or beside them."""
        with tempfile.TemporaryDirectory(prefix="s7check-", ignore_cleanup_errors=True) as temporary:
            copy = Path(temporary).resolve() / "spec"
            shutil.copytree(self.spec, copy)
            for name, text in texts.items():
                place = next(copy.rglob(f"{name}.tla"), copy / f"{name}.tla")
                place.write_bytes(text)
            yield copy

    def _learn(self, check: str, name: str, finding: Finding) -> None:
        if name not in (UNCHANGED, MARKED) and finding.how != "invalid":
            killed = finding.how in STATED if self.stated else finding.killed
            self._experience.learn(check, name, killed=killed)
