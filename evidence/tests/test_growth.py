"""No log costs more than its length: the states that it leads to, counted."""

from pathlib import Path

import pytest

from evidence.logs.growth_costs import answer_of
from evidence.logs.growth_logs import Kind, kinds, missing_due, text, wrong_at_the_end
from s7check.asking.session import Session
from s7check.engine.answer import Answer
from s7check.engine.client import Engine
from s7check.judging.check import check_log
from s7check.judging.replay import Replay, with_readings

KINDS = {kind.name: kind for kind in kinds()}


@pytest.mark.parametrize("kind", [kind for kind in KINDS.values() if kind.states], ids=lambda kind: kind.name)
def test_states(engine: Engine, kind: Kind) -> None:
    """At its largest each kind of log has its verdict, and as many states as its kind allows."""
    log = kind.log(kind.large if not kind.long else kind.little)
    answer = answer_of(engine, log)
    assert answer.verdict == ("rejected" if kind.rejected else "accepted")
    assert answer.line == (len(log.events) + 1 if kind.rejected else None)
    assert answer.largest <= kind.states
    assert answer.followed <= kind.followed * len(log.events)


class Counting(Engine):
    """An engine that counts the logs that it judges, and their steps."""

    logs = 0
    followed = 0

    def finish(self, broken: bool = False) -> Answer:
        """Counts."""
        answer = super().finish(broken)
        self.logs += 1
        self.followed += answer.followed
        return answer


def test_other_readings(tmp_path: Path) -> None:
    """A rejected log is judged again under the readings that some step of it asked for alone, with few steps each."""
    log = tmp_path / "wrong.ndjson"
    log.write_text(text(wrong_at_the_end(7)))
    with Counting() as engine:
        report = check_log(str(log), engine, lambda _source, _events: None)
        report = with_readings(report, engine, Replay(str(log), report.lines))
    assert (report.verdict, report.line) == ("rejected", 26)
    assert len(report.readings or ()) > 100
    assert engine.logs <= 36
    assert engine.followed <= 40 * engine.logs


def test_definite_facts_are_left(engine: Engine) -> None:
    """A wrong line is rejected, and a right one accepted, behind lines that more states explain than are followed."""
    log = missing_due(8)
    session = Session(engine, log.header)
    for line in log.events:
        assert session.feed(line) is None
    # No line loads OB 40 or asks for it: all states would rule it out, and definite facts do not.
    assert session.why({"event": "start", "ob": 40}) is None
    for status in ("16#0000", "16#0004"):
        assert session.why({"event": "QRY_TINT", "ob": 10, "ret": "16#0000", "status": status}) is None
    for wrong, rule in (
        ({"event": "end", "ob": 85}, "OBS-01"),
        ({"event": "release"}, "OBS-40"),
        ({"event": "EN_AIRT", "ret": "16#8090"}, "AIRT-07"),
        ({"event": "QRY_TINT", "ob": 10, "ret": "16#0000", "status": "16#00FF"}, "TINT-79"),
    ):
        refusal = session.why(wrong)
        assert refusal is not None
        assert rule in refusal.requirements
    session.close()
