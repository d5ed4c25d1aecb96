"""The checks that can kill a mutant: a model of the manifest, or the shipped logs."""

from __future__ import annotations

import hashlib
import sys
import time
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Protocol

import msgspec

from evidence.common.processes import Processes
from evidence.models.manifest import Model
from evidence.models.runner import Harness
from evidence.models.runner import check as check_model
from evidence.mutants.findings import Finding, How
from evidence.tla.cfg import replacements
from evidence.tla.marks import evaluated
from evidence.tla.modules import JUDGING, closure
from evidence.tla.syntax import Module

PARSE_ERROR = 150
"""TLC's exit code for a specification that does not parse or has no meaning."""

LEAST_TLC_ERROR = 10
"""TLC's own exit codes begin here; a lower one is Java's or the system's."""

LONGEST = 3600.0
"""Seconds that a check has on the unchanged specification."""

VIOLATIONS: Mapping[str, How] = {
    "invariant": "property",
    "action": "property",
    "temporal": "property",
    "initial": "property",
    "deadlock": "deadlock",
    "assumption": "assumption",
    "timeout": "timeout",
    "broken": "error",
}
"""The name here for each kind of outcome of TLC."""


class CheckFailedError(RuntimeError):
    """A check came to nothing, for a reason outside of the specification."""


class Check(Protocol):
    """Something that the unchanged specification passes."""

    @property
    def name(self) -> str:
        """The name for the user."""

    @property
    def modules(self) -> frozenset[str]:
        """The modules of the specification that it is built on."""

    @property
    def parameters(self) -> frozenset[str]:
        """The definitions that it puts others in the place of."""

    def key(self, changed: Module | None) -> str:
        """A hash of all that decides its result, with one module changed."""

    def marks(self, spec: Path) -> frozenset[int] | None:
        """Return the marks that it evaluates in a marked specification; None if it cannot tell."""

    def run(self, spec: Path, timeout: float) -> Finding:
        """Try the specification in this directory. Raises `CheckFailedError`, `InterruptedRunError`."""


@dataclass(frozen=True)
class ModelCheck:
    """A model, pinned in the manifest as passing."""

    harness: Harness
    model: Model
    spec: Mapping[str, Module]
    models: Mapping[str, Module]

    @property
    def name(self) -> str:
        """The model's name."""
        return self.model.name

    @cached_property
    def _all(self) -> list[Module]:
        known = {**self.spec, **self.models}
        return [known[name] for name in sorted(closure(self.model.module.stem, known))]

    @cached_property
    def modules(self) -> frozenset[str]:
        """The modules of the specification that the model's module extends."""
        return frozenset(module.name for module in self._all) & self.spec.keys()

    @cached_property
    def parameters(self) -> frozenset[str]:
        """The definitions that the configuration replaces."""
        return frozenset(replacements(self.model.config))

    def key(self, changed: Module | None) -> str:
        """A hash of TLC, the model and the modules."""
        model = self.model
        fixed = (self.harness.tools.sha256, model.module, model.config, model.deadlock, (), model.expect)
        return fingerprint(fixed, self._all, changed)

    def marks(self, spec: Path) -> frozenset[int] | None:
        """Return the marks that TLC told; None if it stumbled over them."""
        result = check_model(self._harness(spec), replace(self.model, seconds=(0.0, LONGEST)))
        return evaluated(result.output) if result.ok else None

    def run(self, spec: Path, timeout: float) -> Finding:
        """Run TLC and compare the result with the pins."""
        began = time.monotonic()
        result = check_model(self._harness(spec), replace(self.model, seconds=(0.0, timeout)))
        outcome, code = result.outcome, result.exit
        if result.ok:
            return Finding("survived", "", _since(began))
        if outcome.kind == "passed":
            return Finding("count", "; ".join(result.problems + result.count_problems), _since(began))
        if outcome.kind == "broken" and (code is None or code < LEAST_TLC_ERROR):
            raise CheckFailedError(f"model {self.name}: {outcome.detail}")
        how = "invalid" if code == PARSE_ERROR else VIOLATIONS[outcome.kind]
        return Finding(how, ", ".join(outcome.names) or outcome.detail, _since(began))

    def _harness(self, spec: Path) -> Harness:
        return replace(self.harness, manifest=replace(self.harness.manifest, spec=spec))


@dataclass(frozen=True)
class LogsCheck:
    """Logs of cases, judged by the trace checker's engine. `engine` is a hash of the engine and the cases."""

    cases: Path
    engine: str
    spec: Mapping[str, Module]
    processes: Processes
    name: str = "logs"

    parameters = frozenset[str]()
    root = JUDGING

    @cached_property
    def modules(self) -> frozenset[str]:
        """The modules that the engine reads."""
        return closure(self.root, self.spec)

    def key(self, changed: Module | None) -> str:
        """A hash of the engine, the logs and the modules."""
        return fingerprint((self.engine,), (self.spec[name] for name in sorted(self.modules)), changed)

    def marks(self, spec: Path) -> frozenset[int] | None:
        """The engine is no model checker: TLC's registers, which hold the marks, are not there."""
        return None

    def run(self, spec: Path, timeout: float) -> Finding:
        """Judge logs until one is judged otherwise than its case says."""
        began = time.monotonic()
        command = [sys.executable, "-m", "evidence.mutants.against_logs", str(spec), str(self.cases)]
        process = self.processes.start(command, Path.cwd())
        with self.processes.limited(process, timeout) as expired:
            said, _ = process.communicate()
        if expired.is_set():
            return Finding("timeout", f"killed after {timeout:.0f} s", _since(began))
        try:
            found = msgspec.json.decode(said, type=Finding)
        except msgspec.MsgspecError as error:
            raise CheckFailedError(f"the logs could not be judged: {said.strip()[-1000:]}") from error
        return msgspec.structs.replace(found, seconds=_since(began))


def fingerprint(fixed: Iterable[object], modules: Iterable[Module], changed: Module | None) -> str:
    """A hash of `fixed` and of the code of the modules, one of them changed."""
    codes = [changed.code if changed and changed.name == m.name else m.code for m in modules]
    return hashlib.sha256(repr((*map(repr, fixed), *codes)).encode()).hexdigest()[:32]


def _since(began: float) -> float:
    return round(time.monotonic() - began, 2)
