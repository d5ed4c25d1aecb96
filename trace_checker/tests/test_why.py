"""The sentence that says why a line is not possible."""

import json

import msgspec
import pytest

from evidence.views.checker_page import why_texts
from s7check.engine.answer import Allowed, Moment
from s7check.engine.client import Engine
from s7check.judging.check import check_log
from s7check.report.clauses import event_text
from s7check.report.why import why_not
from tests.shipped import CASES, TRACES


@pytest.mark.parametrize(
    ("event", "expected", "requirement", "said"),
    [
        (
            '{"event": "SET_TINT", "ob": 10, "ret": 0}',
            [Allowed("SET_TINT", 10, "ret", 0x8091)],
            "TINT-18",
            (
                "SET_TINT cannot answer 16#0000 here. Monthly: the day of SDT is limited to 1 to 28 (TINT-18). "
                "It answers 16#8091."
            ),
        ),
        # Of a requirement with several sentences the one that has the code.
        (
            '{"event": "ACT_TINT", "ob": 10, "ret": "W#16#0000"}',
            [Allowed("ACT_TINT", 10, "ret", 0x80A0), Allowed("stop")],
            "TINT-61",
            "ACT_TINT cannot answer 16#0000 here. 80A0: nothing is set (TINT-61). It answers 16#80A0.",
        ),
        (
            '{"event": "start", "ob": 20, "info": {"sign": "W#16#0001"}}',
            [Allowed("start", 20, "sign", 7), Allowed("stop")],
            "DINT-22",
            (
                "start of OB 20 cannot have sign 16#0001 here. SIGN belongs to the program; the operating system hands "
                "it on unread (DINT-22). It has 16#0007."
            ),
        ),
        (
            '{"event": "start", "ob": 10, "info": {"time": "2026-11-21T06:00"}}',
            [Allowed("start", 10, "time", time=Moment(1))],
            "AIRT-01",
            (
                "start of OB 10 cannot have time 2026-11-21T06:00 here. DIS_AIRT holds back every interrupt and "
                "asynchronous error of a higher class than the current OB's (AIRT-01). It has 1990-01-01T00:01:00.000."
            ),
        ),
        # The code that the line has explains more than 0000, which is also a PERIOD.
        (
            '{"event": "ACT_TINT", "ob": 10, "ret": 32928}',
            [Allowed("ACT_TINT", 10, "ret", 0)],
            "TINT-61",
            "ACT_TINT cannot answer 16#80A0 here. 80A0: nothing is set (TINT-61). It answers 16#0000.",
        ),
        (
            '{"event": "start", "ob": 20, "info": {"sign": 8}}',
            [Allowed("start", 20, "sign", 7)],
            "DINT-22",
            (
                "start of OB 20 cannot have sign 16#0008 here. SIGN belongs to the program; the operating system hands "
                "it on unread (DINT-22). It has 16#0007."
            ),
        ),
        (
            '{"event": "diag", "id": 17768}',
            [Allowed("stop")],
            "OBS-22",
            (
                "The entry 16#4568 (STOP: OB 80 missing) cannot come here. A time error without OB 80: STOP, event "
                "4568 (OBS-22)."
            ),
        ),
        (
            '{"event": "diag", "id": "W#16#3502", "info": {"ev_ob": 10}}',
            [Allowed("diag", 80, "ev_ob", 11)],
            "OBS-22",
            (
                "The entry 16#3502 (OB still in process) cannot have ev_ob 10 here. A time error without OB 80: STOP, "
                "event 4568 (OBS-22). It has 11."
            ),
        ),
        (
            '{"event": "stop", "cause": "16#456D"}',
            [],
            "OBS-41",
            "The CPU cannot stop for 16#456D (STOP: OB 85 missing) here. STOP: no user program, no OB (OBS-41).",
        ),
        (
            '{"event": "restart", "type": "warm"}',
            [],
            "OBS-41",
            "A warm restart cannot begin here. STOP: no user program, no OB (OBS-41).",
        ),
        (
            '{"event": "start", "ob": 40}',
            [Allowed("start", 80, "flt_id", 2), Allowed("stop")],
            "OBS-02",
            (
                "OB 40 cannot start here. OBs of one class never interrupt each other; they run in the order "
                "of their start events (OBS-02)."
            ),
        ),
        (
            '{"event": "EN_AIRT", "ret": 0}',
            [],
            "OBS-41",
            "EN_AIRT cannot be called here. STOP: no user program, no OB (OBS-41).",
        ),
    ],
)
def test_sentence(event: str, expected: list[Allowed], requirement: str, said: str) -> None:
    """What cannot be, the rule, what is instead."""
    assert why_not(event.encode(), [], expected, [requirement, "OBS-01"]) == said


def test_late_line() -> None:
    """What had to come before the line."""
    assert why_not(b"{}", ["diag id=16#3502, within 10 ms", "stop"], [], ["OBS-41"]) == (
        "Before this line has to come: diag id=16#3502 (OB still in process), within 10 ms or stop. STOP: no user "
        "program, no OB (OBS-41)."
    )


@pytest.mark.parametrize("line", [[], None, {"event": "stop", "cause": {}}, {"event": "restart"}, {"event": "start"}])
def test_line_that_lacks_what_the_sentence_needs(line: object) -> None:
    """A line may be anything; a sentence about it is no error."""
    assert "(OBS-41)" in why_not(json.dumps(line).encode(), [], [], ["OBS-41"]) or not isinstance(line, dict)


def test_event_ids() -> None:
    """Every ID that the rules make has words; one that no source has, has none."""
    ids = [
        *range(0x3501, 0x3504),
        0x3505,
        0x3506,
        0x3507,
        *range(0x35A1, 0x35A4),
        0x4568,
        0x456D,
        0x454A,
        0x4562,
        0x5380,
    ]
    assert all(map(event_text, ids))
    assert event_text(0x5381) == ""


class _Refused(msgspec.Struct):
    why: str


class _Added(msgspec.Struct):
    refusal: _Refused | None = None


def test_the_engine_says_the_same(real_engine: Engine) -> None:
    """Of each twelfth rejected case: the page has the sentence of the report."""
    real_engine.ask({"message": "texts", **why_texts()}, _Added)
    said = {}
    for case in [case for case in CASES if case.verdict == "rejected"][::12]:
        header, *lines = [line.decode() for line in case.lines if line.strip()]
        real_engine.ask({"message": "open", "session": "why", "header": header}, _Added)
        refusal = real_engine.ask({"message": "add", "session": "why", "lines": lines}, _Added).refusal
        assert refusal is not None, case.name
        report = check_log(str(TRACES / case.file), real_engine, lambda *_: None)
        assert refusal.why == report.why, case.name
        said[case.name] = report.why
    assert len(said) > 80
