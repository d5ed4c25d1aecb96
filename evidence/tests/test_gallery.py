"""The gallery: its cases, its logs, and the way from TLC's states to a log."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from evidence.common.cases import CasesError
from evidence.common.gallery import CASES, cases, replace_log, write
from evidence.common.processes import Processes
from evidence.common.shorthand import shorthand
from evidence.tla.behaviour import as_log
from evidence.tla.tlc import Toolchain
from evidence.tla.values import UnreadableValueError, assignments, value
from evidence.views.gallery.search import NotFoundError, Search, configuration, module
from s7check.engine.client import Engine
from s7check.judging.check import check_log
from s7check.report.clauses import all_clauses


def test_each_case_has_a_log_of_its_own_and_requirements_that_exist() -> None:
    """At least forty cases."""
    found = cases()
    assert len(found) >= 40
    assert len({case.log for case in found}) == len(found)
    known = {clause.id for clause in all_clauses()}
    assert {name for case in found for name in case.requirements} <= known
    assert all(case.requirements and case.told for case in found)


def test_the_trace_checker_accepts_each_log(tmp_path: Path, engine: Engine) -> None:
    """What TLC finds, the trace checker explains."""
    write(tmp_path)
    for case in cases():
        report = check_log(str(tmp_path / f"{case.name}.ndjson"), engine, lambda *_: None)
        assert report.verdict == "accepted", str(report)


def test_a_case_is_found_again(tools: Toolchain) -> None:
    """By TLC, as shipped; and not where its goal is never reached."""
    case = next(one for one in cases() if one.name == "activated-too-late")
    search = Search(tools, Processes())
    short = shorthand(search(case))
    assert "\n".join(["", *short, ""]) in CASES.read_text()
    never = replace(case, goal="FALSE", world={"Moments": "{Moment(0, 30000)}"})
    with pytest.raises(NotFoundError, match="passed"):
        search(never)


def test_a_log_is_put_in_the_place_of_another(tmp_path: Path) -> None:
    """The rest of the file stays as it is; what the log says comes back from its short form."""
    path = tmp_path / "cases.txt"
    path.write_text(CASES.read_text())
    case, last = cases()[2], cases()[-1]
    replace_log(case.name, shorthand([json.loads(line) for line in last.log.splitlines()]), path)
    changed = cases(path)
    assert [one for one in cases() if one != case] == [one for one in changed if one.name != case.name]
    assert changed[2] == replace(case, log=last.log)
    replace_log(case.name, shorthand([json.loads(line) for line in case.log.splitlines()]), path)
    assert path.read_text() == CASES.read_text()


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("goal: Due", "expected one of title, goal, middle, budget, title: of a is missing"),
        ("title: A\nfoal: Due", "not foal"),
        ("title: A\ngoal: Due\nbudget: some", "budget: a number"),
        ("title: A\ngoal: Due\nfoal Due", "FIELD=VALUE; found foal"),
    ],
)
def test_a_case_that_is_none(line: str, said: str, tmp_path: Path) -> None:
    """The message has the line of the case and what is expected."""
    (tmp_path / "cases.txt").write_text(f"== a A CLK-02\n{line}\ncpu=S7-300 obs=1 clock=2026-11-21T06:00\n0:30 run\n")
    with pytest.raises(CasesError, match=f"cases.txt:[14]: .*{said}"):
        cases(tmp_path / "cases.txt")


def test_a_case_changes_only_the_constants_it_names() -> None:
    """The others keep the model's definitions."""
    case = next(one for one in cases() if "Loads" in one.world)
    text = configuration(case, "CONSTANTS\n    Loads <- GalleryLoads\n    Words <- GalleryWords\n")
    assert "Loads <- CaseGalleryLoads\n" in text
    assert "Words <- GalleryWords\n" in text
    assert "Goal <- CaseGoal\n" in text
    assert f"CaseGalleryLoads ==\n    {case.world['Loads']}\n" in module(case)


@pytest.mark.parametrize(
    ("text", "read"),
    [
        ("-3", -3),
        ("TRUE", True),
        ('"a [ b"', "a [ b"),
        ("{}", []),
        ("{1, 80}", [1, 80]),
        ("1..3", [1, 2, 3]),
        ('<<"x", <<>>>>', ["x", []]),
        ("[ob |-> 10, of |-> [min |-> 1]]", {"ob": 10, "of": {"min": 1}}),
        ("(10 :> 1 @@ 11 :> {2})", {10: 1, 11: [2]}),
    ],
)
def test_a_value_of_tlc_is_read(text: str, read: object) -> None:
    """Each kind of value."""
    assert value(text) == read


@pytest.mark.parametrize("text", ["", "<<1", "[a 1]", "1 2", "(1 :> 2", "§"])
def test_what_is_no_value_is_refused(text: str) -> None:
    """Instead of being read in part."""
    with pytest.raises(UnreadableValueError):
        value(text)


def test_a_state_is_read_by_its_variables() -> None:
    """Values may go over several lines."""
    assert assignments('/\\ mode = "RUN"\n/\\ tod = ( 10 :>\n      [set |-> TRUE] )\n') == {
        "mode": "RUN",
        "tod": {10: {"set": True}},
    }


def test_steps_become_lines() -> None:
    """Those that a log shows, at the time before the step."""
    state = {
        "cpu": {"family": "S7-400", "priority": {20: 4}, "step7": {}, "readings": {"AMB-18": "b"}},
        "loaded": [10, 80],
        "mode": "RUN",
        "startup": "none",
        "clock": {"min": 0, "ms": 30000},
        "requests": [{"ob": 80, "rank": 1, "fault": 5}],
    }
    step = {"ob": 0, "value": 0, "sdt": {}, "operand": 0, "sign": 0}
    later = state | {"clock": {"min": 60, "ms": 0}}
    states = [
        state | {"step": step | {"event": "power on"}},
        later | {"step": step | {"event": "clock"}},
        later | {"step": step | {"event": "reached", "ob": 10}},
        later | {"step": step | {"event": "start", "ob": 80}},
        later | {"step": step | {"event": "SRT_DINT", "ob": 20, "operand": 500, "sign": 7, "value": 0x8090}},
        later | {"step": step | {"event": "stop", "value": 0x4568}},
    ]
    header, *events = as_log(states)
    assert header["priority"] == {"20": 4}
    assert header["readings"] == {"AMB-18": "b"}
    assert header["obs"] == [1, 10, 80]
    assert events == [
        {"event": "clock", "at": "1990-01-01T00:00:30.000", "to": "1990-01-01T01:00:00.000"},
        {"event": "start", "at": "1990-01-01T01:00:00.000", "ob": 80, "info": {"flt_id": "16#05"}},
        {"event": "SRT_DINT", "at": "1990-01-01T01:00:00.000", "ob": 20, "dtime": 500, "sign": 7, "ret": "16#8090"},
        {"event": "stop", "at": "1990-01-01T01:00:00.000", "cause": "16#4568"},
    ]
