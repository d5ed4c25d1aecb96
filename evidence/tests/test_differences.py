"""The programs that tell CPUs, editions and readings apart still do, at their line."""

import pytest

from evidence.views.differences.pages import settled_table, untold, verified
from s7check.engine.client import Engine
from s7check.simulating.kept import DIFFERENCES, EXPERIMENTS, Kept, read_gaps, read_kept
from s7check.simulating.shortest import bounded

ALL = [*read_kept(DIFFERENCES), *read_kept(EXPERIMENTS)]


@pytest.mark.parametrize("one", ALL, ids=lambda one: f"{one.program['name']}-{one.refused.variant.name}")
def test_one_side_allows_what_the_other_does_not(one: Kept, engine: Engine) -> None:
    """The log of one side is refused by the other at the pinned line."""
    assert list(verified(engine, [one])) == [one]


def test_there_are_differences_between_cpus_and_editions() -> None:
    """Enough of them, each a program, a pair and a reason of its own."""
    found = {(one.allowed, one.refused, one.program["name"], tuple(one.requirements)) for one in read_kept(DIFFERENCES)}
    assert len(found) == len(read_kept(DIFFERENCES)) >= 30


def test_what_a_run_of_all_experiments_would_settle(engine: Engine) -> None:
    """The table of the page; a question without any experiment is named at its end."""
    experiments = read_kept(EXPERIMENTS)
    text = settled_table(experiments)
    nothing = {line.split("[")[1].split("]")[0] for line in text.splitlines() if line.endswith("| nothing |")}
    left = untold(experiments)
    readings = engine.alternatives().readings
    assert nothing == readings.keys() - {one.allowed.letters[0][0] for one in experiments}
    assert {(gap.ambiguity, gap.letters) for gap in read_gaps()} == {
        (name, pair) for name, pairs in left.items() for pair in pairs
    }
    assert sum(map(len, left.values())) + len(experiments) == sum(
        len(letters) * (len(letters) - 1) // 2 for letters in readings.values()
    )


def test_what_is_not_told_apart_was_searched_or_has_no_letters(engine: Engine) -> None:
    """A question that the specification answers by its letters has a bound, or a log for each pair.

    Or it says that it is newer than the last search.
    """
    letters = {name: set(all_letters) for name, all_letters in engine.alternatives().letters}
    for gap in read_gaps():
        decides = set(gap.letters) <= letters.get(gap.ambiguity, set())
        assert bool(gap.bounds) == (decides and gap.searched)
        assert all(bound.complete >= 1 for bound in gap.bounds)


def test_shorter_logs_were_searched() -> None:
    """Of every experiment, and for every two CPUs or editions that differ."""
    experiments, differences = read_kept(EXPERIMENTS), read_kept(DIFFERENCES)
    assert all(one.bounds for one in experiments if len(one.lines) > 1)
    pairs = {(one.allowed, one.refused) for one in differences}
    shortest = [one for one in differences if one.name.startswith("shortest-")]
    assert len(shortest) == len(pairs) == len({(one.allowed, one.refused) for one in shortest})
    assert all(one.bounds for one in shortest if len(one.lines) > 1)


@pytest.mark.parametrize("one", read_kept(EXPERIMENTS)[::30], ids=lambda one: one.program["name"])
def test_no_shorter_log_is_found(one: Kept, engine: Engine) -> None:
    """A part of the search, done again."""
    sides = one.allowed.variant, one.refused.variant
    lines, _ = bounded(engine, one.header, one.lines, *sides, pairs=150)
    assert lines is None
