"""``s7check coverage``: the rules that logs exercise."""

import json
from pathlib import Path

import pytest

from s7check.cli import main
from s7check.coverage import Coverage, Guard, measure
from s7check.engine.client import Engine
from s7check.judging.decisions import decisions_of
from s7check.log.calls import WITHOUT_NUMBER
from tests.logs import HEADER, RUN, event, log_text
from tests.shipped import CASES, TRACES
from tests.test_simulating import PROGRAM


def lines(*events: dict[str, object], header: dict[str, object] = RUN) -> list[bytes]:
    """A log as lines."""
    return log_text(*events, header=header).splitlines()


def requirements(engine: Engine, *events: dict[str, object], header: dict[str, object] = RUN) -> frozenset[str]:
    """The requirements that decided something."""
    return measure(lines(*events, header=header), engine).requirements


def test_nothing_happens(real_engine: Engine) -> None:
    """A log in which nothing happens exercises next to nothing, for each CPU and mode."""
    for cpu in ("S7-300", "S7-400"):
        for mode in ("RUN", "STOP"):
            header = HEADER | {"cpu": cpu, "mode": mode}
            assert len(requirements(real_engine, event("clock", to="2026-11-21T05:59:31"), header=header)) <= 3


@pytest.mark.parametrize(
    ("events", "shown", "not_shown"),
    [
        ([event("DIS_AIRT", ret=1)], {"AIRT-06"}, {"AIRT-07", "IRT-12", "TINT-35"}),
        ([event("EN_AIRT", ret=0x8080)], {"AIRT-07"}, {"AIRT-06", "IRT-12"}),
        ([event("DIS_IRT", mode=3, ob=40, ret=0x8091)], {"IRT-12"}, {"AIRT-07", "TINT-18"}),
        (
            [event("SET_TINT", ob=10, sdt="2026-12-29T06:00", period=0x1401, ret=0x8091)],
            {"TINT-18", "TINT-35"},
            {"TINT-60", "DINT-04"},
        ),
        (
            [event("SET_TINT", ob=10, sdt="2026-12-27T06:00", period=0x1001, ret=0)],
            {"TINT-30"},
            {"TINT-18", "TINT-35", "TINT-36"},
        ),
        ([event("CAN_DINT", ob=20, ret=0x80A0)], {"DINT-14"}, {"DINT-04"}),
    ],
)
def test_requirements(
    events: list[dict[str, object]], shown: set[str], not_shown: set[str], real_engine: Engine
) -> None:
    """A call shows the requirements that decide its answer, and not those of others."""
    found = requirements(real_engine, *events)
    assert shown <= found
    assert not not_shown & found


def test_shipped_logs_of_a_requirement(real_engine: Engine) -> None:
    """Each accepted log without a kind left out shows, as a rule, the requirements that its case names."""
    decidable = set(decisions_of(real_engine).requirements)
    named = met = 0
    for case in CASES:
        if case.verdict == "accepted" and "not-recorded" not in case.name:
            found = measure(TRACES / case.file, real_engine)
            wanted = set(case.requirements) & decidable
            named += len(wanted)
            met += len(wanted & found.requirements)
    assert named > 100
    assert met > 0.85 * named


def test_outcomes_do_not_depend_on_the_engines_memory(real_engine: Engine) -> None:
    """A log that the engine has seen before is told alike: evaluated, recorded, remembered."""
    for log in sorted((TRACES / "CLK" / "accept").glob("*.ndjson"))[::9]:
        first, *others = (measure(log, real_engine) for _ in range(4))
        with Engine() as fresh:
            assert measure(log, fresh) == first
        assert others == [first] * 3, log.name


def test_open(real_engine: Engine) -> None:
    """What only some explanations use is open: a cycle may have ended before the second call."""
    text = lines(event("DIS_AIRT", ret=1), event("interrupt", ob=40), event("EN_AIRT", 32, ret=None))
    found = measure(text, real_engine)
    assert "AIRT-06" in found.requirements
    assert not found.open & found.requirements


def test_lines_of_their_own(real_engine: Engine) -> None:
    """Answers, PERIODs, OBs, classes and kinds left out come from the lines."""
    header = RUN | {"records": ["call", "ob", "clock", "mode", "load"]}
    found = measure(
        lines(
            event("SET_TINT", ob=10, sdt="2026-12-27T06:00", period=0x1001, ret=0),
            event("SET_TINT", ob=10, sdt="2026-12-27T06:00", period=0x0007, ret="16#8092"),
            event("start", ob=40),
            header=header,
        ),
        real_engine,
    )
    assert found.verdicts == ("rejected",), "OB 40 is not loaded"
    assert found.answers == {("SET_TINT", 0), ("SET_TINT", 0x8092)}
    assert found.periods == {0x1001}
    assert found.left_out == {"interrupt"}
    found = measure(lines(event("interrupt", ob=40), event("start", ob=40), header=RUN | {"obs": [1, 40]}), real_engine)
    assert found.obs == {40}
    assert found.classes == {16}


def test_guards(real_engine: Engine) -> None:
    """Both outcomes of a condition are two things to meet."""
    found = measure(lines(event("EN_AIRT", ret=0x8080)), real_engine).guards
    conditions = {(one.definition, one.text, one.outcome) for one in found if one.module == "Lines"}
    assert ("IsCall", "Called", True) in conditions
    assert ("IsCall", "Called", False) not in conditions


def test_union() -> None:
    """Logs together: an open requirement is settled by a log that shows it."""
    guard = Guard("M", "D", 1, 1, "x", outcome=True)
    one = Coverage(requirements=frozenset({"A-01"}), open=frozenset({"A-02"}), verdicts=("accepted",))
    other = Coverage(requirements=frozenset({"A-02"}), guards=frozenset({guard}), verdicts=("rejected",))
    both = one | other
    assert both.requirements == {"A-01", "A-02"}
    assert both.open == frozenset()
    assert both.guards == {guard}
    assert both.verdicts == ("accepted", "rejected")


@pytest.fixture
def log(tmp_path: Path) -> Path:
    """A log of a call."""
    file = tmp_path / "log.ndjson"
    file.write_bytes(log_text(event("EN_AIRT", ret=0x8080), header=RUN))
    return file


def test_command(log: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The numbers, the gaps with a program for each that has one, the missing answers."""
    program = PROGRAM | {"name": "IRT-x", "requirements": ["IRT-12", "AIRT-07"]}
    (tmp_path / "p.json").write_text(json.dumps(program), encoding="utf-8")
    assert main(["coverage", "--guards", "--programs", str(tmp_path / "p.json"), str(log)]) == 0
    out = capsys.readouterr().out
    assert out.startswith("1 logs: 1 accepted\nrequirements: ")
    assert "\n  IRT-x: IRT 12\n" in out
    assert "\n  IRT-12 8090: bad OB_NR." in out
    assert "\n  AIRT-07 " not in out
    assert "EN_AIRT 0000;" in out
    assert "PERIODs never set: 0000, 0201," in out
    assert "FALSE: Called\n" in out


def test_formats(log: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """JSON has the same content, HTML is a page; FILE is written whole."""
    assert main(["coverage", "--format", "json", str(log)]) == 0
    found = json.loads(capsys.readouterr().out)
    assert "AIRT-07" in found["requirements"]
    assert "AIRT-06" in {gap["requirement"] for gap in found["gaps"]}
    assert found["answers"] == [{"call": "EN_AIRT", "ret": 0x8080}]
    assert len(found["guards"]) + len(found["guards_not_met"]) > 500
    page = tmp_path / "page.html"
    assert main(["coverage", "--format", "html", "--output", str(page), str(log)]) == 0
    assert page.read_bytes().startswith(b"<!DOCTYPE html>")
    assert "AIRT-06" in page.read_text(encoding="utf-8")


def test_exit_codes(log: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A log that is not accepted shows in the exit code; wrong programs are one sentence."""
    other = tmp_path / "other.ndjson"
    other.write_bytes(log_text(event("EN_AIRT", ret=0), header=RUN))
    assert main(["coverage", str(log), str(other)]) == 1
    assert capsys.readouterr().out.startswith("2 logs: 1 accepted, 1 rejected\n")
    assert main(["coverage", "--programs", str(log), str(log)]) == 2
    assert "field" in capsys.readouterr().err


def test_an_accepted_report_says_how_much_if_asked(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The text says it in a line, JSON by IDs."""
    assert main(["trace", str(log)]) == 0
    assert "decided" not in capsys.readouterr().out
    assert main(["trace", "--decided", str(log)]) == 0
    assert " requirements decided something\n" in capsys.readouterr().out
    assert main(["trace", "--decided", "--format", "json", str(log)]) == 0
    report = json.loads(capsys.readouterr().out)
    assert "AIRT-07" in report["decided"]
    assert len(report["decided"]) < report["decidable"]


def test_answers_that_a_call_may_have(real_engine: Engine) -> None:
    """The answers of accepted logs are those that the specification lists.

    General errors (AMB-81), and those of an S7-1500, whose calls may have other ones (A15-24), stand apart.
    """
    listed = {
        (call, ret & 0xFFFF)
        for call, rets in real_engine.alternatives().answers
        if call != WITHOUT_NUMBER
        for ret in rets
    }
    seen = {
        (entry["event"], ret)
        for file in sorted(TRACES.glob("*/accept/*.ndjson"))
        for header, *events in [file.read_text(encoding="utf-8").splitlines()]
        if "S7-1500" not in header
        for line in events
        if line.strip() and isinstance((entry := json.loads(line)).get("ret"), str)
        for ret in [int(entry["ret"].rpartition("#")[2], 16)]
        if ret < 0x8100 and entry["event"] != "DIS_AIRT" and not (entry["event"] == "EN_AIRT" and 0 < ret < 0x8000)
    }
    assert seen == listed
