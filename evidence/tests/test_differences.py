"""The programs that tell CPUs, editions and readings apart still do, at their line."""

from collections.abc import Iterator

import pytest

from evidence.differences.kept import DIFFERENCES, EXPERIMENTS, Kept, read_kept
from evidence.differences.pages import RULES, verified
from s7check.engine.client import Engine

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
