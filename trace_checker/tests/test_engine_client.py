"""The protocol, with the fake engine."""

import json
import os
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from s7check.engine.answer import Allowed, Answer, Frame
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.engine.process import EngineTooSlowError
from s7check.judging.check import check_log
from s7check.judging.replay import Replay, with_readings
from s7check.log.reader import Batch, read_log
from s7check.report.report import Report
from tests.conftest import FAKE_ENGINE
from tests.logs import BEGIN, HEADER, event, log_text


@pytest.fixture
def engine(fake_command: list[str]) -> Iterator[Engine]:
    """An engine client with the fake engine."""
    with Engine(lambda: fake_command) as engine:
        yield engine


def feed(engine: Engine, *entries: dict[str, Any]) -> Answer:
    """Takes a log through the engine."""
    (batch,) = read_log([log_text(*entries)])
    begin(engine, batch)
    engine.send(batch.events)
    return engine.finish()


def begin(engine: Engine, batch: Batch) -> None:
    """Begins a log with the header of its batch."""
    assert batch.header is not None
    engine.begin(batch.header)


def test_what_is_sent(fake_command: list[str], tmp_path: Path) -> None:
    """The header, each event on a line of its own, the end."""
    transcript = tmp_path / "transcript"
    with Engine(lambda: [*fake_command, str(transcript)]) as engine:
        feed(engine, event("SET_TINT", ob=10, sdt="2026-02-30T06:00", period="16#0201", ret=None, x_own=1))
    header, call, end = transcript.read_text().splitlines()
    assert header.startswith('{"message":"begin",')
    assert list(json.loads(header)) == ["message", "header"]
    assert json.loads(header)["header"]["latency"] == 10
    assert json.loads(call) == {
        "line": 2,
        "event": "SET_TINT",
        "ob": 10,
        "period": 0x0201,
        "ret": -1,
        "at": {"min": BEGIN, "ms": 31_000},
        "up": {"min": 0, "ms": 1000},
        "sdt": {"year": 2026, "month": 2, "day": 30, "hour": 6, "minute": 0, "second": 0, "ms": 0},
    }
    assert json.loads(end) == {"message": "finish"}


def test_answers(engine: Engine) -> None:
    """Any number of logs pass through one process, whatever comes of them."""
    assert feed(engine, event("run"), event("stop")) == Answer("accepted", events=2)
    rejected = feed(engine, event("run"), event("EN_AIRT", ret=1), event("stop"))
    assert (rejected.verdict, rejected.line, rejected.events) == ("rejected", 3, 1)
    assert (rejected.expected, rejected.requirements) == ([Allowed("EN_AIRT", 0, "ret", 0)], ["AIRT-07"])
    assert (rejected.states, rejected.candidates[0].place) == (2, "Airt:30")
    assert rejected.situations[0].running[-1] == Frame(40, 16)
    assert feed(engine, event("hold")).verdict == "error"
    assert feed(engine) == Answer("accepted")


def test_decided_before_the_end(engine: Engine) -> None:
    """`wait` says no as soon as the answer is there, though nothing else comes to be read."""
    silent, other = os.pipe()
    (batch,) = read_log([log_text(event("EN_AIRT", ret=1))])
    begin(engine, batch)
    engine.send(batch.events)
    assert not engine.wait(silent)
    engine.send(batch.events)
    assert engine.finish().line == 2
    os.write(other, b"x")
    assert engine.wait(silent)
    os.close(silent)
    os.close(other)


def test_more_than_the_pipes_hold(engine: Engine) -> None:
    """A long log after an early decision blocks nobody."""
    (batch,) = read_log([log_text(event("EN_AIRT", ret=1), *[event("run")] * 20_000)])
    begin(engine, batch)
    for _ in range(3):
        engine.send(batch.events)
    assert engine.finish().line == 2
    assert feed(engine, *[event("run")] * 20_000).events == 20_000


@pytest.mark.parametrize(
    ("cause", "message"),
    [
        (0xDEAD, r"the engine ended \(exit code 1, Exception in thread main\): .*`make engine`"),
        (0x0003, "ran out of memory: .*-Xmx"),
        (0xBABE, r"the engine answered no JSON \\x1b\[31m, which does not fit: run `make engine`"),
        (0x0009, r"the engine ended \(killed by SIGKILL\)"),
    ],
)
def test_failures(engine: Engine, cause: int, message: str) -> None:
    """A failing engine gives an error that helps, and the next log a new process."""
    for _ in range(2):
        with pytest.raises(EngineError, match=message):
            feed(engine, event("stop", cause=cause))
        assert feed(engine, event("run")) == Answer("accepted", events=1)


def test_log_after_a_failure(engine: Engine) -> None:
    """A reader that waits before the log begins does not meet the process of the log before."""
    with pytest.raises(EngineError, match="SIGKILL"):
        feed(engine, event("stop", cause=0x0009))
    silent, other = os.pipe()
    os.write(other, b"x")
    assert engine.wait(silent)
    assert feed(engine, event("run")) == Answer("accepted", events=1)
    os.close(silent)
    os.close(other)


def test_killed_between_logs(engine: Engine) -> None:
    """The log after has a new process, and so has a question."""
    for ask in (False, True):
        assert feed(engine, event("run")) == Answer("accepted", events=1)
        assert engine._idle is not None
        os.kill(engine._idle._process.pid, signal.SIGKILL)
        engine._idle._process.wait()
        if ask:
            assert engine.alternatives().families
    assert feed(engine, event("run")) == Answer("accepted", events=1)


@pytest.mark.parametrize("event_before", [event("run"), event("stop", cause=0x0009), event("stop", cause=0x0003)])
def test_folder(event_before: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A process has a folder for temporary files, and leaves none however it ends."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    write = f"import pathlib; pathlib.Path('left').touch(); exec(open({str(FAKE_ENGINE)!r}).read())"
    with Engine(lambda: [sys.executable, "-c", write]) as engine, suppress(EngineError):
        engine.alternatives()
        assert len(list(tmp_path.glob("*/left"))) == 1
        feed(engine, event_before)
    assert list(tmp_path.iterdir()) == []


def test_readings_after_a_failure(engine: Engine, tmp_path: Path) -> None:
    """Where the engine fails under a reading, that one has no verdict, and the next a new process."""
    log = tmp_path / "log"
    log.write_bytes(log_text(event("stop", cause=0x0009), header=HEADER | {"readings": {"AMB-12": "b"}}))
    report = check_log(str(log), engine, lambda _, __: None)
    for _ in range(2):
        readings = with_readings(report, engine, Replay(str(log), [])).readings
        assert readings is not None
        assert [(one.change, one.verdict) for one in readings if one.kind == "letter"] == [
            ("AMB-01 a", "accepted"),
            ("AMB-12 a", "no verdict"),
        ]


@pytest.mark.parametrize("events", [1, 20_000])
def test_too_slow(engine: Engine, events: int) -> None:
    """An engine that is not done in time is ended, whether it is to answer or does not even take its input."""
    (batch,) = read_log([log_text(event("stop", cause=0x51EE), *[event("run")] * events)])
    assert batch.header is not None
    begun = time.monotonic()
    engine.begin(batch.header, until=begun + 1)
    with pytest.raises(EngineTooSlowError):  # noqa: PT012 - either may raise it
        engine.send(batch.events)
        engine.finish()
    assert 1 <= time.monotonic() - begun < 30
    assert feed(engine, event("run")) == Answer("accepted", events=1)


def test_readings_in_time(engine: Engine, tmp_path: Path) -> None:
    """The readings for which there is no time are named; those that bear on the rule that decided come first."""
    log = tmp_path / "log"
    header = HEADER | {"readings": {"AMB-12": "b"}}
    log.write_bytes(log_text(event("EN_AIRT", ret=1), event("stop", cause=0x51EE), header=header))
    report = Report(str(log), "rejected", "", requirements=["AMB-12"])
    tried = with_readings(report, engine, Replay(str(log), []), time.monotonic() + 3)
    assert tried.readings is not None
    assert "AMB-12 a" in [one.change for one in tried.readings]
    assert with_readings(report, engine, Replay(str(log), []), time.monotonic()).readings == []
    everything = with_readings(report, engine, Replay(str(log), []), time.monotonic()).untried
    assert set(everything) == {one.change for one in tried.readings} | set(tried.untried)
    assert everything[-2:] == ["AMB-01 a", "AMB-12 a"]


def test_failure_while_waiting(engine: Engine) -> None:
    """An engine that ends while the log is silent is noticed."""
    silent, other = os.pipe()
    (batch,) = read_log([log_text(event("stop", cause=0x0009))])
    begin(engine, batch)
    engine.send(batch.events)
    with pytest.raises(EngineError, match="SIGKILL"):
        engine.wait(silent)
    os.close(silent)
    os.close(other)


@pytest.mark.parametrize(
    ("command", "message"),
    [
        (["/nowhere/java"], "could not be started"),
        (["true"], r"the engine ended \(exit code 0\)"),
        (["echo", "hello"], "the engine answered hello"),
        (["sh", "-c", "exec >&- 2>&-; sleep 60"], "broke off"),
    ],
)
def test_no_engine(command: list[str], message: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """What does not get ready is an error."""
    monkeypatch.setattr("s7check.engine.process._PATIENCE", 0.1)
    with Engine(lambda: command) as engine, pytest.raises(EngineError, match=message):
        feed(engine)


def test_end_by_force(monkeypatch: pytest.MonkeyPatch) -> None:
    """A process that does not end is killed."""
    monkeypatch.setattr("s7check.engine.process._PATIENCE", 0.1)
    begun = time.monotonic()
    ready = """echo '{"engine": "ready"}'; echo '{"verdict": "accepted"}'; cat > /dev/null; sleep 60"""
    with Engine(lambda: ["sh", "-c", ready]) as engine:
        feed(engine)
    assert time.monotonic() - begun < 30


def test_finish_without_begin(engine: Engine) -> None:
    """There is no answer to no log."""
    with pytest.raises(EngineError, match="no log was begun"):
        engine.finish()


def test_decided(engine: Engine) -> None:
    """A log is open until a line decides; asking again costs nothing and changes nothing."""
    (batch,) = read_log([log_text(event("EN_AIRT", ret=0), event("EN_AIRT", ret=1))])
    begin(engine, batch)
    assert not engine.decided()
    engine.send(batch.events[:1])
    assert not engine.decided()
    engine.send(batch.events[1:])
    assert engine.decided()
    assert engine.decided()
    answer = engine.finish()
    assert (answer.verdict, answer.line) == ("rejected", 3)
