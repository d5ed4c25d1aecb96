"""The result of a run against its pins, and new pins by results (``--update``)."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from evidence.models.entries import COUNTS, read, rewrite
from evidence.models.manifest import Model, load
from evidence.tla.messages import Counts, Kind, Outcome


@dataclass(frozen=True)
class Result:
    """A judged model.

    `problems` say each drift in one line, count drifts apart in `count_problems` since ``--update`` may settle those;
    `workers` is the number that TLC had; `exit` is None where TLC was not started.
    """

    model: Model
    outcome: Outcome
    exit: int | None
    seconds: float
    workers: int
    problems: tuple[str, ...]
    count_problems: tuple[str, ...] = ()
    output: str = ""

    @property
    def ok(self) -> bool:
        """Whether all is as pinned."""
        return not self.problems and not self.count_problems


def judge(model: Model, outcome: Outcome, exit_code: int, seconds: float, workers: int, output: str) -> Result:
    """Compare a run with its pins. `outcome` names the violated property where that could be found out."""
    problems = _verdict(model, outcome, exit_code)
    counts = []
    if not problems:  # time and counts of a run that came to something else tell nothing
        problems = _time(model, seconds) + _liveness(model, outcome, workers)
        counts = _counts(model, outcome.counts, outcome.kind, workers)
    return Result(model, outcome, exit_code, seconds, workers, tuple(problems), tuple(counts), output)


def expectation(model: Model) -> str:
    """Return all pins in one line."""
    expect = model.expect
    said = [f"exit {exit_codes(model)} ({' or '.join(sorted(model.kinds))})"]
    if expect.property:
        said.append(expect.property)
    said += [f"{getattr(expect, name)} {name}" for name in COUNTS if getattr(expect, name) is not None]
    return ", ".join(said) + f", {model.seconds[0]:g}..{model.seconds[1]:g} s"


def exit_codes(model: Model) -> str:
    """Say which exit code is pinned."""
    return " or ".join(map(str, model.exits))


def _verdict(model: Model, outcome: Outcome, exit_code: int) -> list[str]:
    expect = model.expect
    if outcome.kind not in model.kinds:
        named = "".join(f" ({name})" for name in outcome.names if name not in outcome.detail)
        return [f"{outcome.kind}: {outcome.detail}{named}"]
    if exit_code not in model.exits:
        return [f"exit {exit_code}"]
    if expect.property is None:
        return []
    if outcome.kind == "assumption":
        # TLC tells an assumption's place, not its name: "line 4, col 16 to line 4, col 20 of module MCAirt".
        matches = any(expect.property in name for name in outcome.names)
    else:
        # A newer TLC names each property that the counterexample breaks, an older one none of them.
        matches = expect.property in outcome.names
    named = ", ".join(outcome.names) or f"a property that TLC did not name ({outcome.detail})"
    return [] if matches else [f"violates {named}"]


def _time(model: Model, seconds: float) -> list[str]:
    least, most = model.seconds
    # A violation may come at once, whatever the model takes that it is a violation of.
    if seconds < least and model.expect.exit == 0:
        return [f"{seconds:.1f} s is faster than {least:g} s: has the model become trivial?"]
    return [f"{seconds:.1f} s is slower than {most:g} s"] if seconds > most else []


def _liveness(model: Model, outcome: Outcome, workers: int) -> list[str]:
    if outcome.liveness_checked and workers > 1:
        return [f"liveness was checked with {workers} workers: set workers to 1"]
    if model.kind == "liveness" and not outcome.liveness_checked:
        return ["TLC checked no liveness property"]
    return []


def _counts(model: Model, counts: Counts, kind: Kind, workers: int) -> list[str]:
    problems = []
    for name in COUNTS:
        pinned, came = getattr(model.expect, name), getattr(counts, name)
        if name == "depth" and (workers > 1 or model.workers > 1):
            continue  # with several workers TLC's depth is an estimate
        if pinned is None:
            if kind == "passed":
                problems.append(f"{name} is not pinned, came {came}")
        elif came is None and kind == "temporal":
            continue  # TLC 2.18 tells no depth here
        elif pinned != came:
            problems.append(f"{came} {name}, pinned {pinned}")
    return problems


def update(path: Path, result: Result) -> tuple[list[str], Result]:
    """Set the counts of a result that differs in nothing else: counts and depth, never an exit code or a property.

    A violation's counts are set only where some are pinned already. Return a line for each change (none: the file is
    untouched), and the result by the new pins.
    """
    changes: list[str] = []
    if result.exit is None or result.problems or not result.count_problems:
        return changes, result
    (entry,) = (entry for entry in read(path).entries if entry.name == result.model.name)
    for name in COUNTS:
        came = getattr(result.outcome.counts, name)
        several = name == "depth" and result.model.workers > 1
        pin = getattr(entry.expect, name)
        wanted = pin is not None or (result.outcome.kind == "passed" and not several)
        if wanted and came is not None and pin != came:
            changes.append(f"{entry.name}: {name} {'not pinned' if pin is None else pin} -> {came}")
            setattr(entry.expect, name, came)
    if not changes:
        return changes, result
    rewrite(entry)
    (model,) = (model for model in load(path).models if model.name == entry.name)
    return changes, judge(model, result.outcome, result.exit, result.seconds, result.workers, result.output)
