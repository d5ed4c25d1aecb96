"""``s7check simulate``: the specification runs programs, and accepts the logs."""

import io
import json
import sys
from pathlib import Path
from typing import Any

import pytest

from s7check import cli
from s7check.api import check
from s7check.engine.client import Engine
from s7check.kit.adapter import Ran
from s7check.kit.collection import programs_of
from s7check.kit.followed import departure
from s7check.kit.from_log import program_of
from s7check.kit.program import Program, read_program
from s7check.kit.whole import whole
from s7check.log.errors import UnusableLogError
from s7check.resources import KIT
from s7check.simulating.simulation import outcomes, simulated

# Each question about eight OBs that are due in one moment takes seconds (docs/checking/commands.md, limits).
SOME = [one for one in programs_of([KIT])[::120] if "all-eight" not in one.name]

PROGRAM: dict[str, Any] = {
    "format": "s7-interrupt-program/1",
    "name": "AIRT-nested",
    "about": "Delays nest.",
    "requirements": ["AIRT-03"],
    "header": {"cpu": "S7-400", "obs": [1, 35, 80, 85, 100], "clock": "2026-11-21T05:59:30", "mode": "RUN"},
    "duration": 5000,
    "outside": [{"after": 1000, "event": "interrupt", "ob": 35}],
    "bodies": [{"ob": 1, "run": 1, "steps": [{"call": "DIS_AIRT"}, {"wait": 2000}, {"call": "EN_AIRT"}]}],
}


def program(**changes: Any) -> Program:
    """The program above with other fields."""
    return read_program(json.dumps(PROGRAM | changes).encode())


def told(log: list[dict[str, Any]]) -> list[str]:
    """The events of a log without the date."""
    return [f"{line['at'][17:]} {line['event']} {line.get('ob', line.get('ret', ''))}".strip() for line in log[1:]]


def test_the_end_of_ob_1_that_ends_a_delay_is_told(real_engine: Engine) -> None:
    """Without it the start of OB 35 would not follow from the lines; other boundaries of OB 1 are left out."""
    bodies = [{"ob": 1, "run": 1, "steps": [{"call": "DIS_AIRT"}, {"wait": 2000}]}]
    assert told(simulated(real_engine, program(bodies=bodies))) == [
        "30.000 DIS_AIRT W#16#0001",
        "31.000 interrupt 35",
        "32.000 end 1",
        "32.000 start 35",
        "32.000 end 35",
    ]


@pytest.mark.parametrize("seed", [None, 1])
@pytest.mark.parametrize("one", SOME, ids=lambda one: one.name)
def test_the_log_is_accepted(one: Program, seed: int | None, real_engine: Engine) -> None:
    """Of the programs of the kit, as early as possible and at random; the log is that of the program."""
    lines = [json.dumps(line).encode() for line in simulated(real_engine, one, seed=seed)]
    report = check(lines)
    assert report.verdict == "accepted", str(report)
    assert departure(real_engine, one, whole(real_engine, one, Ran(tuple(lines)))) == ""


@pytest.mark.parametrize(
    ("name", "seed"),
    [
        ("OBS-path-hold-0109", 3),
        ("AIRT-path-airt-0007", None),
        ("T15-63-waiting-error-ob-by-reading", 1),
        ("AIRT-path-airt-0006", 1),
    ],
)
def test_what_the_log_leaves_open_is_not_taken(name: str, seed: int | None, real_engine: Engine) -> None:
    """A start event that may come to nothing brings its OB within the latency or not at all.

    A startup OB, whose end no log has to show, goes on while its body does. An OB does not end where another has
    to be called before. What is due starts before a DIS_AIRT, behind which it would come too late.
    """
    (one,) = (each for each in programs_of([KIT]) if each.name == name)
    lines = [json.dumps(line).encode() for line in simulated(real_engine, one, seed=seed)]
    assert check(lines).verdict == "accepted"


def test_as_early_as_may_be(real_engine: Engine) -> None:
    """OB 35 waits for the end of the delay, no longer."""
    assert told(simulated(real_engine, program())) == [
        "30.000 DIS_AIRT W#16#0001",
        "31.000 interrupt 35",
        "32.000 EN_AIRT W#16#0000",
        "32.000 start 35",
        "32.000 end 35",
    ]


def test_a_burst_ends(real_engine: Engine) -> None:
    """Start events that are not told apart may start their OB any number of times; the run ends."""
    burst = [{"after": 1000 + ms, "event": "interrupt", "ob": 35} for ms in range(16)]
    lines = told(simulated(real_engine, program(outside=burst, bodies=[{"ob": 35, "run": 1, "steps": [{"wait": 20}]}])))
    assert 2 <= sum(line.endswith("start 35") for line in lines) <= len(burst)


def test_at_random(real_engine: Engine) -> None:
    """OBs come up to the latency late; a seed chooses alike."""
    begins = {told(simulated(real_engine, program(), seed=seed))[3] for seed in range(12)}
    assert len(begins) > 2
    assert simulated(real_engine, program(), seed=5) == simulated(real_engine, program(), seed=5)


def test_an_interrupted_wait_goes_on(real_engine: Engine) -> None:
    """The time of the OB that interrupts does not count."""
    bodies = [
        {"ob": 1, "run": 1, "steps": [{"wait": 2000}, {"call": "EN_AIRT"}]},
        {"ob": 35, "steps": [{"wait": 300}]},
    ]
    assert told(simulated(real_engine, program(bodies=bodies)))[-1] == "32.300 EN_AIRT W#16#8080"


def test_an_ob_is_loaded(real_engine: Engine) -> None:
    """An OB that the header does not have starts once an event from outside has loaded it."""
    outside = [{"after": 100, "event": "load", "ob": 40}, {"after": 200, "event": "interrupt", "ob": 40}]
    header = PROGRAM["header"] | {"obs": [1, 85]}
    log = told(simulated(real_engine, program(header=header, outside=outside, bodies=[])))
    assert "30.200 start 40" in log


def test_local_time(real_engine: Engine) -> None:
    """It is set by a step, though it is so already, and from outside, in STOP too; the clock goes on."""
    zone = {"event": "zone", "zone": 120, "reason": "daylight"}
    steps = [{"wait": 1000}, zone, zone, {"wait": 10}, {"call": "EN_AIRT"}]
    header = PROGRAM["header"] | {"cpu": "S7-1500", "obs": [1, 100], "zone": 60}
    outside = [{"after": 1500, "event": "stop"}, {"after": 2000, **zone, "zone": 60, "every": 2000}]
    log = simulated(real_engine, program(header=header, outside=outside, bodies=[{"ob": 1, "run": 1, "steps": steps}]))
    assert told(log) == [
        "31.000 zone",
        "31.000 zone",
        "31.010 EN_AIRT W#16#8080",
        "31.500 stop",
        "32.000 zone",
        "34.000 zone",
    ]
    assert [line["zone"] for line in log if line.get("event") == "zone"] == [120, 120, 60, 60]
    back = program_of(real_engine, [json.dumps(line).encode() for line in log], "zone", "Of the log.", ["T15-103"])
    made = [{"after": after, **zone} for after in (1000, 1000)] + [
        {"after": 1500, "event": "stop"},
        *({"after": after, **zone, "zone": 60} for after in (2000, 4000)),
    ]
    assert (back["header"]["zone"], back["outside"]) == (60, made)
    assert read_program(json.dumps(back)).plain["outside"] == made


def test_modes(real_engine: Engine) -> None:
    """A restart comes through STOP; the startup OB runs; HOLD stops a wait; a start event in STOP reaches nobody."""
    outside = [
        {"after": 100, "event": "restart", "type": "warm"},
        {"after": 200, "event": "hold"},
        {"after": 700, "event": "release"},
        {"after": 1500, "event": "stop"},
        {"after": 1600, "event": "interrupt", "ob": 35},
    ]
    bodies = [
        {"ob": 1, "run": 1, "steps": [{"wait": 1000}]},
        {"ob": 1, "run": 2, "steps": [{"wait": 200}, {"call": "EN_AIRT"}]},
        {"ob": 100, "steps": [{"wait": 50}]},
    ]
    assert told(simulated(real_engine, program(outside=outside, bodies=bodies))) == [
        "30.100 stop",
        "30.100 restart",
        "30.100 start 100",
        "30.150 end 100",
        "30.150 run",
        "30.200 hold",
        "30.700 release",
        "30.850 EN_AIRT W#16#8080",
        "31.500 stop",
    ]


def test_a_stop_by_rule(real_engine: Engine) -> None:
    """It has its cause."""
    step7 = {"execution": "minute", "start": "2026-11-21T05:00", "active": True}
    header = PROGRAM["header"] | {"obs": [1, 10], "step7": {"tod": {"10": step7}}}
    log = simulated(
        real_engine, program(header=header, bodies=[], outside=[{"after": 20, "event": "clock", "by": 90_000}])
    )
    assert told(log)[-1] == "00.020 stop"
    assert log[-1]["cause"] == "W#16#4568"


def test_all_outcomes(real_engine: Engine) -> None:
    """Two OBs of one moment come in either order; behind them everything is alike."""
    header = PROGRAM["header"] | {"obs": [1, 10, 11, 80, 85]}
    step7 = {"execution": "minute", "start": "2026-11-21T05:00", "active": True}
    header["step7"] = {"tod": {"10": step7, "11": step7}}
    tree = outcomes(real_engine, program(header=header, outside=[], bodies=[], duration=60_000))
    ways = {way["choice"] for way in tree["ways"]}
    assert {"start ob=10", "start ob=11"} <= ways
    assert tree["outcomes"] == 1
    assert {line.strip() for line in tree["text"]} >= {f"- {way['choice']}" for way in tree["ways"]}
    assert any(line.strip().startswith("goes on as at (") for line in tree["text"])


@pytest.mark.parametrize("change", [{"durations": 1}, {"header": PROGRAM["header"] | {"obs": "1"}}])
def test_the_engine_reads_what_it_runs(change: dict[str, Any], real_engine: Engine) -> None:
    """A program that nobody has checked ends with its field."""
    text = json.dumps(PROGRAM | change).encode()
    with pytest.raises(UnusableLogError, match=r"^field \"(durations|header\.obs)\": expected"):
        real_engine.simulated(text, PROGRAM["header"], 10)


def test_a_clock_before_1990(real_engine: Engine) -> None:
    """It ends with the field that moves it."""
    outside = [{"after": 10, "event": "clock", "by": -3_000_000_000_000}]
    with pytest.raises(UnusableLogError, match='field "by": expected a clock that stays in 1990 or later'):
        simulated(real_engine, program(outside=outside))


def test_on_the_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A log; all outcomes, as text and as JSON."""
    file = tmp_path / "program.json"
    file.write_text(json.dumps(PROGRAM), encoding="utf-8")
    assert cli.main(["simulate", str(file), "--cpu", "S7-300", "--latency", "5"]) == 0
    header, *lines = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert (header["cpu"], header["latency_ms"], len(lines)) == ("S7-300", 5, 5)
    assert cli.main(["simulate", str(file), "--all"]) == 0
    assert capsys.readouterr().out.endswith("\n1 outcome\n")
    assert cli.main(["simulate", str(file), "--all", "--format", "json"]) == 0
    assert json.loads(capsys.readouterr().out)["outcomes"] == 1
    assert cli.main(["simulate", str(file), "--all", "--seed", "1"]) == 2
    assert cli.main(["simulate", str(file), "--only", "other"]) == 2
    assert "expected a program other" in capsys.readouterr().err
    file.write_text("{", encoding="utf-8")
    assert cli.main(["simulate", str(file)]) == 2
    assert "expected a JSON object" in capsys.readouterr().err


def test_adapter(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """Programs a line, logs with `done` behind them; a program that cannot be run is skipped."""
    text = json.dumps(PROGRAM).encode() + b"\n"
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(text + b"\n{}\n" + text)))
    assert cli.main(["simulate", "-"]) == 0
    events = [json.loads(line).get("event") for line in capsys.readouterr().out.splitlines()]
    assert events.count("done") == 2
    assert events.count("skip") == 1
