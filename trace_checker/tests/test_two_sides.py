"""``s7check compare``, ``distinguish``, ``explain`` and ``decide``, with the real engine."""

import json
from pathlib import Path
from typing import Any

import pytest

from s7check import cli
from s7check.asking.variants import Variant
from s7check.engine.client import Engine
from s7check.kit.program import read_program
from s7check.simulating.search import smallest, told_apart
from s7check.simulating.shortest import anywhere
from tests.shipped import log_of
from tests.test_simulating import PROGRAM

MONTHLY: dict[str, Any] = PROGRAM | {
    "header": {"cpu": "S7-400", "obs": [1, 10, 80, 100], "clock": "2026-11-21T05:59:30", "mode": "RUN"},
    "outside": [],
    "bodies": [
        {
            "ob": 1,
            "run": 1,
            "steps": [
                {"wait": 317},
                {"call": "DIS_AIRT"},
                {"call": "SET_TINT", "ob": 10, "sdt": "2026-12-31T06:00", "period": "16#1401"},
            ],
        }
    ],
}
EDITIONS = ["--profile", "1997", "--profile", "2010"]
OVERRUN: dict[str, Any] = PROGRAM | {
    "header": {"cpu": "S7-400", "obs": [1, 10, 85, 100], "clock": "2026-11-21T08:00:30", "mode": "RUN"},
    "duration": 500_000,
    "outside": [],
    "bodies": [
        {
            "ob": 1,
            "run": 1,
            "steps": [
                {"call": "SET_TINT", "ob": 10, "sdt": "2026-11-21T08:01", "period": "16#0201"},
                {"call": "ACT_TINT", "ob": 10},
            ],
        },
        {"ob": 10, "steps": [{"wait": 70_000}]},
    ],
}


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The programs as files in the working directory."""
    monkeypatch.chdir(tmp_path)
    for name, program in (("monthly", MONTHLY), ("overrun", OVERRUN)):
        (tmp_path / f"{name}.json").write_text(json.dumps(program), encoding="utf-8")
    return tmp_path


@pytest.mark.usefixtures("folder")
def test_compare_a_program(capsys: pytest.CaptureFixture[str]) -> None:
    """Two timelines, the line that differs, the clause on each side; nothing where there is no difference."""
    assert cli.main(["compare", "monthly.json", *EDITIONS]) == 1
    text = capsys.readouterr().out
    assert "profile 1997" in text.splitlines()[0]
    assert "first difference: 2026-11-21T05:59:30.317 SET_TINT" in text
    assert "  profile 2010 does not (it allows: SET_TINT ob=10 ret=16#8091" in text
    assert "TINT-18" in text
    assert cli.main(["compare", "monthly.json", "--cpu", "S7-400", "--cpu", "CPU 318"]) == 0
    assert capsys.readouterr().out.startswith("no difference: ")


def test_compare_a_log(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Which sides allow it, and the line and clause of the others."""
    assert cli.main(["simulate", "monthly.json", "--profile", "1997"]) == 0
    (folder / "log").write_text(capsys.readouterr().out, encoding="utf-8")
    assert cli.main(["compare", "log", *EDITIONS]) == 1
    text = capsys.readouterr().out
    assert text.startswith("profile 1997: allows it\nprofile 2010: line 3 is not possible: TINT-18")


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    "arguments", [["compare", "monthly.json", "--cpu", "S7-300"], ["distinguish"], ["compare", "no"]]
)
def test_wrong_arguments(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    """Two sides are needed, and a file."""
    assert cli.main(arguments) == 2
    assert "expected" in capsys.readouterr().err


@pytest.mark.usefixtures("folder")
def test_distinguish(capsys: pytest.CaptureFixture[str]) -> None:
    """A program that separates, without the steps that it does not need."""
    arguments = ["distinguish", "--programs", "monthly.json", "--format", "json"]
    assert cli.main([*arguments, *EDITIONS]) == 0
    found = json.loads(capsys.readouterr().out)
    steps = [step for body in found["program"]["bodies"] for step in body["steps"]]
    assert [step.get("call") for step in steps] == ["SET_TINT"]
    assert found["line"] == len(found["log"]) == 2
    assert cli.main([*arguments, "--pairs", "20", "--cpu", "S7-400", "--cpu", "CPU 318"]) == 1
    text = capsys.readouterr().out
    assert text.startswith("nothing found that tells cpu S7-400 and cpu CPU 318 apart")
    assert "none of up to " in text


def test_distinguish_by_search(capsys: pytest.CaptureFixture[str]) -> None:
    """From a log that is known, and from nothing; the answer says what was searched."""
    known = ["distinguish", "--format", "json", "--pairs", "300", "--reading", "AMB-09=a", "--reading", "AMB-09=b"]
    assert cli.main(known) == 0
    found = json.loads(capsys.readouterr().out)
    assert [line["event"] for line in found["log"][1:]] == ["SET_TINT", "CAN_TINT"]
    assert found["searched"][-1]["complete"] == 1
    with Engine() as engine:
        first, second = (Variant(letter, letters=(("AMB-63", letter),)) for letter in "ab")
        separation, _ = anywhere(engine, first, second, pairs=400)
    assert separation is not None
    assert len(separation.log) == 2


def test_told_apart_both_ways(real_engine: Engine) -> None:
    """The log of either side counts; the smaller program has the same clauses."""
    program = read_program(json.dumps(MONTHLY).encode())
    old, new = Variant("old", profile="1997"), Variant("new", profile="2010")
    found = told_apart(real_engine, program, new, old)
    assert found is not None
    less = smallest(real_engine, found)
    assert less.refusal.requirements == found.refusal.requirements
    assert len(less.log) < len(found.log)


def test_explain(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """What happened by itself, what a line says, and what it brings about."""
    assert cli.main(["simulate", "overrun.json"]) == 0
    log = capsys.readouterr().out
    (folder / "log").write_text(log, encoding="utf-8")
    assert cli.main(["explain", "log"]) == 0
    *_, start, stop = [line for line in capsys.readouterr().out.splitlines() if line[:1].isdigit()]
    assert "OB 10 is due, its point 2026-11-21T08:01 is reached; OB 10 starts, interrupting OB 1." in start
    assert "OB 10 is due again while it runs" in stop
    assert "the CPU stops for 16#4568" in stop
    assert "OBS-22" in stop
    (folder / "log").write_text(log + '{"event": "run", "at": "2026-11-21T09:00:00"}\n', encoding="utf-8")
    assert cli.main(["explain", "--format", "json", "log"]) == 1
    last = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert last["explanations"] == 0
    assert last["line"] == 6


def test_explain_braces(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The braces of the implementer's own objects are text, not places to fill; an entry of the buffer has its text."""
    header = {"format": "s7-interrupt-log/1", "cpu": "S7-400", "obs": [1, 10, 80, 85, 100]}
    lines = [
        {**header, "clock": "2026-11-21T06:00", "mode": "RUN"},
        {"event": "diag", "at": "2026-11-21T06:00", "id": "W#16#4301", "info": {"strt_info": "B#16#81"}},
        {"event": "DIS_AIRT", "at": "2026-11-21T06:00", "ret": 1, "x_own": {"of": {"mine": "{0}"}}},
    ]
    (folder / "log").write_text("".join(f"{json.dumps(line)}\n" for line in lines), encoding="utf-8")
    assert cli.main(["explain", "log"]) == 0
    told = capsys.readouterr().out
    assert "The diagnostic buffer has the entry 16#4301 (STOP to STARTUP)." in told
    assert "OB 1 calls DIS_AIRT ret=1 x_own={of={mine={0}}}" in told


def test_decide(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A log that only one letter explains decides its question; the file is one for ``--set``."""
    log = str(log_of("AMB-01-a-1202-refused"))
    assert cli.main(["decide", "--output", "cpu.json", log]) == 0
    assert capsys.readouterr().out.startswith("AMB-01 is a: ")
    assert json.loads((folder / "cpu.json").read_bytes())["AMB-01"] == "a"
    assert cli.main(["trace", "--set", "@cpu.json", log]) == 0
    (folder / "cpu.json").write_text("[]", encoding="utf-8")
    assert cli.main(["trace", "--set", "@cpu.json", log]) == 2
    assert "expected a JSON object" in capsys.readouterr().err


def test_a_profile_that_was_decided(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The file is one for ``--profile``, and for headers of logs beside it; nothing else is read as one."""
    right = log_of("AMB-22-edition-2006ru-number-beside-mode-00-as-printed")
    header, *lines = right.read_text(encoding="utf-8").splitlines()
    plain = {name: value for name, value in json.loads(header).items() if name not in ("profile", "readings")}
    logs = folder / "logs"
    logs.mkdir()

    def verdict(profile: str | None, *options: str) -> int:
        named = plain if profile is None else plain | {"profile": profile}
        (logs / "run.ndjson").write_text("\n".join([json.dumps(named), *lines]), encoding="utf-8")
        return cli.main(["trace", "--readings", "none", *options, str(logs / "run.ndjson")])

    assert cli.main(["decide", "--output", str(logs / "cpu.json"), str(right)]) == 0
    assert json.loads((logs / "cpu.json").read_bytes())["AMB-22"] == "b"
    assert verdict(None) == 1
    assert verdict("cpu.json") == 0
    assert verdict(None, "--profile", str(logs / "cpu.json")) == 0
    assert verdict("cpu.json", "--set", "AMB-22=a") == 1
    assert verdict("cpu.json", "--profile", "2010") == 0  # letters go before an edition
    capsys.readouterr()
    for wrong in ("other.json", "../logs/cpu.json", "cpu"):
        assert verdict(wrong) == 2
        assert 'field "profile": expected ' in capsys.readouterr().out
    assert cli.main(["next", str(logs / "run.ndjson")]) == 2
    assert verdict("cpu.json") == 0
    assert cli.main(["next", str(logs / "run.ndjson")]) == 0
    (logs / "cpu.json").write_text('{"AMB-22": "z"}', encoding="utf-8")
    assert verdict("cpu.json") == 2


def test_nothing_explains(capsys: pytest.CaptureFixture[str]) -> None:
    """A log that every reading rejects is named."""
    log = str(log_of("AIRT-07-nothing-delayed-answers-0000"))
    assert cli.main(["decide", log]) == 1
    assert "no reading explains: " in capsys.readouterr().out
