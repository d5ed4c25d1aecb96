"""Running models, and the shipped logs, on a copy of the specification with marks that TLC tells."""

from __future__ import annotations

import shutil
import tempfile
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from evidence.models.manifest import Model
from evidence.models.runner import Event, Harness, run_all
from evidence.mutants import logs_model as logs
from evidence.mutants.conditions import Condition, Side
from evidence.tla.marks import Wrapping, evaluated, marked
from evidence.tla.syntax import Module, Span

LONGEST = 7200.0
"""Seconds that a model has beyond its own."""


class CollectingError(RuntimeError):
    """A model came to nothing on the marked copy; the text says which and why."""


@dataclass(frozen=True)
class Seen:
    """A condition, and by which models each of its sides was seen."""

    condition: Condition
    by: Mapping[Side, tuple[str, ...]]

    @property
    def missing(self) -> tuple[Side, ...]:
        """The sides without a witness."""
        return tuple(side for side in self.condition.sides if not self.by[side])

    @property
    def by_logs_alone(self) -> bool:
        """Whether it is witnessed, but not without the shipped logs."""
        return not self.missing and any(self.by[side] == (logs.NAME,) for side in self.condition.sides)


def collect(
    harness: Harness,
    spec: Mapping[str, Module],
    found: Sequence[Condition],
    models: Sequence[Model],
    traces: Path | None,
    jobs: int,
    tell: Callable[[Event], None],
) -> list[Seen]:
    """Run the models, and the logs of `traces`, and return the conditions that they met. Raises `CollectingError`."""
    shipped = [] if traces is None else logs.readable(traces)

    def hear(event: Event) -> None:
        if event.result is None:
            tell(event)
            return
        if event.result.problems:
            raise CollectingError(f"{event.model.name}: {event.result.problems[0]}: {event.result.outcome.detail}")
        if event.model.name == logs.NAME and (wrong := logs.differences(event.result.output, shipped)):
            raise CollectingError(f"TLC and the cases of {traces} differ in {len(wrong)} logs, {wrong[0]} among them")
        # Of a disjunction between marks TLC takes one side only: its counts are not the pinned counts.
        tell(replace(event, result=replace(event.result, count_problems=())))

    running = [replace(model, seconds=(0.0, model.seconds[1] + LONGEST)) for model in models]
    with tempfile.TemporaryDirectory(prefix="s7check-witnesses-", ignore_cleanup_errors=True) as temporary:
        root = Path(temporary).resolve()
        directory = root / "models"
        (root / "spec").mkdir()
        shutil.copytree(harness.manifest.directory, directory)
        for name, text in ({name: module.text for name, module in spec.items()} | _marked(spec, found)).items():
            (root / "spec" / f"{name}.tla").write_bytes(text)
        if traces is not None:
            (directory / f"{logs.MODULE}.tla").write_text(logs.module(shipped), encoding="utf-8")
            running.append(logs.model(LONGEST))
        manifest = replace(harness.manifest, path=directory / harness.manifest.path.name, spec=root / "spec")
        results = run_all(replace(harness, manifest=manifest), running, jobs, hear)
    told: defaultdict[int, list[str]] = defaultdict(list)
    for result in results:
        for number in sorted(evaluated(result.output)):
            told[number].append(result.model.name)
    return [
        Seen(condition, {side: tuple(told[condition.mark(side)]) for side in condition.sides}) for condition in found
    ]


def _marked(spec: Mapping[str, Module], found: Sequence[Condition]) -> dict[str, bytes]:
    around: dict[tuple[str, Span], Wrapping] = {}
    for condition in found:
        place = condition.module, condition.span
        before, after = around.get(place, ("", ""))
        around[place] = (before + condition.wrapping[0] + " ", condition.wrapping[1] + after)
    return marked(spec, around, 2 * len(found))
