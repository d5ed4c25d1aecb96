"""Which known defects the TLC at hand has.

Three tiny specifications in ``models/canaries/`` show a defect each. What they tell is shown at the start of every
run, so that nobody takes a verdict for more than it is worth; it never fails a run. A jar is asked once: the answer is
kept under ``build/`` by the jar's hash.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import msgspec

from evidence.common.checkout import ROOT
from evidence.common.processes import Processes
from evidence.tla import tlc
from evidence.tla.messages import Outcome

State = Literal["present", "absent", "unknown"]

DIRECTORY = ROOT / "models" / "canaries"
TIMEOUT = 60.0
HEAP_MB = 256


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
        sound=lambda outcome: outcome.kind == "broken",
    ),
)


class Answers(msgspec.Struct, frozen=True):
    """The version that a TLC reports, and the answer of each canary by its module. ``unknown``: it was not asked."""

    version: str
    answers: dict[str, State]


def run_canaries(tools: tlc.Toolchain, build: Path, processes: Processes, directory: Path = DIRECTORY) -> Answers:
    """Return the answers for this TLC, from `build` if they are there. Raises only `InterruptedRunError`."""
    kept = build / f"tlc-canaries-{tools.sha256[:16]}.json"
    with suppress(OSError, msgspec.MsgspecError):
        known = msgspec.json.decode(kept.read_bytes(), type=Answers)
        if list(known.answers) == [canary.module for canary in CANARIES]:
            return known
    version = ""
    answers: dict[str, State] = {}
    for canary in CANARIES:
        answers[canary.module], said = _ask(canary, tools, processes, directory)
        version = version or said
    result = Answers(version, answers)
    if version and "unknown" not in answers.values():
        with suppress(OSError):  # asked again next time
            kept.parent.mkdir(parents=True, exist_ok=True)
            kept.write_bytes(msgspec.json.encode(result))
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
