"""The picture of a log."""

from s7check.engine.answer import Frame, Pending, Situation, Step
from s7check.report.report import Report
from s7check.report.timeline import timeline
from tests.logs import event, log_text


def test_start_event_that_a_stop_clears() -> None:
    """It is gone; nobody has withdrawn it."""
    lines = log_text(event("interrupt", ob=40), event("stop", 32)).splitlines()
    waiting = Situation(mode="RUN", running=[Frame(1, 1)], pending=[Pending(40, 16)])
    steps = [Step(2, waiting), Step(3, Situation(mode="STOP"))]
    picture = timeline(Report("log", "accepted", "", lines=lines, steps=steps))
    assert picture is not None
    assert "OB 40 gone" in list(picture.lanes.itertext())


def texts(report: Report) -> list[tuple[str, float]]:
    """The texts of the picture's lanes with their heights."""
    picture = timeline(report)
    assert picture is not None
    return [("".join(one.itertext()), float(one.get("y", 0))) for one in picture.lanes.iter("text")]


def labels(report: Report) -> dict[str, float]:
    """The labels beside the lanes with their heights."""
    picture = timeline(report)
    assert picture is not None
    return {"".join(one.itertext()): float(one.get("y", 0)) for one in picture.labels.iter("text")}


def test_an_ob_within_a_range_of_its_class() -> None:
    """OB 55 is one of "OB 55-57": its lost start event is in their lane."""
    lines = log_text(event("interrupt", ob=55), event("interrupt", 32, ob=55)).splitlines()
    waiting = [Pending(ob, 2) for ob in (55, 56, 57)]
    before = Situation(mode="RUN", running=[Frame(1, 1)], pending=waiting)
    after = Situation(mode="RUN", running=[Frame(1, 1)])
    report = Report("log", "accepted", "", lines=lines, steps=[Step(2, before), Step(3, after)])
    named = labels(report)
    (lost,) = (y for text, y in texts(report) if text.startswith("OB 55 gone"))
    assert "OB 55-57" in "".join(named)
    assert named["class 2"] < lost < named["class 1"]


def test_an_ob_of_unknown_class() -> None:
    """Its lost start event is in no class's lane: nothing says which class it has."""
    lines = log_text(event("interrupt", ob=40), event("interrupt", 32, ob=41)).splitlines()
    steps = [Step(number, Situation(mode="RUN", running=[Frame(1, 1)])) for number in (2, 3)]
    report = Report("log", "accepted", "", lines=lines, steps=steps)
    named = labels(report)
    (lost,) = (y for text, y in texts(report) if text == "OB 41: no effect")
    assert abs(lost - named["no effect"]) < 10
    assert lost < named["class 1"]


def test_the_rejected_answer_is_not_shown_as_a_good_one() -> None:
    """Its RET_VAL and its mark have the colour of the rejection, those of other calls their own."""
    lines = log_text(event("DIS_AIRT", ret=1), event("EN_AIRT", 32, ret=5)).splitlines()
    state = Situation(mode="RUN", running=[Frame(1, 1)])
    report = Report("log", "rejected", "", line=3, lines=lines, steps=[Step(2, state)], situations=[state])
    picture = timeline(report)
    assert picture is not None
    by_line = {
        (group.findtext("title") or "")[:30].split('"')[3]: {str(one.get("class")) for one in group.iter()}
        for group in picture.lanes.iter("g")
    }
    assert "fine" in by_line["DIS_AIRT"]
    assert "wrong" in by_line["EN_AIRT"]
    assert not {"fine", "call fine"} & by_line["EN_AIRT"]


def test_several_lost_and_due_start_events_share_one_text() -> None:
    """Texts at one place would hide each other."""
    lines = log_text(event("stop", 31), event("start", 32, ob=1)).splitlines()
    pending = [Pending(ob, 16, ready=True) for ob in (40, 41)]
    before = Situation(mode="RUN", running=[Frame(1, 1)], pending=pending)
    lost = Report("log", "accepted", "", lines=lines, steps=[Step(2, before), Step(3, Situation(mode="RUN"))])
    assert [text for text, _ in texts(lost) if "gone" in text] == ["OB 40 gone, OB 41…"]
    due = Report("log", "rejected", "", line=3, lines=lines, steps=[Step(2, before)], situations=[before])
    assert [text for text, _ in texts(due) if "due" in text] == ["OB 40-41 due"]


def test_texts_of_a_column_stay_in_it() -> None:
    """A long text is cut; the next column has a text at the same height."""
    lines = log_text(event("DIS_AIRT", ret=1), event("clock", 32, to="2026-11-21T05:59:32.123")).splitlines()
    steps = [Step(2, Situation(mode="RUN", running=[Frame(1, 1)], pending=[Pending(ob, 16) for ob in range(40, 48)]))]
    shown = [text for text, _ in texts(Report("log", "accepted", "", lines=lines, steps=steps))]
    (waiting,) = (text for text in shown if "pending" in text)
    assert waiting.startswith("OB 40 pending")
    assert waiting.endswith("…")
    assert len(waiting) < 24
