"""Questions about a log that grows, asked of the real engine, and ``s7check next``."""

import json
from pathlib import Path
from typing import Any

import pytest

from s7check import cli
from s7check.asking.line_text import iso_of
from s7check.asking.log_prefix import read_prefix
from s7check.asking.next_answer import opened
from s7check.asking.open_questions import open_questions
from s7check.asking.session import Session
from s7check.engine.client import Engine
from s7check.log.calls import MODES
from s7check.log.errors import UnusableLogError
from tests.logs import HEADER, RUN, at, event, log_text
from tests.shipped import CASES, TRACES

MINUTE: dict[str, Any] = {"ob": 10, "sdt": "2026-11-21T06:00", "period": "W#16#0201", "ret": 0}
ARMED = (event("SET_TINT", **MINUTE), event("ACT_TINT", ob=10, ret=0))

MOST_ANSWERS = 12

COMPLETE = [
    case.file
    for case in sorted(CASES, key=lambda case: case.file)
    if case.verdict == "accepted" and b'"records"' not in case.log
][::25]
"""Some logs that are accepted and have every kind of event."""


def begun(engine: Engine, *lines: dict[str, Any], **header: Any) -> Session:
    """A session after these lines."""
    session = Session(engine, RUN | header)
    for line in lines:
        assert session.feed(line) is None
    return session


def lines_of(session: Session) -> dict[str, tuple[str, str | None]]:
    """The possible starts, by OB and fault, with the first and the last time at which they may come."""
    possible = session.possible()
    return {
        f"{line['ob']} {line.get('info', {}).get('flt_id', '')}".strip(): (
            iso_of(possible.times[each.first].at),
            None if each.last is None else iso_of(possible.times[each.last].at),
        )
        for each in possible.lines
        if (line := each.event)["event"] == "start"
    }


def test_what_is_due_has_its_time(real_engine: Engine) -> None:
    """The OB of a point may start from the point on, until the latency is over; then nothing else may come."""
    session = begun(real_engine, *ARMED)
    assert lines_of(session)["10"] == ("2026-11-21T06:00:00.000", "2026-11-21T06:00:00.010")
    possible = session.possible()
    assert not possible.endless
    (due,) = (one for one in possible.times if one.due)
    assert [(one.event, one.ob) for one in due.due] == [("start", 10)]
    assert "TINT-32" in due.requirements
    assert iso_of(due.at) == "2026-11-21T06:00:00.010"


def test_what_may_come_to_nothing_has_an_end(real_engine: Engine) -> None:
    """A catch-up after HOLD comes within the latency or not at all: at 4 ms there are 6 left."""
    session = begun(
        real_engine,
        event("hold"),
        event("release", at="2026-11-21T06:00:30.000"),
        event("start", at="2026-11-21T06:00:30.000", ob=80, info={"flt_id": 6}),
        event("end", at="2026-11-21T06:00:30.000", ob=80),
        event("EN_AIRT", at="2026-11-21T06:00:30.004", ret=0x8080),
        step7={"tod": {"10": {"execution": "once", "start": "2026-11-21T06:00", "active": True}}},
    )
    assert lines_of(session)["10"] == ("2026-11-21T06:00:30.004", "2026-11-21T06:00:30.010")
    for ms, may in (("010", True), ("011", False)):
        assert (session.why(event("start", at=f"2026-11-21T06:00:30.{ms}", ob=10)) is None) is may


def test_a_case_of_the_review(real_engine: Engine) -> None:
    """The clock goes over a start point while delays are on and OB 80 is missing: nothing, then a STOP."""
    session = begun(
        real_engine,
        *ARMED,
        event("DIS_AIRT", ret=1),
        event("clock", to="2026-11-21T06:00:30"),
        obs=[1, 10, 85, 100],
    )
    possible = session.possible()
    due = [one for point in possible.times for one in point.due]
    assert [(one.event, one.value) for one in due] == [("stop", 0x4568)]


def test_answers_to_a_call(real_engine: Engine) -> None:
    """A call without RET_VAL comes back with each value that it may have."""
    session = begun(real_engine, event("DIS_AIRT", ret=1), event("DIS_AIRT", ret=2), cycle=True)
    (line,) = session.possible([{"event": "EN_AIRT"}]).lines
    assert line.event["ret"] == "W#16#0001"
    assert "AIRT-07" in line.requirements
    assert session.possible([{"event": "EN_AIRT", "ret": 7}]).lines == []


def test_modes_are_those_of_the_specification(real_engine: Engine) -> None:
    """Of each line of the kind mode."""
    session = Session(real_engine, HEADER)
    for name in ("restart", "run", "hold", "release", "stop"):
        fields: dict[str, Any] = {"type": "warm"} if name == "restart" else {}
        assert session.feed(event(name, **fields)) is None
        assert {one.mode for one in session.situations()} == {MODES[name]}


def test_lines_are_taken_back(real_engine: Engine) -> None:
    """After `undo` everything is as before the line."""
    session = begun(real_engine, *ARMED)
    before = session.possible()
    assert session.feed(event("DIS_AIRT", ret=1)) is None
    assert session.situations()[0].delay == 1
    session.undo()
    assert session.situations()[0].delay == 0
    assert session.possible() == before
    session.undo(5)
    assert session.lines == []
    assert session.clock == "2026-11-21T05:59:30.000"


def test_why_not(real_engine: Engine) -> None:
    """A line that is not possible has its condition and requirement, and changes nothing."""
    session = begun(real_engine, *ARMED)
    refusal = session.why({"event": "start", "ob": 10})
    assert refusal is not None
    assert refusal.requirements
    assert refusal.candidates
    assert session.feed({"event": "start", "ob": 10}) is not None
    assert len(session.lines) == 2
    assert session.why({"event": "start", "ob": 10, "at": "2026-11-21T06:00:00.004"}) is None


def test_another_header(real_engine: Engine) -> None:
    """The same lines under another reading, as far as it goes."""
    session = begun(real_engine, *ARMED, event("end", 32, ob=1))
    other, refusal = session.under({"cpu": "S7-300"})
    assert refusal is None
    assert other.lines == session.lines
    later = begun(
        real_engine, event("SET_TINT", ob=10, sdt="2026-12-31T06:00", period="W#16#1401", ret=0), profile="1997"
    )
    other, refusal = later.under({"profile": "2010"})
    assert refusal is not None
    assert "TINT-18" in refusal.requirements
    assert other.lines == []


@pytest.mark.parametrize("name", COMPLETE)
def test_what_comes_was_possible(name: str, real_engine: Engine) -> None:
    """Each line of a log that is accepted is among those that were possible, at its time."""
    prefix = read_prefix(real_engine, str(TRACES / name))
    session = Session(real_engine, prefix.header)
    for _, line in prefix.events:
        if line["event"] in ("start", "end", "clock", "restart", "run", "stop", "hold", "release"):
            asked = {field: value for field, value in line.items() if field not in ("at", "up", "info")}
            possible = session.possible([asked])
            assert len(possible.lines) >= 1, line
        assert session.feed(line) is None


@pytest.mark.parametrize("name", COMPLETE[::5])
def test_what_is_possible_is_accepted(name: str, real_engine: Engine) -> None:
    """Each line that is offered may follow, at its first and at its last time."""
    session, _, _ = opened(real_engine, read_prefix(real_engine, str(TRACES / name)))
    possible = session.possible()
    with_up = any("up" in line for line in session.lines)
    for line in possible.lines[::7]:
        for index in {line.first, line.first if line.last is None else line.last}:
            point = possible.times[index]
            whole = {"at": iso_of(point.at), **line.event}
            if with_up:
                whole["up"] = point.up.min * 60_000 + point.up.ms
            assert session.why(whole) is None, whole


def test_one_code_stands_for_many(real_engine: Engine) -> None:
    """Of the codes that no text states, one is offered; another one is as possible."""
    session = begun(real_engine, cpu="S7-1500", obs=[1, 10])
    call = {"event": "ACT_TINT", "ob": 10}
    answers = {one.event["ret"] for one in session.possible([call]).lines}
    assert "W#16#80FF" in answers
    assert len(answers) < MOST_ANSWERS
    for ret, possible in (("80FE", True), ("8100", False)):
        assert (session.why(call | {"ret": f"W#16#{ret}", "at": session.clock}) is None) is possible


@pytest.fixture
def log(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A log in the working directory."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "log").write_bytes(log_text(*ARMED, event("start", 31, ob=10), header=RUN))
    return tmp_path / "log"


def test_text(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The situation, what must come, what may, what differs, the requirements."""
    assert cli.main(["next", "log:3", "--cpu", "S7-300", "--profile", "1997"]) == 0
    text = capsys.readouterr().out
    assert text.startswith("log:3: after this line\n")
    assert "    start ob=10, by 2026-11-21T06:00:00.010 [" in text
    assert "    DIS_AIRT ret=W#16#0001, at once [AIRT-06, AIRT-03]" in text
    assert "| this log" in text
    assert "| profile 1997" in text
    assert "TINT-32 The points of an interrupt are SDT + k x PERIOD" in text
    assert cli.main(["next", "log"]) == 0
    assert "log:3: after this line; the next line of the log is not possible" in capsys.readouterr().out


def test_json(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The same for programs; its lines are lines of a log."""
    assert cli.main(["next", "--format", "json", "log:3"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["due"][0]["events"] == ["start ob=10"]
    (start,) = (one for one in answer["possible"] if one["event"]["event"] == "start" and one["event"]["ob"] == 10)
    assert start["from"] == "2026-11-21T06:00:00.000"
    log.write_bytes(log_text(*ARMED, {**start["event"], "at": start["from"]}, header=RUN))
    assert cli.main(["trace", "log"]) == 0


def test_why_on_the_command_line(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A report as that of a rejected log; exit code 0 if the event may come."""
    assert cli.main(["next", "log:3", "--why", '{"event": "start", "ob": 10}']) == 1
    text = capsys.readouterr().out
    assert text.startswith("log:4: rejected: ")
    assert "  why not: OB 10 cannot start here. " in text
    assert "would pass with" in text
    assert cli.main(["next", "log:3", "--why", '{"event": "DIS_AIRT", "ret": 1}']) == 0
    assert capsys.readouterr().out == "log:3: this may come next\n"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["log:9"], "log:9: unusable: expected a line 1 to 4; found 9"),
        (["none"], "none: unusable: expected a log that can be opened; found no such file or directory"),
        (["log", "--why", "[]"], "--why: expected a JSON object; found []"),
        (["log", "--why", '{"event": "go"}'], '--why: field "event": expected the name of an event; found "go"'),
    ],
)
def test_wrong_arguments(log: Path, arguments: list[str], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    """One sentence, exit code 2."""
    assert cli.main(["next", *arguments]) == 2
    assert said in capsys.readouterr().err


def test_unusable(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A line that cannot be read has its number."""
    log.write_bytes(log_text(*ARMED, "{", header=RUN))
    assert cli.main(["next", "log"]) == 2
    assert capsys.readouterr().err.startswith("log:4: unusable: ")
    assert cli.main(["next", "log:3"]) == 0


def test_a_line_is_of_the_format(real_engine: Engine) -> None:
    """What is no line of a log is refused, and the session goes on."""
    session = begun(real_engine)
    with pytest.raises(UnusableLogError):
        session.feed({"event": "go"})
    assert session.feed({"event": "DIS_AIRT", "at": at(31)}) is None


WAITING = [
    {"event": "SRT_DINT", "at": "2026-11-21T05:59:31", "ob": 20, "dtime": 100, "sign": 0, "ret": 0},
    {"event": "DIS_AIRT", "at": "2026-11-21T05:59:31", "ret": 1},
    {"event": "SRT_DINT", "at": "2026-11-21T05:59:31.200", "ob": 20, "dtime": 500, "sign": 0, "ret": 0},
]


@pytest.mark.parametrize(
    ("readings", "lines", "named"),
    [
        # SRT_DINT on an OB that waits: whether its run is withdrawn is open.
        ({}, WAITING, ["AMB-11"]),
        # An end of OB 1 may be hidden between the lines; no question is open.
        ({"AMB-11": "b"}, WAITING, []),
        ({}, WAITING[:2], []),
    ],
)
def test_questions_by_which_explanations_differ(
    readings: dict[str, str], lines: list[dict[str, Any]], named: list[str], real_engine: Engine
) -> None:
    """Each letter leaves other explanations, and together they leave all."""
    header = RUN | {"obs": [1, 20, 80, 85, 100], "readings": readings}
    session = Session(real_engine, header)
    for line in lines:
        assert session.feed(line) is None
    questions = open_questions(real_engine, session)
    assert [one.name for one in questions] == named
    for one in questions:
        numbers = {number for some in one.explanations.values() for number in some}
        assert numbers == set(range(1, len(session.situations()) + 1))
        assert one.explanations["b"] != one.explanations["a"]
        assert f"(b) it is withdrawn: explanations {', '.join(map(str, one.explanations['b']))}" in one.text
    session.close()
