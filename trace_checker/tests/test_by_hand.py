"""Logs that were judged by hand, from the requirements alone, before the checker saw them."""

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from evidence.common.cases import TRACES, Case, all_cases
from evidence.logs.damage import Log
from evidence.logs.drop import without
from s7check.engine.client import Engine
from s7check.judging.check import check_log
from s7check.judging.workers import Workers
from s7check.report.report import Report

DOCS = Path(__file__).parents[2] / "docs"
CONSTANTS = re.compile(
    r'<a id="(AMB-\d+)"></a>(?:(?!<a id).)*?Default (\w): (?:(?!<a id).)*?Specification: constant \(([a-d, ]+)\)'
)
"""The entries of readings.md whose letters the specification tells apart: name, default, letters."""

CASES = all_cases(TRACES / "by_hand")

LEFT_OUT = (
    *(("call",), ("ob",), ("clock",), ("mode",), ("interrupt",), ("load", "interrupt"), ("call", "clock")),
    *(("ob", "mode"), ("clock", "mode"), ("call", "interrupt")),
)


@pytest.fixture(scope="module")
def reports(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Report]:
    """The verdict about the log of each case, found on all cores."""
    folder = tmp_path_factory.mktemp("by_hand")
    logs = [case.put(folder) for case in CASES]
    with Workers(Engine) as workers:
        found = workers.in_order(logs, lambda log, engine: check_log(str(log), engine, lambda _, __: None))
        return {case.id: judged.result() for case, judged in zip(CASES, found, strict=True)}


@pytest.mark.parametrize("area", sorted({case.area for case in CASES}))
def test_verdicts(area: str, reports: dict[str, Report]) -> None:
    """The verdict, and the line of a log that is not accepted."""
    wrong = []
    for case in (case for case in CASES if case.area == area):
        report = reports[case.id]
        if (report.verdict, report.line) != (case.verdict, case.line):
            wrong.append((case.id, case.verdict, case.line, report.verdict, report.line, report.message))
    assert wrong == []


def objects(case: Case) -> list[dict[str, Any]]:
    """Header and events of a log that can be read."""
    return [json.loads(line) for line in case.lines if line.strip()]


def judged(lines: list[dict[str, Any]], judge: Callable[[Path], Report], folder: Path) -> tuple[str, int | None]:
    """Verdict and line about a log of these lines."""
    file = folder / "log.ndjson"
    file.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    report = judge(file)
    return report.verdict, report.line


def test_a_kind_left_out_makes_no_log_worse(judge: Callable[[Path], Report], tmp_path: Path) -> None:
    """Accepted logs without the lines of some kinds are accepted, too (fine point 9)."""
    complete = [case for case in CASES if case.verdict == "accepted" and b'"records"' not in case.log]
    wrong, tried = [], set()
    for number, case in enumerate(complete[::6]):
        kinds = LEFT_OUT[number % len(LEFT_OUT)]
        header, *events = objects(case)
        log = without(Log(header, events), set(kinds))
        if len(log.events) == len(events):
            continue
        tried.add(kinds)
        if judged([log.header, *log.events], judge, tmp_path) != ("accepted", None):
            wrong.append((case.id, kinds))
    assert wrong == []
    assert tried == set(LEFT_OUT)


def test_every_letter_has_an_effect(judge: Callable[[Path], Report], tmp_path: Path) -> None:
    """The verdict of a log hangs on each letter that is no default and that the specification tells apart."""
    effective = set[tuple[str, str]]()
    for case in (case for case in CASES if case.verdict != "unusable" and b'"readings"' in case.log):
        header, *events = objects(case)
        readings = header["readings"]
        for letter in readings.items() - effective:
            fewer = header | {"readings": {name: chosen for name, chosen in readings.items() if name != letter[0]}}
            if judged([fewer, *events], judge, tmp_path) != (case.verdict, case.line):
                effective.add(letter)
    found = CONSTANTS.findall(" ".join((DOCS / "rules" / "readings.md").read_text(encoding="utf-8").split()))
    assert len(found) > 70
    letters = {(name, letter) for name, default, choice in found for letter in choice.split(", ") if letter != default}
    assert letters - effective == {("AMB-04", "c")}  # bit 5 is 0 as under (a): there is no test function
