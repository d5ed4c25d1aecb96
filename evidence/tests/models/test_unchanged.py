"""A model is as it was while nothing changes that decides its result."""

import json
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from evidence.common.checkout import MANIFEST, ROOT
from evidence.models.manifest import load
from evidence.models.unchanged import FULL, origin
from evidence.tests.models.conftest import FIXTURES


@pytest.fixture
def origins(tmp_path: Path) -> Callable[..., dict[str, str]]:
    """Return a function that gives the models' hashes after a text of a file is replaced."""

    def after(file: str = "spec/Counter.tla", old: str = "", new: str = "") -> dict[str, str]:
        folder = tmp_path / str(len(list(tmp_path.iterdir())))
        shutil.copytree(FIXTURES, folder)
        text = (folder / file).read_text(encoding="utf-8")
        assert old in text
        (folder / file).write_text(text.replace(old, new, 1), encoding="utf-8")
        return {model.name: origin(model, folder) for model in load(folder / "models" / "models.txt").models}

    return after


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("\\* A counter", "\\* The counter"),
        ("Next == Count", "Next  ==  Count"),
        ("StartsAtOne == x = 1", "StartsAtOne == x = 2"),
    ],
)
def test_what_does_not_count(origins: Callable[..., dict[str, str]], old: str, new: str) -> None:
    """A comment, layout, and a formula that the model does not check."""
    before, after = origins(), origins(old=old, new=new)
    assert before["counter"] == after["counter"]


def test_what_counts(origins: Callable[..., dict[str, str]]) -> None:
    """A step, a formula that is checked, an assumption, a constant, a pin."""
    before = origins()["counter"]
    for file, old, new in (
        ("spec/Counter.tla", "x' = x + 1\nAgain", "x' = x + 2\nAgain"),
        ("spec/Counter.tla", "x <= Limit", "x < Limit"),
        ("spec/Counter.tla", "Limit > 0", "Limit > 1"),
        ("models/MCCounter.cfg", "Limit = ", "Limit = 1"),
        ("models/models.txt", "distinct ", "distinct 1"),
    ):
        assert origins(file, old, new)["counter"] != before, (file, new)


def test_the_results_of_the_tree() -> None:
    """Each is of a model of the full lane that is no control, and as pinned."""
    models = load(ROOT / MANIFEST).models
    full = {model.name for model in models if model.lane == "full" and model.kind != "negative"}
    kept = json.loads((ROOT / FULL).read_bytes())
    assert kept
    assert {name for name, one in kept.items() if name not in full or not one["came"]["ok"]} == set()
