"""The programs that tell CPUs, editions and readings apart still do, at their line."""

import re
from collections.abc import Iterator

import pytest

from evidence.differences.kept import DIFFERENCES, EXPERIMENTS, Kept, read_kept
from evidence.differences.pages import RULES, SOURCES, settled_table, sources, untold, verified
from s7check.engine.client import Engine
from s7check.log.tables import READINGS

ALL = [*read_kept(DIFFERENCES), *read_kept(EXPERIMENTS)]


@pytest.fixture(scope="module")
def engine() -> Iterator[Engine]:
    """An engine for all of them."""
    with Engine() as one:
        yield one


@pytest.mark.parametrize("one", ALL, ids=lambda one: f"{one.program['name']}-{one.refused.variant.name}")
def test_one_side_allows_what_the_other_does_not(one: Kept, engine: Engine) -> None:
    """The log of one side is refused by the other at the pinned line."""
    assert list(verified(engine, [one])) == [one]


def test_there_are_differences_between_cpus_and_editions() -> None:
    """Enough of them, each a program, a pair and a reason of its own."""
    found = {(one.allowed, one.refused, one.program["name"], tuple(one.requirements)) for one in read_kept(DIFFERENCES)}
    assert len(found) == len(read_kept(DIFFERENCES)) >= 30


def test_the_pages_name_every_program() -> None:
    """They are written anew after a search."""
    for file, page in ((DIFFERENCES, "differences.md"), (EXPERIMENTS, "experiments.md")):
        text = (RULES / page).read_text(encoding="utf-8")
        assert all(one.program["name"] in text for one in read_kept(file))


def test_each_experiment_has_its_source_for_step_7() -> None:
    """The folder has these files and no other, and the page leads to each."""
    text = (RULES / "experiments.md").read_text(encoding="utf-8")
    kept = {file.stem: file.read_text(encoding="utf-8") for file in SOURCES.iterdir()}
    assert kept == sources(read_kept(EXPERIMENTS))
    assert all(f"({SOURCES.name}/{name}.scl)" in text for name in kept)


def test_what_a_run_of_all_experiments_would_settle() -> None:
    """The table of the page; a question without any experiment is named at its end."""
    experiments = read_kept(EXPERIMENTS)
    text = (RULES / "experiments.md").read_text(encoding="utf-8")
    assert settled_table(experiments) in text
    told = {one.allowed.letters[0][0] for one in experiments}
    nothing = {line.split("[")[1].split("]")[0] for line in text.splitlines() if line.endswith("| nothing |")}
    without = set(re.findall(r"\[(AMB-\d+)\]", text.partition("## Without an experiment")[2]))
    assert nothing == without == READINGS.keys() - told
    left = untold(experiments)
    assert sum(map(len, left.values())) + len(experiments) == sum(
        len(letters) * (len(letters) - 1) // 2 for letters in READINGS.values()
    )
