"""Other readings of a rejected log: those on which its verdict cannot depend are not tried."""

from typing import Any

import pytest
from msgspec.structs import replace

from s7check.engine.client import Engine
from s7check.judging.check import check_log
from s7check.judging.replay import Replay, with_readings
from s7check.report.report import Report
from tests.shipped import log_of

LOGS = (
    "AMB-32-b-past-end-of-month-accepted",
    "AMB-38-c-leap-day-silent-in-common-years",
    "AMB-32-past-end-of-month-refused",
)


class Counting(Engine):
    """An engine that counts the logs that it is asked to judge."""

    begun = 0

    def begin(self, *args: Any, **options: Any) -> None:
        """Counts."""
        self.begun += 1
        super().begin(*args, **options)


def judged(log: str, engine: Engine) -> Report:
    """The report on a shipped log."""
    return check_log(str(log_of(log)), engine, lambda _source, _events: None)


@pytest.mark.parametrize("log", LOGS)
def test_readings_that_cannot_matter(log: str) -> None:
    """They have the verdict that they would have if they were tried, in less than a third of the runs."""
    with Counting() as engine:
        report = judged(log, engine)
        replay = Replay(report.log, report.lines)
        assert report.asked
        tried = with_readings(report, engine, replay).readings
        few, engine.begun = engine.begun - 1, 0
        assert with_readings(replace(report, asked=None), engine, replay).readings == tried
        assert few < engine.begun / 3


def test_what_is_remembered_is_asked_too() -> None:
    """The engine remembers evaluations: a log that it has seen depends on the same questions."""
    with Engine() as engine:
        asked = [[judged(log, engine).asked for log in LOGS] for _ in range(4)]
    assert asked[1:] == asked[:-1]
    assert asked[0][0] != asked[0][1]


def test_the_reasons_ask_nothing() -> None:
    """What a report explains about a rejection does not count."""
    with Engine() as engine:
        report = judged(LOGS[0], engine)
    assert report.asked is not None
    assert "AMB-32" in report.asked
    assert len(report.asked) < 20
