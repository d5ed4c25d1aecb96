"""The project's example logs, and small changes to them, judged by the real engine."""

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
DOCS = PROJECT / "docs" / "rules"

Lines = list[str]


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


@pytest.mark.parametrize("verdict", ["accepted", "rejected"])
def test_enough_logs(verdict: str) -> None:
    """There are at least twelve of either."""
    assert sum(case.verdict == verdict for case in CASES) >= 12


def test_requirements_exist() -> None:
    """The requirements and ambiguities of the cases have an entry in the documents."""
    text = "".join(path.read_text(encoding="utf-8") for path in DOCS.glob("re*.md"))
    known = set(re.findall(r'<a id="([A-Z]+[0-9]*-[0-9]+)">', text))
    assert {name for case in CASES for name in case.requirements} <= known


def with_ret(line: int, ret: str) -> Callable[[Lines], Lines]:
    """The log with another ``ret`` in one line."""

    def change(lines: Lines) -> Lines:
        changed, count = re.subn(r'("ret": )"[^"]*"', rf'\1"{ret}"', lines[line - 1])
        assert count == 1
        return [*lines[: line - 1], changed, *lines[line:]]

    return change


def without_start(line: int) -> Callable[[Lines], Lines]:
    """The log without one ``start`` line."""

    def change(lines: Lines) -> Lines:
        assert '"event": "start"' in lines[line - 1]
        return lines[: line - 1] + lines[line:]

    return change


def with_obs_swapped(one: int, other: int, *lines_changed: int) -> Callable[[Lines], Lines]:
    """The log with two OB numbers swapped in some of its ``start`` and ``end`` lines."""

    def change(lines: Lines) -> Lines:
        swapped = {f'"ob": {one}': f'"ob": {other}', f'"ob": {other}': f'"ob": {one}'}
        for number in lines_changed:
            assert '"event": "start"' in lines[number - 1] or '"event": "end"' in lines[number - 1]
            lines[number - 1] = re.sub(r'"ob": [0-9]+', lambda found: swapped[found[0]], lines[number - 1], count=1)
        return lines

    return change


@pytest.mark.parametrize(
    ("log", "change", "line"),
    [
        # SFC 42 answers the delays that are left, one of three here.
        ("AIRT-03-nested-delay", with_ret(9, "W#16#0002"), 9),
        # A single start point in the past cannot be activated.
        ("TINT-61-act-of-a-past-once", with_ret(4, "W#16#0000"), 4),
        # This single start point is not past.
        ("TINT-33-once-0000", with_ret(3, "W#16#80A1"), 3),
        # OB 40 ends without having started, and after its time.
        ("AIRT-03-nested-delay", without_start(11), 11),
        # OB 40 has not started in time when the next line is reached, a call.
        ("OBS-01-time-of-day-waits-for-hardware-interrupt", without_start(5), 5),
        # OB 80 ends without having started.
        ("TINT-14-overrun", without_start(5), 5),
        # OB 11 was due a minute before OB 10 of the same class.
        ("OBS-02-order-of-start-events-in-a-class", with_obs_swapped(10, 11, 9, 10, 11, 12), 9),
        # OB 82 has no start event yet.
        ("OBS-01-hardware-interrupt-preempts-time-of-day", with_obs_swapped(40, 82, 6, 8, 9, 10), 6),
        # OB 10 is not due yet.
        ("OBS-01-time-of-day-waits-for-hardware-interrupt", with_obs_swapped(10, 40, 5, 7, 8, 9), 5),
    ],
)
def test_changed_log_is_rejected(
    log: str,
    change: Callable[[Lines], Lines],
    line: int,
    tmp_path: Path,
    judge: Callable[[Path], Report],
) -> None:
    """One change to an accepted log is found at the line where it shows."""
    changed = tmp_path / "changed.ndjson"
    lines = log_of(log).read_text(encoding="utf-8").splitlines()
    changed.write_text("\n".join(change(lines)) + "\n", encoding="utf-8")
    report = judge(changed)
    assert (report.verdict, report.line) == ("rejected", line), report
    assert report.requirements


HEADER, SECOND, *_ = log_of("TINT-33-once-0000").read_text(encoding="utf-8").splitlines()


@pytest.mark.parametrize(
    ("text", "line", "reason"),
    [
        ("", 1, "an empty log"),
        ("garbage\n", 1, "JSON"),
        (f"{HEADER}\n{SECOND}\n\x00\x01garbage\n", 3, "JSON"),
        (f"{HEADER}\n{SECOND}\n{SECOND[:-20]}", 3, "JSON"),
        (HEADER.replace("s7-interrupt-log/1", "s7-interrupt-log/2") + "\n", 1, "s7-interrupt-log/2"),
    ],
    ids=["empty", "garbage", "garbage later", "truncated", "other version"],
)
def test_unusable_log(text: str, line: int, reason: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """What is not of the format gives exit code 2, and file, line and reason."""
    log = tmp_path / "log.ndjson"
    log.write_text(text, encoding="utf-8")
    assert cli.main(["trace", str(log)]) == 2
    captured = capsys.readouterr()
    assert captured.out.startswith(f"{log}:{line}: unusable: ")
    assert reason in captured.out
    assert captured.err == ""
