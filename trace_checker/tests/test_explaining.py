"""``s7check explain``: what a line needs that no line says, and what it brings about."""

from typing import Any

from s7check.asking.log_prefix import Prefix
from s7check.asking.session import Session
from s7check.engine.client import Engine
from s7check.explaining.command import Told, story
from tests.logs import HEADER, event

RUN = HEADER | {"obs": [1, 10, 11, 20, 40, 80, 85, 100], "mode": "RUN"}


def told(engine: Engine, header: dict[str, Any], *lines: dict[str, Any]) -> list[Told]:
    """The sentences about each line of a log."""
    session = Session(engine, header)
    try:
        return list(story(session, Prefix("log", header, list(enumerate(lines, 2)))))
    finally:
        session.close()


def test_an_end_of_ob_1_that_no_line_says(real_engine: Engine) -> None:
    """One EN_AIRT does not release three DIS_AIRT: the cycle has ended in between, which decides and is cited first."""
    delays = [event("DIS_AIRT", 31 + n, ret=n) for n in (1, 2, 3)]
    last = told(
        real_engine,
        RUN,
        *delays,
        event("interrupt", 35, ob=40),
        event("EN_AIRT", 35.001, ret=2),
        event("start", 35.002, ob=40),
    )[-1]
    assert last.sentences == [
        "OB 1 has ended unseen, and with it the delay of interrupts (count 2)",
        "OB 40 starts",
    ]
    assert last.requirements[0] == "AIRT-04"


def test_a_delay_that_was_taken_back(real_engine: Engine) -> None:
    """Where each DIS_AIRT has its EN_AIRT nothing unseen is told."""
    lines = [event("DIS_AIRT", ret=1), event("interrupt", ob=40), event("EN_AIRT", ret=0), event("start", ob=40)]
    last = told(real_engine, RUN, *lines)[-1]
    assert last.sentences == ["OB 40 starts, interrupting OB 1"]
    assert "AIRT-04" not in last.requirements


def test_what_a_restart_erases(real_engine: Engine) -> None:
    """A warm restart begins: settings, blocks and start events that are gone, the parameters that are back."""
    header = RUN | {"step7": {"tod": {"10": {"execution": "daily", "start": "2026-11-21T06:00", "active": True}}}}
    *_, stop, restart = told(
        real_engine,
        header,
        event("CAN_TINT", ob=10, ret=0),
        event("SET_TINT", ob=11, sdt="2026-11-29T06:00", period="W#16#0201", ret=0),
        event("DIS_IRT", mode=2, ob=20, ret=0),
        event("DIS_AIRT", ret=1),
        event("interrupt", ob=40),
        event("stop"),
        event("restart", 32, type="warm"),
    )
    assert stop.sentences == ["the CPU stops", "OB 1 is broken off", "the start events of OB 40 no longer wait"]
    assert restart.sentences == [
        "a warm restart begins",
        "the time-of-day settings of OB 11 are erased",
        "OB 10 is set as by STEP 7, from 2026-11-21T06:00, active",
        "OB 20 is blocked no more",
    ]


def test_starts_that_the_log_leaves_out(real_engine: Engine) -> None:
    """An end needs a start."""
    header = RUN | {"records": ["call", "clock", "mode", "interrupt", "load"]}
    last = told(real_engine, header, event("interrupt", ob=40), event("end", 32, ob=40))[-1]
    assert last.sentences == ["OB 40 has started unseen", "OB 40 ends"]


def test_entries_and_causes_in_words(real_engine: Engine) -> None:
    """An event ID has its text; a line that is not possible has the sentence that says why."""
    *_, stop, entry, wrong = told(
        real_engine,
        RUN | {"obs": [1, 10, 85, 100]},
        event("interrupt", ob=80, flt_id=1),
        event("stop", cause="W#16#4568"),
        event("diag", id="W#16#4568"),
        event("diag", 32, id="W#16#4562"),
    )
    assert stop.sentences[0] == "the CPU stops for 16#4568 (STOP: OB 80 missing)"
    assert entry.sentences == ["the diagnostic buffer has the entry 16#4568 (STOP: OB 80 missing)"]
    assert wrong.sentences[1].startswith("The entry 16#4562 (STOP: OB 121 missing) cannot come here. ")


def test_the_ob_of_a_time_error(real_engine: Engine) -> None:
    """An interrupt that is due while its OB runs: the call of OB 80 names that OB once."""
    header = RUN | {"step7": {"tod": {"10": {"execution": "minute", "start": "2026-11-21T06:00", "active": True}}}}
    lines = [
        event("start", ob=10) | {"at": "2026-11-21T06:00:00.000"},
        event("start", ob=80, info={"flt_id": "B#16#02", "ev_ob": 10}) | {"at": "2026-11-21T06:01:00.001"},
    ]
    *_, last = told(real_engine, header, *lines)
    assert "OB 80 with fault 16#02 is called because of OB 10" in last.sentences
