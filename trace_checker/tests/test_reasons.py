"""The requirement that a rejection cites first: the one that somebody who knows the manual would name."""

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from s7check import cli
from s7check.report.report import Report
from tests.logs import log_text

HEADER: dict[str, Any] = {
    "format": "s7-interrupt-log/1",
    "cpu": "S7-400",
    "obs": [1, 10, 20, 35, 40, 80, 82, 85, 100],
    "clock": "2026-11-21T08:00",
    "mode": "RUN",
    "cycle": True,
}
ALL_KINDS = {"records": ["call", "ob", "clock", "mode", "interrupt", "load", "diag"]}
S7_300 = {"cpu": "S7-300"}
WITHOUT_OB_80 = {"obs": [1, 10, 85, 100]}


def on(time: str, name: str, **fields: object) -> dict[str, Any]:
    """An event at a minute and a second after eight."""
    return {"event": name, "at": f"2026-11-21T08:{time}", **fields}


EVERY_MINUTE = [
    on("00:01", "SET_TINT", ob=10, sdt="2026-11-21T08:01", period="W#16#0201", ret=0),
    on("00:01", "ACT_TINT", ob=10, ret=0),
]
RUN_OF_POINT = [*EVERY_MINUTE, on("01:00", "start", ob=10), on("01:00", "end", ob=10)]
SET_BACK = on("01:01", "clock", to="2026-11-21T08:00:30")
SET_FORWARD = on("00:03", "clock", to="2026-11-21T08:05:03")
DELAYED = on("00:02", "DIS_AIRT", ret=1)
S7_1500 = {"cpu": "S7-1500", "obs": [1, 10, 20, 35, 40, 80, 82, 100, 121, 122]}
BY_LOCAL_TIME = {"zone": 60, "step7": {"tod": {"10": {
    "execution": "hourly", "start": "2026-01-01T00:30", "active": True, "local": True
}}}}  # fmt: skip
END_OF_MONTH = {"execution": "end_of_month", "start": "2026-12-31T06:00", "active": True}
WARM_RESTART = [on("00:01", "restart", type="warm"), on("00:02", "run")]
HOT = {"obs": [1, 20, 35, 40, 80, 82, 85, 100, 101]}
HOT_RESTART = [on("00:03", "stop"), on("00:10", "restart", type="hot"), on("00:10.003", "run")]
DELAY_KEPT = [on("00:01", "interrupt", ob=35), on("00:01.001", "start", ob=35), on("00:01.002", "DIS_AIRT", ret=1)]
EVERY_MINUTE_IN_STARTUP = [
    *(line | {"at": "2026-11-21T08:00:01.002"} for line in EVERY_MINUTE),
    on("00:01.002", "SRT_DINT", ob=20, dtime=100, sign=0, ret=0),
]
COLD_START = on("00:01.001", "start", ob=100, info={"strt_info": "B#16#85"})


def blocked(mode: str, ob: int) -> dict[str, Any]:
    """A DIS_IRT that works."""
    return on("00:01", "DIS_IRT", mode=mode, ob=ob, ret=0)


def error_ob(time: str, fault: str, **info: object) -> dict[str, Any]:
    """A start of OB 80."""
    return on(time, "start", ob=80, info={"flt_id": f"B#16#{fault}", **info})


@pytest.mark.parametrize(
    ("header", "lines", "first"),
    [
        # Delayed like any other: OB 80 of a time error, an OB 82.
        ({}, [*EVERY_MINUTE, DELAYED, SET_FORWARD, on("05:03", "start", ob=80)], "AIRT-09"),
        ({}, [DELAYED, on("00:03", "interrupt", ob=82), on("00:03", "start", ob=82)], "AIRT-09"),
        # The clock was set back in RUN: no mode has changed, and the point was served.
        ({}, [*RUN_OF_POINT, SET_BACK, on("01:00", "start", ob=10)], "CLK-09"),
        (S7_300, [*RUN_OF_POINT, SET_BACK, on("01:01", "EN_AIRT", ret="W#16#8080")], "CLK-10"),
        # Entries: of a missing OB for synchronous errors, of a time error with a wrong field, of a blocked OB.
        ({}, [on("00:01", "diag", id="W#16#4562")], "OBS-27"),
        (
            ALL_KINDS,
            [*EVERY_MINUTE, SET_FORWARD, on("05:03", "diag", id="W#16#3505", info={"error_info": "W#16#0002"})],
            "CLK-06",
        ),
        (
            ALL_KINDS,
            [blocked("B#16#82", 80), on("00:01", "diag", id="W#16#5380"), on("00:01", "diag", id="W#16#3502")],
            "IRT-09",
        ),
        # A STOP by rule.
        (WITHOUT_OB_80, [*EVERY_MINUTE, SET_FORWARD, on("05:03", "start", ob=10)], "OBS-22"),
        # What blocks the OB: everything, with what MODE adds; what enables one alone.
        (
            {},
            [
                blocked("B#16#00", 0),
                on("00:01", "EN_IRT", mode="B#16#02", ob=40, ret=0),
                on("00:02", "interrupt", ob=35),
                on("00:02", "start", ob=35),
            ],
            "IRT-06",
        ),
        ({}, [blocked("B#16#82", 40), on("00:02", "interrupt", ob=40), on("00:02", "start", ob=40)], "IRT-09"),
        # It waited before the block, which is for new events.
        (
            {},
            [
                *EVERY_MINUTE,
                DELAYED,
                on("01:10", "DIS_IRT", mode="B#16#00", ob=0, ret=0),
                on("01:20.000", "EN_AIRT", ret=0),
                on("01:20.011", "QRY_TINT", ob=10, status="W#16#0016", ret=0),
            ],
            "IRT-01",
        ),
        # EN_IRT has no MODE 80, whatever it would mean.
        ({}, [on("00:01", "EN_IRT", mode="B#16#80", ob=0, ret=0)], "IRT-13"),
        # The point has not run, when the clock passes it once more. A change of the zone is none of the clock.
        (
            S7_1500,
            [
                on("00:01", "SET_TINT", ob=10, sdt="2026-11-21T07:00", period="W#16#0201", ret=0),
                on("01:05", "ACT_TINT", ob=10, ret=0),
                on("01:10", "clock", to="2026-11-21T08:00:58"),
                on("01:00.011", "QRY_TINT", ob=10, status="W#16#0014", ret=0),
            ],
            "A15-17",
        ),
        (
            S7_1500 | BY_LOCAL_TIME,
            [
                on("10:00", "zone", zone=120, reason="zone"),
                on("10:00.003", "start", ob=80, info={"flt_id": "B#16#05"}),
            ],
            "T15-98",
        ),
        # A queue of one has dropped an event; an event has reached the threshold.
        (
            S7_1500 | {"queue": {"35": {"events": 1}}},
            [
                on("00:01", "interrupt", ob=35),
                on("00:01.001", "start", ob=35),
                *(on(f"00:01.{at}", "interrupt", ob=35) for at in (1, 2)),
                on("00:01.3", "end", ob=35),
                on("00:01.301", "start", ob=35),
                on("00:01.302", "end", ob=35),
                on("00:01.303", "start", ob=35),
            ],
            "T15-69",
        ),
        (
            S7_1500 | {"queue": {"35": {"events": 1, "threshold": 1}}},
            [
                on("00:01", "interrupt", ob=35),
                on("00:01.001", "start", ob=35),
                on("00:01.1", "interrupt", ob=35),
                on("00:01.111", "end", ob=35),
            ],
            "T15-73",
        ),
        # What a hot restart keeps: a job, a count. What every restart discards.
        (
            HOT,
            [
                on("00:01", "SRT_DINT", ob=20, dtime=20000, sign=0, ret=0),
                *HOT_RESTART,
                on("00:40", "EN_AIRT", ret="W#16#8080"),
            ],
            "DINT-13",
        ),
        (HOT, [*DELAY_KEPT, *HOT_RESTART, on("00:10.004", "EN_AIRT", ret="W#16#8080")], "OBS-54"),
        (
            HOT,
            [*DELAY_KEPT, on("00:02", "interrupt", ob=40), *HOT_RESTART, on("00:10.006", "start", ob=40)],
            "OBS-54",
        ),
        (
            HOT,
            [
                DELAYED,
                on("00:02.5", "interrupt", ob=82),
                *HOT_RESTART,
                on("00:11", "EN_AIRT", ret=0),
                on("00:11.001", "start", ob=82),
            ],
            "OBS-52",
        ),
        # The setting of STEP 7 is back, and the point comes in RUN. After STARTUP the highest class runs first.
        (
            {"step7": {"tod": {"10": {"execution": "hourly", "start": "2026-11-20T09:00", "active": True}}}},
            [
                on("00:01", "CAN_TINT", ob=10, ret=0),
                on("00:02", "stop"),
                on("00:03", "restart", type="warm"),
                on("00:04", "run"),
                {"event": "done", "at": "2026-11-21T09:00:01"},
            ],
            "OBS-50",
        ),
        (
            {"mode": "STOP"},
            [
                on("00:01", "restart", type="warm"),
                on("00:01.001", "start", ob=100),
                *EVERY_MINUTE_IN_STARTUP,
                on("01:10", "end", ob=100),
                on("01:11", "run"),
                on("01:11.003", "start", ob=10),
            ],
            "OBS-03",
        ),
        # Days after STARTUP its rules explain nothing; the series does, or that STEP 7's one run was long ago.
        (
            {"mode": "STOP", "step7": {"tod": {"10": END_OF_MONTH}}},
            [*WARM_RESTART, {"event": "start", "at": "2026-11-30T06:00:00", "ob": 10}],
            "TINT-19",
        ),
        (
            {"mode": "STOP", "step7": {"tod": {"10": END_OF_MONTH | {"execution": "once"}}}},
            [
                *WARM_RESTART,
                {"event": "start", "at": "2026-12-31T06:00:00", "ob": 10},
                {"event": "end", "at": "2026-12-31T06:00:01", "ob": 10},
                {"event": "stop", "at": "2026-12-31T06:10:02"},
                {"event": "restart", "at": "2026-12-31T06:10:02", "type": "warm"},
                {"event": "run", "at": "2026-12-31T06:10:02"},
                {"event": "done", "at": "2026-12-31T06:10:05"},
            ],
            "OBS-56",
        ),
        # After a hot restart: bits that it does not keep, a class.
        (
            HOT,
            [blocked("B#16#00", 0), *HOT_RESTART, on("00:12", "QRY_TINT", ob=10, status="W#16#1012", ret=0)],
            "TINT-79",
        ),
        (
            HOT,
            [
                on("00:01", "SRT_DINT", ob=20, dtime=20000, sign=0, ret=0),
                *HOT_RESTART,
                on("00:28", "start", ob=20, info={"priority": 4}),
            ],
            "DINT-01",
        ),
        # The run behind OB 80 has not come.
        (
            {"readings": {"AMB-77": "a"}},
            [
                *(on(f"00:01.00{at}", name, ob=35) for at, name in enumerate(("interrupt", "start", "interrupt"))),
                error_ob("00:01.003", "02"),
                on("00:01.004", "end", ob=80),
                on("00:01.005", "end", ob=35),
                on("00:02", "done"),
            ],
            "OBS-30",
        ),
        # OB 121 is loaded, and fails itself.
        (
            {"obs": [1, 121, 122]},
            [on(f"00:01.{at}", name, ob=121) for at in (1, 2) for name in ("interrupt", "start")],
            "AMB-85",
        ),
        # An OB that started in some ms of a second ended before the first one that it can be.
        (
            {},
            [
                on("00:01.500", "SRT_DINT", ob=20, dtime=1000, sign=7, ret=0),
                on("00:02", "start", ob=20),
                on("00:02.400", "end", ob=20),
            ],
            "CLK-01",
        ),
        # Start information.
        ({"mode": "STOP"}, [on("00:01", "restart", type="warm"), COLD_START], "OBS-10"),
        (
            {},
            [
                on("00:01", "SRT_DINT", ob=20, dtime=100, sign=7, ret=0),
                on("00:01.100", "start", ob=20, info={"sign": 8}),
            ],
            "DINT-03",
        ),
    ],
)
def test_first(
    header: dict[str, Any], lines: list[dict[str, Any]], first: str, tmp_path: Path, judge: Callable[[Path], Report]
) -> None:
    """The last line is rejected, and the requirement stands first."""
    log = tmp_path / "log.ndjson"
    log.write_bytes(log_text(*lines, header=HEADER | header))
    report = judge(log)
    assert (report.verdict, report.line) == ("rejected", len(lines) + 1), report
    assert report.requirements[0] == first
    assert f"({first})" in report.why


def test_wrong_fields_are_named(tmp_path: Path, judge: Callable[[Path], Report]) -> None:
    """The field of an entry and of a start, and what it has to be."""
    log = tmp_path / "log.ndjson"
    wrong = on("05:03", "diag", id="W#16#3505", info={"error_info": "W#16#0002"})
    log.write_bytes(log_text(*EVERY_MINUTE, SET_FORWARD, wrong, header=HEADER | ALL_KINDS))
    report = judge(log)
    assert "diag ob=80 error_info=16#0001" in report.expected
    assert "cannot have error_info 16#0002" in report.why


OVERFLOW_ERROR = [
    on("00:02", "DIS_AIRT", ret=1),
    *(on(f"00:02.00{at}", "interrupt", ob=40) for at in (3, 4)),
    on("00:02.1", "EN_AIRT", ret=0),
]
DAYLIGHT = {"clock": "2027-03-28T00:59:00"} | S7_1500 | BY_LOCAL_TIME


@pytest.mark.parametrize(
    ("header", "lines", "said"),
    [
        # Of several requests the one with the fault of the line counts.
        (S7_300, [*OVERFLOW_ERROR, error_ob("00:02.101", "07", priority=26)], "priority 26 here. OB 80 .* It has 28."),
        (S7_300, [*OVERFLOW_ERROR, error_ob("00:02.101", "02", priority=28)], "priority 28 here. OB 80 .* It has 26."),
        # Tags of an S7-1500.
        (
            S7_1500,
            [
                *RUN_OF_POINT[:-1],
                on("01:59.9", "interrupt", ob=40),
                on("01:59.901", "start", ob=40),
                error_ob("02:00.001", "02", csg_ob=10),
            ],
            "csg_ob 10 here. .* It has 40.",
        ),
        (
            S7_1500,
            [
                *EVERY_MINUTE,
                on("00:02", "end", ob=1),
                on("00:02.001", "clock", to="2026-11-21T08:05"),
                error_ob("05:00.001", "05", csg_priority=3),
            ],
            "csg_priority 3 here. .* It has 0.",
        ),
        (
            DAYLIGHT,
            [
                {"at": "2027-03-28T01:00", "event": "zone", "zone": 120, "reason": "daylight"},
                {"at": "2027-03-28T01:00:00.005", "event": "start", "ob": 10, "info": {"caught_up": False}},
            ],
            "caught_up false here. .* It has true.",
        ),
        (
            S7_1500,
            [*RUN_OF_POINT, SET_BACK, on("01:00", "start", ob=10, info={"second_time": False})],
            "second_time false here. .* It has true.",
        ),
        (
            S7_1500 | {"queue": {"35": {"events": 1}}},
            [
                on("00:01", "interrupt", ob=35),
                on("00:01.001", "start", ob=35),
                *(on(f"00:01.{at}", "interrupt", ob=35) for at in (1, 2)),
                on("00:01.3", "end", ob=35),
                on("00:01.301", "start", ob=35, info={"event_count": 2}),
            ],
            "event_count 2 here. .* It has 0 or 1.",
        ),
        # OBs that no request starts.
        (
            {"mode": "STOP"},
            [
                on("00:01", "restart", type="warm"),
                on("00:01.003", "run"),
                on("00:01.004", "start", ob=1, info={"strt_info": "B#16#04"}),
            ],
            "strt_info 16#04 here. .* It has 16#01.",
        ),
        (
            {"mode": "STOP"},
            [on("00:01", "restart", type="warm"), COLD_START],
            "strt_info 16#85 here. .* It has 16#81 or 16#82.",
        ),
        # A sentence says of what it speaks, also that of a question.
        (
            {"cpu": "S7-400", "priority": {"10": 12}},
            [
                *EVERY_MINUTE,
                on("00:59.9", "interrupt", ob=35),
                on("00:59.901", "start", ob=35),
                on("01:00.005", "start", ob=10),
            ],
            "On S7-400 and CPU 318 a class that is set holds",
        ),
        (
            S7_1500 | {"zone": 60},
            [
                on("00:01", "SET_TINTL", ob=10, sdt="2026-11-21T09:00", local=True, period=0, activate=True, ret=0),
            ],
            "SET_TINTL: 0000, 8090",
        ),
        (
            {"obs": [1, 121, 122]},
            [on(f"00:01.{at}", name, ob=121) for at in (1, 2) for name in ("interrupt", "start")],
            r"The sources leave open: .* OB 122\? \(AMB-85\) a: the other .*; b: any second .*; c: either\.$",
        ),
    ],
)
def test_said(
    header: dict[str, Any], lines: list[dict[str, Any]], said: str, tmp_path: Path, judge: Callable[[Path], Report]
) -> None:
    """The last line is rejected, and the sentence names the field that is wrong, or has these words."""
    log = tmp_path / "log.ndjson"
    log.write_bytes(log_text(*lines, header=HEADER | header))
    report = judge(log)
    assert (report.verdict, report.line) == ("rejected", len(lines) + 1), report
    assert re.search(said, report.why), report.why


@pytest.mark.parametrize(
    ("lines", "action", "values"),
    [
        ([on("00:01", "EN_AIRT", ret=0)], "IsCall(OB 0)", "ret = 16#0000, AnswersTo(e) = {16#8080}"),
        ([on("00:01", "stop", cause="W#16#4562")], "IsStop(OB 0)", "stopCause = -1, cause = 16#4562"),
        ([on("00:01", "start", ob=20)], "IsStart(OB 20)", "the set is empty"),
        (
            [on("00:01", name, ob=ob) for ob in (40, 35) for name in ("interrupt", "start")],
            "Start(OB 35)",
            "r.class = 12, Running.class = 16",
        ),
    ],
)
def test_formulas_have_codes_in_hexadecimal(
    lines: list[dict[str, Any]], action: str, values: str, tmp_path: Path, judge: Callable[[Path], Report]
) -> None:
    """RET_VAL and causes of a STOP; OBs, classes and what is not logged stay."""
    log = tmp_path / "log.ndjson"
    log.write_bytes(log_text(*lines, header=HEADER))
    found = [(one.action, one.values) for one in judge(log).candidates]
    assert any(one.startswith(action) and values in each for one, each in found), found


def test_two_families(capsys: pytest.CaptureFixture[str]) -> None:
    """What tells an S7-300 from an S7-400 is whether a point comes again once the clock is set back."""
    assert cli.main(["distinguish", "--cpu", "S7-300", "--cpu", "S7-400", "--budget", "0", "--pairs", "1"]) == 0
    said = capsys.readouterr().out
    assert "cpu S7-300 allows it: CLK-10" in said
    assert "CLK-09" in said.partition("cpu S7-400 does not")[2]
