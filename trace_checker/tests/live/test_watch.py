"""s7check watch on two servers that speak the S7 protocol: a fault is found, nothing is lost, nothing invented."""

import json
from collections.abc import Callable, Iterator
from datetime import timedelta
from pathlib import Path
from random import Random
from typing import Any

import pytest

import s7check
from s7check import cli
from s7check.importing.sources.live import Address
from s7check.live.connection import Connection
from s7check.live.view import picture
from s7check.live.watch import Watch
from tests.live.plc import HOLD, RUN, Foreign, Own, Plc, foreign, own

GIVEN = {"cpu": "S7-300", "obs": [1, 10, 20, 40, 80, 85, 100], "records": ["call", "ob", "load"]}

Begin = Callable[[Plc], Watch]


@pytest.fixture(params=[own, foreign], ids=["own", "foreign"])
def begin(request: pytest.FixtureRequest, tmp_path: Path) -> Iterator[Begin]:
    """A function that begins a watch of a CPU; this machine's time is that of the CPU."""
    open_: list[Any] = []

    def one(plc: Plc) -> Watch:
        server = request.param(plc)
        connection = Connection(Address("127.0.0.1", 0, 2, server.__enter__()), 101)
        watch = Watch(connection, GIVEN, tmp_path / "run.ndjson", lambda: plc.passed / 1000)
        open_.append((server, connection, watch))
        return watch

    yield one
    for server, connection, watch in open_:
        watch.end()
        connection.close()
        server.__exit__(None, None, None)


def steps(watch: Watch, plc: Plc, count: int = 3, ms: int = 100) -> None:
    """Polls, with time between them."""
    for _ in range(count):
        watch.step()
        plc.pass_time(ms)


def running(begin: Begin, **options: int) -> tuple[Plc, Watch]:
    """A CPU that has started, with these options, and its watch."""
    plc = Plc(**options)
    watch = begin(plc)
    plc.restart()
    steps(watch, plc)
    return plc, watch


def ends_accepted(watch: Watch) -> None:
    """Ends the watch; it has made one log, which is accepted."""
    watch.end()
    assert [report.verdict for report in watch.reports] == ["accepted"]


def lines(file: Path) -> list[dict[str, Any]]:
    """The lines of a log."""
    return [json.loads(line) for line in file.read_text().splitlines()]


def told(watch: Watch) -> list[tuple[str, str]]:
    """The events of all logs, as ``Plc.told`` has them."""
    return [(line["event"], line["at"]) for line in watch.lines.since(0) if line["event"] != "state"]


def test_a_good_run(begin: Begin, tmp_path: Path) -> None:
    """From STOP on: every event in its order, one accepted log, which records modes and the clock."""
    plc = Plc()
    watch = begin(plc)
    plc.pass_time(50)
    plc.restart()
    steps(watch, plc)
    plc.enter(32, ob=20, info_2=500)
    steps(watch, plc, 2)
    assert watch.log is not None
    ((by, what),) = watch.log.due()
    assert "start ob=20" in what
    shown = "\n".join(text.plain for text in picture(watch))
    assert "8 events, none wrong" in shown
    assert "SRT_DINT ob=20 dtime=500" in shown
    assert f"must come by {by}: {what}" in shown
    plc.pass_time(300)
    plc.start(20, 0x21, 3, info_2=500)
    plc.pass_time(2)
    plc.end(20)
    steps(watch, plc)
    plc.stop()
    steps(watch, plc)
    assert told(watch) == plc.told
    assert watch.log is not None
    watch.end()
    (report,) = watch.reports
    assert (report.verdict, str(report.log)) == ("accepted", str(tmp_path / "run.ndjson"))
    header, *_, end = lines(tmp_path / "run.ndjson")
    assert end["event"] == "done"
    assert (header["mode"], header["records"]) == ("STOP", ["call", "ob", "load", "mode", "clock"])
    assert s7check.check(str(tmp_path / "run.ndjson")).verdict == "accepted"


def test_a_seeded_fault(begin: Begin, tmp_path: Path) -> None:
    """A CAN_DINT that answers 0 where no delay runs: call and ob alone would not show it."""
    plc, watch = running(begin)
    plc.enter(33, ob=20, ret=0)
    watch.step()
    (report,) = watch.reports
    assert report.verdict == "rejected"
    assert report.expected[0].startswith("CAN_DINT ob=20 ret=")
    assert any(name.startswith("DINT-") for name in report.requirements)
    found = s7check.check(str(tmp_path / "run.ndjson"))
    assert (found.verdict, found.line) == ("rejected", report.line)


def test_silence(begin: Begin, tmp_path: Path) -> None:
    """An OB that does not come is noticed although nothing comes."""
    plc = Plc()
    watch = begin(plc)
    plc.restart()
    plc.enter(32, ob=20, info_2=500)
    steps(watch, plc, 4)
    assert watch.reports == []
    steps(watch, plc, 6)
    (report,) = watch.reports
    assert report.verdict == "rejected"
    assert report.late
    assert report.late[0].startswith("start ob=20")
    assert lines(tmp_path / "run.ndjson")[-1]["event"] == "done"
    assert s7check.check(str(tmp_path / "run.ndjson")).verdict == "rejected"


def test_torn_and_unfinished(begin: Begin) -> None:
    """An entry that is not published is not read; SFC 42 that has not come back is waited for, for a while."""
    plc = Plc()
    watch = begin(plc)
    plc.restart()
    plc.enter(41, ret=1)
    steps(watch, plc)
    before = told(watch)
    plc.begin_entry(plc.fields(33, ob=99))
    steps(watch, plc)
    assert told(watch) == before
    number = plc.enter(42, done=0)
    steps(watch, plc)
    assert told(watch) == before
    plc.complete(number, ret=0)
    steps(watch, plc)
    assert watch.lines.last(1)[0]["ret"] == "W#16#0000"
    plc.enter(42, done=0)
    steps(watch, plc, 15)
    assert watch.lines.last(1)[0]["ret"] is None
    assert told(watch) == plc.told


def test_overwritten(begin: Begin) -> None:
    """More entries than slots between two polls: the log ends, the next one does not claim to know every call."""
    plc, watch = running(begin, capacity=8)
    for _ in range(20):
        plc.pass_time(1)
        plc.enter(33, ob=20, ret=0x80A0 - 0x10000)
    steps(watch, plc)
    assert [report.verdict for report in watch.reports] == ["accepted"]
    assert any("overwritten" in note for note in watch.notes.last(9))
    assert watch.log is not None
    assert (watch.log.header["mode"], watch.log.header["records"]) == ("RUN", ["ob", "load", "mode", "clock"])
    assert [event for event in told(watch) if event not in plc.told] == []
    plc.enter(33, ob=20, ret=0)
    steps(watch, plc)
    assert watch.log is not None, "a delay may have been started in between"
    plc.stop()
    plc.pass_time(1000)
    plc.restart()
    steps(watch, plc, 6)
    assert watch.log is not None
    assert watch.log.header["mode"] == "STOP"
    plc.enter(33, ob=20, ret=0)
    steps(watch, plc)
    assert [report.verdict for report in watch.reports] == ["accepted", "accepted", "rejected"]


def test_overwritten_while_it_is_read(begin: Begin) -> None:
    """The program goes round the ring between the counter and the slots: what is read is right or is a gap."""
    plc, watch = running(begin, capacity=8)
    calls = 0

    def rush() -> None:
        nonlocal calls
        calls += 1
        if calls % 4 == 3:
            for _ in range(5):
                plc.pass_time(1)
                plc.enter(33, ob=20, ret=0x80A0 - 0x10000)

    plc.before = rush
    steps(watch, plc, 20)
    plc.before = lambda: None
    steps(watch, plc)
    assert any("overwritten" in note for note in watch.notes.since(0))
    assert [event for event in told(watch) if event not in plc.told] == []
    watch.end()
    assert {report.verdict for report in watch.reports} == {"accepted"}


def test_stall(begin: Begin) -> None:
    """Nobody polls for 7 s: nothing is lost as long as ring and buffer have room."""
    plc, watch = running(begin)
    plc.pass_time(1000)
    plc.enter(32, ob=20, info_2=500)
    plc.pass_time(500)
    plc.start(20, 0x21, 3, info_2=500)
    plc.pass_time(1)
    plc.end(20)
    plc.pass_time(1500)
    plc.stop()
    plc.pass_time(1000)
    plc.restart()
    plc.pass_time(3000)
    steps(watch, plc)
    assert told(watch) == plc.told
    ends_accepted(watch)


def test_stop_in_mid_program(begin: Begin) -> None:
    """A STOP inside an entry and inside SFC 42: the entry is not there, the call has no answer, the log goes on."""
    plc = Plc()
    watch = begin(plc)
    plc.restart()
    plc.pass_time(5)
    plc.enter(41, ret=1)
    plc.pass_time(5)
    plc.enter(42, done=0)
    plc.begin_entry(plc.fields(32, ob=20, info_2=500))
    plc.pass_time(1)
    plc.stop()
    steps(watch, plc, 15)
    plc.pass_time(4000)
    plc.restart()
    steps(watch, plc)
    assert told(watch) == plc.told
    ends_accepted(watch)


def test_the_clock_is_set_by_the_program(begin: Begin) -> None:
    """Forward and backward, with entries of the buffer around: one log."""
    plc, watch = running(begin)
    plc.set_clock(plc.now + timedelta(hours=1))
    plc.pass_time(1)
    plc.enter(41, ret=1)
    steps(watch, plc)
    plc.set_clock(plc.now - timedelta(hours=2))
    steps(watch, plc, 1)
    plc.stop()
    steps(watch, plc)
    assert told(watch) == plc.told
    ends_accepted(watch)


@pytest.mark.parametrize("hours", [1, -1])
def test_the_clock_is_set_by_somebody(begin: Begin, hours: int) -> None:
    """A programming device sets the clock: the log ends, whether or not entries come."""
    plc = Plc()
    watch = begin(plc)
    plc.restart()
    plc.enter(28, ob=10, stamp=bytes.fromhex("2611210630000000"), info_1=0x0201)
    plc.enter(30, ob=10)
    steps(watch, plc)
    plc.now += timedelta(hours=hours)
    plc.pass_time(2000)
    plc.stop()
    steps(watch, plc, 5)
    watch.end()
    assert [report.verdict for report in watch.reports] == ["accepted"] * len(watch.reports)
    assert any("the clock was set" in note for note in watch.notes.since(0))
    assert [event for event in told(watch) if event not in plc.told] == []


def test_set_back_with_entries_of_no_certain_order(begin: Begin) -> None:
    """An entry of the buffer that may stand on either side of a clock set back: a gap, no guess."""
    plc, watch = running(begin)
    plc.pass_time(3000)
    plc.set_clock(plc.now - timedelta(seconds=2))
    plc.pass_time(1000)
    plc.stop()
    steps(watch, plc)
    assert any("order" in note for note in watch.notes.since(0))
    assert watch.tail.mode == "STOP"
    assert [report.verdict for report in watch.reports] == ["accepted"]


def test_states(begin: Begin) -> None:
    """What SZL 16#0222 shows is in the log, once a second; a wrong state is found."""
    plc = Plc()
    plc.states = dict.fromkeys((10, 20), 0x10)
    watch = begin(plc)
    plc.restart()
    steps(watch, plc, 30)
    states = [line for line in watch.lines.since(0) if line["event"] == "state"]
    assert len(states) >= 2
    assert states[0].items() >= {"active": False, "blocked": False, "loaded": True}.items()
    assert watch.reports == []
    plc.states[20] |= 4
    steps(watch, plc, 30)
    (report,) = watch.reports
    assert report.verdict == "rejected"
    assert report.event is not None
    assert json.loads(report.event)["event"] == "state"


def test_hold(begin: Begin) -> None:
    """HOLD and its release."""
    plc, watch = running(begin)
    plc.change(0x4305, HOLD, "hold")
    steps(watch, plc)
    plc.change(0x4306, RUN, "release")
    steps(watch, plc)
    assert told(watch) == plc.told
    ends_accepted(watch)


def test_lost_entries_of_the_buffer(begin: Begin) -> None:
    """More new entries than the buffer holds: the log ends, and the mode is asked for."""
    plc, watch = running(begin)
    for _ in range(150):
        plc.pass_time(1)
        plc.note("1381 FF00 0000 0000 0000 0000")
    plc.stop()
    plc.buffer[0:0] = [plc.buffer[0]] * 150
    steps(watch, plc)
    assert any("diagnostic buffer" in note for note in watch.notes.since(0))
    assert watch.tail.mode == "STOP"


def test_many_new_entries(begin: Begin) -> None:
    """More than are read at a time, some of them alike: all are there, once; the buffer was empty at first."""
    plc = Plc()
    watch = begin(plc)
    for _ in range(6):
        plc.note("1381 FF00 0000 0000 0000 0000")
    steps(watch, plc)
    assert told(watch) == plc.told
    plc.restart()
    steps(watch, plc)
    for _ in range(20):
        plc.note("1381 FF00 0000 0000 0000 0000")
    steps(watch, plc)
    assert told(watch) == plc.told


def test_a_cut_connection(tmp_path: Path) -> None:
    """Wherever the connection breaks: the watch connects again, nothing is lost, nothing comes twice."""
    plc = Plc(capacity=60)
    server = Own(plc)
    watch = Watch(Connection(Address("127.0.0.1", 0, 2, server.port), 101), GIVEN, None, lambda: plc.passed / 1000)
    plc.restart()
    broken = 0
    for answers in range(25):
        plc.pass_time(10)
        plc.enter(33, ob=20, ret=0x80A0 - 0x10000)
        server.answers = answers % 9
        watch.step()
        broken += bool(watch.trouble)
        plc.pass_time(10)
    server.answers = None
    steps(watch, plc)
    assert broken > 10
    assert told(watch) == plc.told
    ends_accepted(watch)
    watch._cpu.close()
    server.stop()
    assert server.asked == {"setup", "read", "clock", 0x01A0, 0x0424}, "nothing else is asked, nothing written"


def test_a_server_that_goes() -> None:
    """The same with python-snap7's server, which ends and starts again."""
    plc = Plc()
    with own(plc) as free:
        port = free
    connection = Connection(Address("127.0.0.1", 0, 2, port), 101)
    watch = None
    for change in (plc.restart, plc.stop, plc.restart, lambda: None):
        server = Foreign(plc)
        server.start(port)
        watch = watch or Watch(connection, GIVEN, None, lambda: plc.passed / 1000)
        steps(watch, plc)
        assert told(watch) == plc.told
        server.stop()
        change()
        watch.step()
        assert watch.trouble
    assert watch is not None
    ends_accepted(watch)
    connection.close()


@pytest.mark.parametrize("seed", range(6))
def test_at_random(begin: Begin, seed: int) -> None:
    """The program goes on at any moment between two requests; each event is there once, in its place."""
    plc = Plc(capacity=40)
    random = Random(seed)  # noqa: S311 - no secret
    watch = begin(plc)

    def act() -> None:
        plc.pass_time(random.randint(1, 30))
        if random.random() < 0.5:
            return
        if plc.mode != RUN:
            plc.restart()
            return
        match random.randint(0, 9):
            case 0:
                plc.stop()
            case 1:
                plc.set_clock(plc.now + timedelta(minutes=random.randint(0, 9)))
            case 2:
                plc.note("1381 FF00 0000 0000 0000 0000")
            case _:
                plc.enter(33, ob=20, ret=0x80A0 - 0x10000)

    plc.before = act
    for _ in range(60):
        watch.step()
    plc.before = lambda: None
    steps(watch, plc)
    assert told(watch) == plc.told
    assert len(plc.told) > 100
    ends_accepted(watch)


def test_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The command line: events as they come, then the report; what is wrong with it is one message."""
    plc = Plc()
    plc.restart()
    log = tmp_path / "x.ndjson"

    def act() -> None:
        plc.pass_time(20)
        if plc.mode == RUN and plc.passed > 300:
            plc.stop()
            plc.pass_time(1)
            plc.restart()
            plc.enter(33, ob=20, ret=0)
            plc.before = lambda: plc.pass_time(1)

    with own(plc) as port:
        watch = ["watch", "snap7://127.0.0.1:0:2", "--port", str(port), "--poll", "10", "--seconds", "20"]
        assert cli.main([*watch, "--cpu", "S7-300"]) == 2
        assert "--obs: expected it" in capsys.readouterr().err
        given = ["--cpu", "S7-300", "--obs", "1,20,80,85,100", "--records", "call,ob,load", "-o", str(log)]
        assert cli.main([*watch, *given, "--db", "7"]) == 2
        assert "expected an answer of the CPU" in capsys.readouterr().err
        plc.before = act
        code = cli.main([*watch, *given])
    out = capsys.readouterr().out
    assert code == 1, out
    assert "restart type=warm" in out
    assert f"{log}:" in out
    assert ": rejected: " in out
    assert cli.main(["watch", "snap7://plc", "--cpu", "S7-300", "--obs", "1"]) == 2
