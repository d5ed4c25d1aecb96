"""Judging a run where no TLC is needed: what depends on the number of workers, and on what TLC leaves out."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from evidence.models.entries import Expect
from evidence.models.judge import judge
from evidence.models.manifest import Model, load
from evidence.tla.messages import Counts, Outcome

PASSED = Outcome("passed", counts=Counts(6, 5, 5), liveness_checked=True)


@pytest.fixture
def models() -> dict[str, Model]:
    """Load the models of the fixture project, by name."""
    manifest = load(Path(__file__).parent / "fixtures" / "models" / "models.txt")
    return {m.name: m for m in manifest.models}


def test_liveness_with_several_workers_is_drift(models: dict[str, Model]) -> None:
    """Liveness that was checked by two workers does not count, whatever the entry calls itself."""
    result = judge(models["counter"], PASSED, 0, 1.0, 2, "")
    assert result.problems == ("liveness was checked with 2 workers: set workers to 1",)


def test_depth_counts_with_one_worker_only(models: dict[str, Model]) -> None:
    """With several workers the depth is not compared, the other counts are."""
    model = replace(models["counter"], kind="model", workers=2, expect=Expect(exit=0, states=6, distinct=5))
    outcome = replace(PASSED, liveness_checked=False, counts=Counts(6, 5, 9))
    assert judge(model, outcome, 0, 1.0, 2, "").ok
    other = judge(model, replace(outcome, counts=Counts(6, 4, 9)), 0, 1.0, 2, "")
    assert other.count_problems == ("4 distinct, pinned 5",)


def test_depth_that_tlc_does_not_tell(models: dict[str, Model]) -> None:
    """A liveness violation may come without a depth; any other pinned count must come."""
    model = models["neg-returns"]
    model = replace(model, expect=Expect(exit=13, property="Returns", distinct=5, depth=5))
    outcome = Outcome("temporal", names=("Returns",), counts=Counts(6, 5, None))
    assert judge(model, outcome, 13, 1.0, 1, "").ok
    assert judge(model, outcome, 12, 1.0, 1, "").ok, "some versions exit with 12 for a property"


def test_exit_of_an_invariant_is_exact(models: dict[str, Model]) -> None:
    """An invariant's violation has exit 12 and no other."""
    outcome = Outcome("invariant", names=("InRange",), counts=Counts(6, 6, 6))
    assert judge(models["neg-overshoot"], outcome, 12, 1.0, 1, "").ok
    assert judge(models["neg-overshoot"], outcome, 13, 1.0, 1, "").problems == ("exit 13",)


def test_unnamed_violation_is_drift(models: dict[str, Model]) -> None:
    """A violation that could not be put down to the pinned property is drift."""
    outcome = Outcome("temporal", detail="Temporal properties were violated.")
    assert "did not name" in judge(models["neg-returns"], outcome, 13, 1.0, 1, "").problems[0]
