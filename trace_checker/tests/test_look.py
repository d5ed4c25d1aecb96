"""What the explorer's page is told about a log after a line."""

from typing import Any

import msgspec

from s7check.engine.answer import Situation
from s7check.engine.client import Engine
from s7check.log.calls import OPERANDS

HEADER: dict[str, Any] = {
    "format": "s7-interrupt-log/1",
    "cpu": "S7-400",
    "obs": [1, 10, 85],
    "clock": "2026-11-21T05:59:30",
    "mode": "RUN",
    "cycle": True,
    "step7": {"tod": {"10": {"execution": "minute", "start": "2026-11-21T06:00", "active": True}}},
}
AT = "2026-11-21T05:59:30.000"
DELAYED = {"event": "DIS_AIRT", "at": AT, "ret": "W#16#0001"}
OVER_A_POINT = {"event": "clock", "at": AT, "to": "2026-11-21T06:00:30.000"}


class _Answer(msgspec.Struct):
    look: dict[str, Any] = {}
    lines: Any = None
    situations: list[Situation] = []
    refusal: dict[str, Any] | None = None
    impossible: list[dict[str, Any]] | None = None


def ask(engine: Engine, message: str, header: dict[str, Any], log: list[dict[str, Any]], **more: Any) -> _Answer:
    """The answer to a question after these lines."""
    texts = [msgspec.json.encode(line).decode() for line in log]
    engine.ask({"message": "open", "session": "look", "header": msgspec.json.encode(header).decode()}, _Answer)
    assert engine.ask({"message": "add", "session": "look", "lines": texts}, _Answer).refusal is None
    return engine.ask({"message": message, "session": "look", "after": len(log), **more}, _Answer)


def texts(lines: list[dict[str, Any]]) -> list[str]:
    """Lines in short."""
    return [line["text"] for line in lines]


def test_after_the_clock_passed_a_point_under_a_delay(real_engine: Engine) -> None:
    """The STOP without OB 80 may come, OB 10 may not, with its reason."""
    look = ask(real_engine, "look", HEADER, [DELAYED, OVER_A_POINT]).look
    assert "stop cause=W#16#4568" in texts(look["possible"])
    assert not any(text.startswith("start ob=10") for text in texts(look["possible"]))
    impossible = ask(real_engine, "impossible", HEADER, [DELAYED, OVER_A_POINT], at=look["at"]).impossible
    (reason,) = (one for one in impossible or [] if one["text"] == "start ob=10")
    assert reason["formulas"]


def test_a_step_looks_at_one_line_of_a_call_with_operands(real_engine: Engine) -> None:
    """Each call is there once, with its answers: a step is meant to be short."""
    look = ask(real_engine, "look", HEADER, []).look
    calls = {text.partition(" ret=")[0] for text in texts(look["possible"]) if text.partition(" ")[0].isupper()}
    assert sorted(call.partition(" ")[0] for call in calls) == sorted(OPERANDS.keys() - {"SET_TINTL"})
    assert len(look["times"]) > 1


def test_what_a_hot_restart_brings_back(real_engine: Engine) -> None:
    """After a STOP; an S7-300 keeps nothing."""
    log: list[dict[str, Any]] = [
        {"event": "SRT_DINT", "ob": 20, "dtime": 5000, "sign": 0, "at": AT, "ret": 0},
        DELAYED,
        {"event": "interrupt", "ob": 40, "at": AT},
        {"event": "stop", "at": AT},
    ]
    said = "brings back OB 1 (class 1); 1 DIS_AIRT not taken back; OB 40 pending; OB 20 started"
    header = HEADER | {"obs": [1, 20, 40]}
    del header["step7"]
    (situation,) = ask(real_engine, "look", header, log).look["situations"]
    assert ["hot restart", said] in situation
    state = real_engine.ask({"message": "situations", "session": "look", "most": 1}, _Answer).situations[0]
    assert [list(one) for one in state.said] == situation
    (situation,) = ask(real_engine, "look", header | {"cpu": "S7-300"}, log).look["situations"]
    assert "hot restart" not in dict(situation)


def test_when_time_has_passed(real_engine: Engine) -> None:
    """OB 10 is due at its point; after the latency nothing may come any more."""
    due = ask(real_engine, "look", HEADER, [], at="2026-11-21T06:00:00.000").look
    assert "start ob=10" in texts(due["possible"])
    assert ask(real_engine, "look", HEADER, [], at="2026-11-21T06:00:00.011").look["possible"] == []


def test_the_operands_of_a_call_and_its_answers(real_engine: Engine) -> None:
    """Some lines of a call, and the answers to one of them."""
    lines = ask(real_engine, "lines", HEADER, [], at=AT, only=["SET_TINT"]).lines
    assert {line["event"]["event"] for line in lines} == {"SET_TINT"}
    assert len({line["event"]["period"] for line in lines}) > 5
    call = msgspec.json.encode({"event": "EN_AIRT", "at": AT, "ret": None}).decode()
    answers = ask(real_engine, "lines", HEADER, [], at=AT, lines=[call]).lines
    assert [line["event"]["ret"] for line in answers] == ["W#16#8080"]


def test_a_log_that_leaves_much_open_is_answered_in_part(real_engine: Engine) -> None:
    """It says so."""
    loose = HEADER | {"records": ["ob", "clock", "mode", "interrupt", "load"]}
    started = {"event": "start", "at": "2026-11-21T06:00:00.000", "ob": 10}
    look = ask(real_engine, "look", loose, [started]).look
    assert not look["whole"]
    assert "end ob=10" in texts(look["possible"])
