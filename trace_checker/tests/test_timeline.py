"""The picture of a log."""

from s7check.engine.answer import Frame, Pending, Situation, Step
from s7check.judging.verdict import Report
from s7check.report.timeline import timeline
from tests.logs import event, log_text


def test_start_event_that_a_stop_clears() -> None:
    """It is gone; nobody has withdrawn it."""
    lines = log_text(event("interrupt", ob=40), event("stop", 32)).splitlines()
    waiting = Situation(mode="RUN", running=[Frame(1, 1)], pending=[Pending(40, 16)])
    steps = [Step(2, waiting), Step(3, Situation(mode="STOP"))]
    picture = timeline(Report("log", "accepted", "", lines=lines, steps=steps))
    assert picture is not None
    assert "OB 40 gone" in list(picture.itertext())
