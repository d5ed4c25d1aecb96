"""No log costs more than its length: the states that it leads to, counted."""

from collections.abc import Iterator

import pytest

from evidence.growth.logs import Kind, kinds
from evidence.growth.measure import answer_of
from s7check.engine.client import Engine

KINDS = {kind.name: kind for kind in kinds()}


@pytest.fixture(scope="module")
def engine() -> Iterator[Engine]:
    """One engine for all logs."""
    with Engine() as engine:
        yield engine


@pytest.mark.parametrize("kind", [kind for kind in KINDS.values() if kind.states], ids=lambda kind: kind.name)
def test_states(engine: Engine, kind: Kind) -> None:
    """At its largest each kind of log has its verdict, and as many states as its kind allows."""
    log = kind.log(kind.large if not kind.long else kind.little)
    answer = answer_of(engine, log)
    assert answer.verdict == ("rejected" if kind.rejected else "accepted")
    assert answer.line == (len(log.events) + 1 if kind.rejected else None)
    assert answer.largest <= kind.states
    assert answer.followed <= kind.followed * len(log.events)
