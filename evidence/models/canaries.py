"""Which known defects the TLC at hand has.

Three tiny specifications in ``models/canaries/`` show a defect each. What they tell is shown at the start of every
run, so that nobody takes a verdict for more than it is worth; it never fails a run. A jar is asked once: the answer is
kept under ``build/`` by the jar's hash.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from evidence.common.checkout import ROOT
from evidence.common.processes import Processes
from evidence.tla import tlc
from evidence.tla.messages import Outcome

State = Literal["present", "absent", "unknown"]

DIRECTORY = ROOT / "models" / "canaries"
TIMEOUT = 60.0
HEAP_MB = 256
FORMAT = 1
"""Version of the kept answers; another one is asked for anew."""


@dataclass(frozen=True)
class Canary:
    """A specification with a known defect of TLC, and the verdict of a TLC without the defect.

    `defect` is the text for the user, `issue` the number of upstream's issue, `attempts` how often to try: a race does
    not show every time.
    """

    module: str
    issue: int
    defect: str
    workers: int
    attempts: int
    sound: Callable[[Outcome], bool]


def _refused(outcome: Outcome) -> bool:
    return outcome.kind == "broken"


CANARIES = (
    Canary(
        "CanaryLazyExcept",
        1302,
        "misses a violation after EXCEPT on a lazily evaluated function",
        workers=1,
        attempts=1,
        sound=lambda outcome: outcome.kind == "invariant",
    ),
    Canary(
        "CanaryTwoWorkers",
        971,
        "loses liveness violations with several workers (the harness uses 1 for liveness)",
        workers=2,
        attempts=4,
        sound=lambda outcome: outcome.kind == "temporal",
    ),
    Canary(
        "CanaryFormula",
        525,
        "accepts a specification formula that it does not handle",
        workers=1,
        attempts=1,
        sound=_refused,
    ),
)


@dataclass(frozen=True)
class Answer:
    """The answer of a canary. ``unknown``: it could not be asked."""

    module: str
    issue: int
    defect: str
    state: State


@dataclass(frozen=True)
class Answers:
    """The version that a TLC reports, and the answer of each canary."""

    version: str
    answers: tuple[Answer, ...]


def run_canaries(tools: tlc.Toolchain, build: Path, processes: Processes, directory: Path = DIRECTORY) -> Answers:
    """Return the answers for this TLC, from `build` if they are there. Raises only `InterruptedRunError`."""
    kept = build / f"tlc-canaries-{tools.sha256[:16]}.json"
    known = _read(kept)
    if known is not None:
        return known
    version = ""
    answers = []
    for canary in CANARIES:
        state, said = _ask(canary, tools, processes, directory)
        version = version or said
        answers.append(Answer(canary.module, canary.issue, canary.defect, state))
    result = Answers(version, tuple(answers))
    if version and all(a.state != "unknown" for a in answers):
        _write(kept, result)
    return result


def _ask(canary: Canary, tools: tlc.Toolchain, processes: Processes, directory: Path) -> tuple[State, str]:
    options = tlc.Options(workers=canary.workers, deadlock=False, heap=HEAP_MB, timeout=TIMEOUT)
    version = ""
    for _ in range(canary.attempts):
        try:
            text, config = ((directory / f"{canary.module}.{kind}").read_text() for kind in ("tla", "cfg"))
            with tlc.workspace([directory], canary.module, text, config) as space:
                run = tlc.run(tools, space, options, processes)
        except OSError:
            return "unknown", version
        version = version or run.outcome.version
        if not version or run.outcome.kind == "timeout":
            return "unknown", version
        if not canary.sound(run.outcome):
            return "present", version
    return "absent", version


def _read(kept: Path) -> Answers | None:
    try:
        raw = json.loads(kept.read_text(encoding="utf-8"))
        states = raw["answers"]
        if raw["format"] != FORMAT:
            return None
        answers = [Answer(c.module, c.issue, c.defect, states[c.module]) for c in CANARIES]
        return Answers(raw["version"], tuple(answers))
    except (OSError, ValueError, KeyError, TypeError):
        return None


def _write(kept: Path, result: Answers) -> None:
    text = json.dumps(
        {"format": FORMAT, "version": result.version, "answers": {a.module: a.state for a in result.answers}}, indent=1
    )
    try:
        kept.parent.mkdir(parents=True, exist_ok=True)
        kept.write_text(text + "\n", encoding="utf-8")
    except OSError:
        return  # asked again next time
