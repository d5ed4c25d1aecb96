"""The differences from S7-300/400 to S7-1500: each log is one of the old CPU, and ``migrate`` names the difference."""

from __future__ import annotations

import msgspec
import pytest

from evidence.views.differences.migration import FAMILY, found_in, prefix_of
from s7check.asking.session import Session
from s7check.engine.client import Engine
from s7check.migrating.table import Difference, differences
from s7check.migrating.walk import points
from s7check.report.clauses import named

SHOWN = [one for one in differences(FAMILY) if one.shown]


def test_table() -> None:
    """All 57 in their order, each with a log or a reason, and with rules that exist."""
    table = differences(FAMILY)
    assert [one.id for one in table] == [f"MD-{number:02}" for number in range(1, 58)]
    assert all(bool(one.shown) != bool(one.none) for one in table)
    for one in table:
        assert [*named(" ".join((*one.old, *one.new)))] == [*dict.fromkeys((*one.old, *one.new))], one.id


@pytest.mark.parametrize("one", SHOWN, ids=lambda one: one.id)
def test_shown(engine: Engine, one: Difference) -> None:
    """The old CPU shows the log, and the new one does not: ``migrate`` knows by which difference."""
    prefix = prefix_of(engine, one)
    session = Session(engine, prefix.header)
    assert [session.feed(line) for _, line in prefix.events] == [None] * len(prefix.events)
    assert found_in(engine, one, prefix)


def test_controls_do_not_differ(engine: Engine) -> None:
    """OB 80 interrupts OB 35 on either CPU: no point but the hint about SDT."""
    told = "cpu=S7-400 obs=1,10,35,80 59:10 set 10 06:00 0401 0000; act 10 0000; 59:20 int 35; 59:20.001 start 35\n"
    shown = told + " 59:30 clock 6:30:00; 6:30:00.001 start 80 flt_id=05"
    one = next(one for one in differences(FAMILY) if one.id == "MD-15")
    made = msgspec.structs.replace(one, shown=shown, none="")
    assert {point.kind for point in points(engine, prefix_of(engine, made), FAMILY)} == {"hint"}
