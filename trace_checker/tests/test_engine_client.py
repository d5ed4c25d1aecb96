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
from s7check.report.report import Report
from tests.conftest import FAKE_ENGINE
from tests.fake_engine import EXPLAINED
from tests.logs import HEADER, event, log_text


@pytest.fixture
def engine(fake_command: list[str]) -> Iterator[Engine]:
    """An engine client with the fake engine."""
    with Engine(lambda: fake_command) as engine:
        yield engine


def feed(engine: Engine, *entries: dict[str, Any]) -> Answer:
    """Takes a log through the engine."""
    engine.begin()
    engine.send(log_text(*entries))
    return engine.finish()


def sent(command: list[str], transcript: Path, log: bytes, **options: Any) -> list[Any]:
    """The messages and the log that were sent, in pieces of 50 bytes; bytes of the log as one piece."""
    with Engine(lambda: [*command, str(transcript)]) as engine:
        engine.begin(**options)
        for at in range(0, len(log), 50):
            engine.send(log[at : at + 50])
        engine.finish()
    pieces: list[Any] = []
    rest = transcript.read_bytes()
    while rest:
        line, _, rest = rest.partition(b"\n")
        message = json.loads(line)
        count = message.pop("count", 0)
        pieces.append(message if message["message"] != "bytes" else rest[:count])
        rest = rest[count:]
    return pieces


def test_what_is_sent(fake_command: list[str], tmp_path: Path) -> None:
    """The log as it is, its header whole, behind what was chosen; its end."""
    log = b"\n" + log_text(event("run"))
    begin, *pieces, end = sent(fake_command, tmp_path / "transcript", log, chosen={"profile": "2006"}, follow=2)
    assert begin == {"message": "begin", "chosen": {"profile": "2006"}, "follow": 2}
    assert b"".join(pieces) == log
    assert pieces[0].count(b"\n") == 2
    assert end == {"message": "finish"}


@pytest.mark.parametrize("missing", [False, True])
def test_profile_file(fake_command: list[str], tmp_path: Path, missing: bool) -> None:
    """The file that a header names goes with the log, or the reason why it is missing."""
    if not missing:
        (tmp_path / "cpu.json").write_bytes(b'{"\xff"')
    log = log_text(header=HEADER | {"profile": "cpu.json"})
    begin, *_ = sent(fake_command, tmp_path / "transcript", log, folder=tmp_path)
    assert begin["file"] == ({"missing": "No such file or directory"} if missing else {"text": '{"\u00ff"'})


@pytest.mark.parametrize("profile", ["../cpu.json", "..\\cpu.json", "2006", 5])
def test_no_profile_file(fake_command: list[str], tmp_path: Path, profile: object) -> None:
    """Nothing is read outside the folder of the log."""
    begin, *_ = sent(fake_command, tmp_path / "transcript", log_text(header=HEADER | {"profile": profile}))
    assert begin == {"message": "begin"}


def test_answers(engine: Engine) -> None:
    """Any number of logs pass through one process, whatever comes of them."""
    assert feed(engine, event("run"), event("stop")) == Answer("accepted", events=2, message=EXPLAINED)
    rejected = feed(engine, event("run"), event("EN_AIRT", ret=1), event("stop"))
    assert (rejected.verdict, rejected.line, rejected.events) == ("rejected", 3, 1)
    allowed = Allowed("EN_AIRT", 0, "ret", 0, text="EN_AIRT ret=16#0000")
    assert (rejected.expected, rejected.requirements) == ([allowed], ["AIRT-07"])
    refusal = engine.refusal(b"{}")
    assert (refusal.states, refusal.candidates[0].place) == (2, "Airt:30")
    assert refusal.situations[0].running[-1] == Frame(40, 16)
    assert feed(engine, event("hold")).verdict == "error"
    assert feed(engine) == Answer("accepted", message=EXPLAINED)


def test_decided_before_the_end(engine: Engine) -> None:
    """`wait` says no as soon as the answer is there, though nothing else comes to be read."""
    silent, other = os.pipe()
    engine.begin()
    engine.send(log_text(event("EN_AIRT", ret=1)))
    assert not engine.wait(silent)
    engine.send(log_text(event("EN_AIRT", ret=1)))
    assert engine.finish().line == 2
    os.write(other, b"x")
    assert engine.wait(silent)
    os.close(silent)
    os.close(other)


def test_more_than_the_pipes_hold(engine: Engine) -> None:
    """A long log after an early decision blocks nobody."""
    engine.begin()
    for _ in range(3):
        engine.send(log_text(event("EN_AIRT", ret=1), *[event("run")] * 20_000))
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
        assert feed(engine, event("run")) == Answer("accepted", events=1, message=EXPLAINED)


def test_log_after_a_failure(engine: Engine) -> None:
    """A reader that waits before the log begins does not meet the process of the log before."""
    with pytest.raises(EngineError, match="SIGKILL"):
        feed(engine, event("stop", cause=0x0009))
    silent, other = os.pipe()
    os.write(other, b"x")
    assert engine.wait(silent)
    assert feed(engine, event("run")) == Answer("accepted", events=1, message=EXPLAINED)
    os.close(silent)
    os.close(other)


def test_killed_between_logs(engine: Engine) -> None:
    """The log after has a new process, and so has a question."""
    for ask in (False, True):
        assert feed(engine, event("run")) == Answer("accepted", events=1, message=EXPLAINED)
        assert engine._idle is not None
        os.kill(engine._idle._process.pid, signal.SIGKILL)
        engine._idle._process.wait()
        if ask:
            assert engine.alternatives().families
    assert feed(engine, event("run")) == Answer("accepted", events=1, message=EXPLAINED)


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
    log = log_text(event("stop", cause=0x51EE), *[event("run")] * events)
    begun = time.monotonic()
    engine.begin(until=begun + 1)
    with pytest.raises(EngineTooSlowError):  # noqa: PT012 - either may raise it
        engine.send(log)
        engine.finish()
    assert 1 <= time.monotonic() - begun < 30
    assert feed(engine, event("run")) == Answer("accepted", events=1, message=EXPLAINED)


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
    engine.begin()
    engine.send(log_text(event("stop", cause=0x0009)))
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
    header, right, wrong, _ = log_text(event("EN_AIRT", ret=0), event("EN_AIRT", ret=1)).split(b"\n")
    engine.begin()
    assert not engine.decided()
    engine.send(header + b"\n" + right + b"\n")
    assert not engine.decided()
    engine.send(wrong + b"\n")
    assert engine.decided()
    assert engine.decided()
    answer = engine.finish()
    assert (answer.verdict, answer.line) == ("rejected", 3)
