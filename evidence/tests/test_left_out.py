"""Kinds of event left out of accepted logs."""

import json
import subprocess
from pathlib import Path
from random import Random

import pytest
from click.testing import CliRunner

from evidence.common.cases import every_case
from evidence.common.checkout import SOFT_PLC_PROGRAM
from evidence.logs import left_out_command as command
from evidence.logs.damage import Log
from evidence.logs.drop import EVERY_KIND, subsets, without
from evidence.logs.growth_costs import answer_of
from evidence.logs.random_logs import Generator
from s7check.engine import pool
from s7check.engine.client import Engine
from s7check.report.report import Report

LOG = Log({"cycle": True}, [{"event": name} for name in ("SET_TINT", "start", "clock", "stop", "interrupt", "load")])


def test_every_subset() -> None:
    """Each choice of kinds is there once, but for none."""
    chosen = list(subsets())
    assert len(chosen) == len(set(chosen)) == 2 ** len(EVERY_KIND) - 1
    assert frozenset() not in chosen


@pytest.mark.parametrize("kind", EVERY_KIND)
def test_without_a_kind(kind: str) -> None:
    """One event is gone, and the header does not name its kind."""
    left = without(LOG, {kind})
    gone = [event for event in LOG.events if event not in left.events]
    assert gone == [LOG.events[EVERY_KIND.index(kind)]]
    assert kind not in left.header["records"]
    assert ("cycle" in left.header) == (kind != "ob")


@pytest.mark.parametrize("kind", EVERY_KIND)
def test_what_somebody_saw_stays(kind: str) -> None:
    """A `state` line is of no kind that is left out; it is no call either."""
    seen = Log({}, [{"event": "state"}])
    assert without(seen, {kind}).events == seen.events


@pytest.mark.parametrize("kind", EVERY_KIND)
def test_letters_without_a_kind(kind: str, engine: Engine) -> None:
    """What a letter allows stays allowed, also where only definite facts are followed."""
    worse = []
    for case in every_case():
        if case.area in ("AMB", "T15") and case.verdict == "accepted" and "readings" in case.header:
            header, *events = map(json.loads, case.lines)
            answer = answer_of(engine, without(Log(header, events), {kind}))
            worse += [(case.id, answer)] if answer.verdict != "accepted" else []
    assert worse == []


def test_a_log_that_gets_worse(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is kept and named, and the exit code says so."""

    def judge(file: Path, _engine: object) -> Report:
        header = json.loads(file.read_bytes().splitlines()[0])
        worse = set(header.get("records", [])) - {"diag"} == {"ob"}
        return Report(str(file), "rejected" if worse else "accepted", "", line=3 if worse else None)

    monkeypatch.setattr(command, "_judge", judge)
    run = CliRunner().invoke(command.left_out_command, ["--logs", "2", "--keep", str(tmp_path)])
    assert run.exit_code == command.WORSE
    assert "2 accepted logs, 126 with kinds left out: 2 not accepted" in run.output
    assert len(list(tmp_path.iterdir())) == 2


def test_some_subsets(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """So many are drawn for each log, the same ones for the same seed, and none twice."""
    files: list[str] = []

    def judge(file: Path, _engine: object) -> Report:
        files.append(file.name)
        return Report(str(file), "accepted", "")

    monkeypatch.setattr(command, "_judge", judge)
    for _ in range(2):
        run = CliRunner().invoke(command.left_out_command, ["--logs", "1", "--subsets", "5", "--keep", str(tmp_path)])
        assert "1 accepted logs, 5 with kinds left out: 0 not accepted" in run.output
    drawn = [file for file in files if file.startswith("1-1-")]
    assert drawn[:5] == drawn[5:]
    assert len(set(drawn)) == 5


def test_a_line_is_taken_once_where_the_engine_gives_up_behind_it(engine: Engine) -> None:
    """The work for this log ends at its line `run`: definite facts go on with that line, not behind it."""
    random = [str(SOFT_PLC_PROGRAM), "--random", "75", "--cpu", "S7-400", "--events", "80", "--diag"]
    header, *events = map(json.loads, subprocess.run(random, capture_output=True, check=True).stdout.splitlines())
    header["records"] = [*EVERY_KIND, "diag"]
    answer = answer_of(engine, without(Log(header, events), {"ob"}))
    assert (answer.verdict, answer.loose) == ("accepted", 26)


@pytest.mark.parametrize(("written", "logs"), [("2026-11-21T05:59:30", 60), ("2026-11-21T05:59", 20)])
def test_a_coarse_clock(written: str, logs: int, engine: Engine) -> None:
    """An accepted log whose lines are cut to seconds or minutes is no rejected one."""
    generator = Generator(1, SOFT_PLC_PROGRAM, pool.alternatives())
    verdicts = set()
    for number in range(logs):
        log = generator.written(Random(f"coarse/{number}"), 15)  # noqa: S311
        for event in log.events:
            event["at"] = event["at"][: len(written)]
            event.pop("up", None)
        verdicts.add(answer_of(engine, log).verdict)
    assert verdicts == {"accepted"}
