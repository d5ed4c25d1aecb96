"""The project's example logs, and answers put into others, judged by the real engine."""

import json
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from s7check import cli
from s7check.report.report import Report
from tests.shipped import CASES, TRACES, log_of

PROJECT = Path(cli.__file__).parents[2]


@pytest.fixture(scope="module")
def reports() -> dict[str, dict[str, Any]]:
    """What one run of ``s7check trace --format json`` says of the log of each case."""
    command = [sys.executable, "-m", "s7check", "trace", "--format", "json"]
    logs = [str(TRACES / case.file) for case in CASES]
    run = subprocess.run([*command, *logs], cwd=PROJECT, capture_output=True, timeout=600, check=False)
    assert run.stderr == b""
    assert run.returncode == 2, "the highest exit code: some logs are unusable, none is without a verdict"
    objects = [json.loads(line) for line in run.stdout.splitlines()]
    assert [report["log"] for report in objects] == logs
    return {case.id: report for case, report in zip(CASES, objects, strict=True)}


@pytest.mark.parametrize("area", sorted({case.area for case in CASES}))
def test_verdicts(area: str, reports: dict[str, dict[str, Any]]) -> None:
    """Verdict and line are those of the case, and a rejection names the requirements."""
    wrong = []
    for case in (case for case in CASES if case.area == area):
        report = reports[case.id]
        found = (report["verdict"], report["line"], bool(report["requirements"]))
        if found != (case.verdict, case.line, case.verdict == "rejected"):
            wrong.append((case.id, case.verdict, case.line, report))
    assert wrong == []


def test_requirements_decide(reports: dict[str, dict[str, Any]]) -> None:
    """The requirements of a rejection are those that the case names, at least one of them, and few others."""
    rejected = {case.id: set(case.requirements) for case in CASES if case.verdict == "rejected"}
    others = [file for file, ids in rejected.items() if not ids & set(reports[file]["requirements"])]
    assert len(others) <= len(rejected) // 100, others
    assert max(len(reports[file]["requirements"]) for file in rejected) <= 8


def test_first_cited(reports: dict[str, dict[str, Any]]) -> None:
    """The requirement that a rejection cites first is one that the case names, mostly the one that decides."""
    rejected = [case for case in CASES if case.verdict == "rejected"]
    first = {case.id: reports[case.id]["requirements"][0] for case in rejected}
    others = [f"{case.id}: {first[case.id]}" for case in rejected if first[case.id] not in case.requirements]
    assert len(others) <= len(rejected) // 8, others
    decides = {case.id: [name for name in case.requirements if name[:3] not in ("AMB", "A15")][:1] for case in rejected}
    assert sum([first[case]] == names for case, names in decides.items()) >= len(rejected) * 0.74


@pytest.mark.parametrize(
    ("event", "wrong", "cited"),
    [
        ('"DIS_IRT", "mode": "B#16#00", "ob": 0', "16#8090", "IRT-06 IRT-12"),
        ('"DIS_IRT", "mode": "B#16#01", "ob": 40', "16#8090", "IRT-12 IRT-07"),
        ('"DIS_IRT", "mode": "B#16#02", "ob": 40', "16#8091", "IRT-12 IRT-08"),
        ('"DIS_IRT", "mode": "B#16#82", "ob": 40', "16#8091", "IRT-09 IRT-12 IRT-08"),
        ('"EN_IRT", "mode": "B#16#02", "ob": 40', "16#8091", "IRT-12 IRT-15 IRT-13"),
        ('"SET_TINT", "ob": 10, "sdt": "2026-11-21T09:00", "period": "16#0201"', "16#80A1", "TINT-36 TINT-37 TINT-30"),
        ('"SET_TINT", "ob": 10, "sdt": "2026-11-29T09:00", "period": "16#1401"', "16#0000", "TINT-18 TINT-39"),
        ('"ACT_TINT", "ob": 10', "16#0000", "TINT-61 TINT-07"),
        ('"CAN_DINT", "ob": 20', "16#0000", "DINT-14"),
        ('"EN_AIRT"', "16#0000", "AIRT-07 AIRT-03"),
    ],
)
def test_requirement_of_an_answer(
    event: str, wrong: str, cited: str, tmp_path: Path, judge: Callable[[Path], Report]
) -> None:
    """A wrong answer cites the rules of this call with these operands, the one that decides first."""
    log = tmp_path / "answer.ndjson"
    before = '"DIS_IRT", "mode": "B#16#02", "ob": 40, "ret": 0' if "EN_IRT" in event else '"EN_AIRT", "ret": "16#8080"'
    at = '"at": "2026-11-21T08:00:01"'
    header = (
        '{"format": "s7-interrupt-log/1", "cpu": "S7-400", "obs": [1, 10, 20, 40], "clock": "2026-11-21T08:00", '
        '"mode": "RUN"}'
    )
    log.write_text(f'{header}\n{{"event": {before}, {at}}}\n{{"event": {event}, "ret": "{wrong}", {at}}}\n')
    report = judge(log)
    assert (report.verdict, report.line) == ("rejected", 3)
    assert " ".join(report.requirements) == cited


def test_names() -> None:
    """A case is named after the first of its requirements and stands in the area of that one, with a reason.

    Only cases about the format have no requirement.
    """
    for case in CASES:
        assert case.reason, case
        if case.area == "FORMAT":
            assert not case.requirements, case
            continue
        first = case.requirements[0]
        assert case.name.startswith(f"{first}-"), case
        assert first.startswith(f"{case.area}-"), case


def test_changed_log_is_rejected(tmp_path: Path, judge: Callable[[Path], Report]) -> None:
    """A single start point that is not past cannot be refused as one."""
    *before, line = log_of("TINT-33-once-0000").read_text(encoding="utf-8").splitlines()[:3]
    changed, count = re.subn(r'("ret": )"[^"]*"', r'\1"W#16#80A1"', line)
    assert count == 1
    log = tmp_path / "changed.ndjson"
    log.write_text("\n".join([*before, changed]) + "\n", encoding="utf-8")
    report = judge(log)
    assert (report.verdict, report.line) == ("rejected", 3), report
    assert report.requirements
