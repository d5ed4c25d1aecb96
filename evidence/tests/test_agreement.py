"""``s7spec logs agree``: the logs that are drawn, what TLC says of them, and that a difference is found."""

from __future__ import annotations

import json
import shutil
from collections import Counter
from datetime import timedelta
from pathlib import Path
from random import Random
from typing import Any

import pytest
from click.testing import CliRunner

from evidence.common.cases import all_cases
from evidence.common.checkout import SOFT_PLC_PROGRAM as SOFT_PLC
from evidence.common.processes import Processes
from evidence.logs import agree, damage, tlc_batch
from evidence.logs.agree import Compared
from evidence.logs.agree_command import agree_command
from evidence.logs.damage import Log
from evidence.logs.random_logs import UNCHANGED, Generated, Generator, SoftPlcError
from evidence.logs.setups import scenario
from evidence.logs.tlc_batch import Judged
from evidence.tla import tlc
from s7check.engine import pool
from s7check.engine.answer import Alternatives
from s7check.report.report import Report
from s7check.resources import SPECIFICATION
from tests.logs import RUN, event, log_text


@pytest.fixture(scope="module")
def generator() -> Generator:
    """Logs of seed 1."""
    return Generator(1, SOFT_PLC, pool.alternatives())


def run(*arguments: str) -> tuple[int, str]:
    """Run the command; return exit code and output."""
    ran = CliRunner().invoke(agree_command, list(arguments))
    return ran.exit_code, ran.output


def unreadable(log: Generated) -> bool:
    """Whether the reader refuses a log."""
    with pool.engine() as engine:
        return engine.read(log.content).unusable is not None


def test_logs_are_drawn_by_seed(generator: Generator) -> None:
    """The same seed, number and attempt give the same log; nearly all can be read; all is done to some."""
    drawn = [generator.draw(number, 0) for number in range(1, 301)]
    assert drawn[:5] == [Generator(1, SOFT_PLC, pool.alternatives()).draw(number, 0) for number in range(1, 6)]
    assert drawn[0] != generator.draw(1, 1)
    assert drawn[0] != Generator(2, SOFT_PLC, pool.alternatives()).draw(1, 0)
    assert sum(map(unreadable, drawn)) < 30
    assert not any(unreadable(log) for log in drawn if log.done == (UNCHANGED,))
    assert {log.cpu for log in drawn} == {"S7-300", "S7-400", "CPU 318", "S7-1500"}
    assert all(1 <= log.lines <= 66 for log in drawn)
    done = {what for log in drawn for what in log.done}
    assert done >= {one.what for one in damage.DAMAGES}
    modes = {json.loads(log.content.split(b"\n")[0] or b"{}").get("mode") for log in drawn}
    assert modes >= {"RUN", "STOP", "STARTUP"}


def test_scenarios_differ() -> None:
    """In family, classes, STEP 7 parameters and terms."""
    words = pool.alternatives()
    text = "".join(scenario(Random(number), words) for number in range(200))  # noqa: S311
    for setting in ("priority", "step7", "deselected", "end_of_month"):
        assert setting in text
    for setting in ('"diag": true', '"cycle": true', '"latency_ms": 0'):
        assert setting in text


def small_log() -> Log:
    """A log with elapsed time and a change of the clock."""
    lines: list[dict[str, Any]] = [
        event("DIS_AIRT", 31, up=1000, ret=1),
        event("clock", 32, up=2000, to="2026-11-21T06:10:00.000"),
        {"event": "EN_AIRT", "at": "2026-11-21T06:10:01.000", "up": 3000, "ret": 0},
    ]
    return Log({}, lines)


def test_later_ends_where_the_clock_is_set() -> None:
    """The clock does not show the delay after it was set; elapsed time does."""
    log = small_log()
    for seed in range(50):
        log = small_log()
        damage._later(Random(seed), log, Alternatives())  # noqa: S311
        assert log.events[2]["at"] == "2026-11-21T06:10:01.000" or log.events[1] == small_log().events[1]
        ups = [one["up"] for one in log.events]
        assert ups == sorted(ups)
        assert log != small_log()


def test_the_clock_is_set_with_a_line() -> None:
    """Later lines show the time of the clock that was set."""
    for seed in range(50):
        log = small_log()
        damage._jump(Random(seed), log, Alternatives())  # noqa: S311
        assert len(log.events) == 4
        assert sum(one["event"] == "clock" for one in log.events) == 2
        content = log_text(*log.events)
        assert not unreadable(Generated(content, "", ()))


def test_how_long_the_clock_runs() -> None:
    """From line to line, but for what a line sets."""
    log = small_log()
    assert damage.elapses(log) == timedelta(seconds=1)
    del log.events[1]
    assert damage.elapses(log) == timedelta(minutes=10, seconds=30)


@pytest.mark.parametrize(("certain_from", "endless"), [(None, 0), (2, 0), (3, 1)])
def test_logs_that_the_engine_does_not_follow(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, generator: Generator, certain_from: int | None, endless: int
) -> None:
    """A log with definite facts alone from its first line on can be compared; from a later line on another is drawn."""
    reports = iter([Report("a", "accepted", "", certain_from=certain_from), Report("a", "accepted", "")])
    monkeypatch.setattr(agree, "check_log", lambda *_: next(reports))
    refused: Counter[str] = Counter()
    with pool.engine() as engine:
        agree._decided(generator, engine, 1, tmp_path / "1.ndjson", refused)
    assert refused["endless"] == endless


def test_verdicts_of_tlc(tools: tlc.Toolchain, tmp_path: Path) -> None:
    """Cases as they say; blank lines and Windows' ends of lines count as in every report."""
    cases = [case for case in all_cases() if case.verdict != "unusable"][::25]
    files = [case.put(tmp_path) for case in cases]
    blank = tmp_path / "blank.ndjson"
    wrong = log_text("", event("DIS_AIRT", ret=1), "", event("EN_AIRT", ret=1))
    blank.write_bytes(b" \n" + wrong.replace(b"\n", b"\r\n"))
    least = tmp_path / "least.ndjson"
    least.write_bytes(log_text(event("SRT_DINT", ob=20, dtime=-(2**31), sign=0, ret="16#8090")))
    said = tlc_batch.judge(tools, Processes(), SPECIFICATION, [*files, blank, least])
    expected = [Judged(case.verdict, case.line) for case in cases]
    assert said.verdicts[:-2] == expected
    assert {one.verdict for one in expected} == {"accepted", "rejected"}
    # It begins in STOP, where nothing is called.
    assert said.verdicts[-2] == Judged("rejected", 4)
    assert said.verdicts[-1] == Judged("rejected", 2)
    assert said.version


def test_a_log_that_tlc_cannot_judge(tools: tlc.Toolchain, tmp_path: Path) -> None:
    """The others of its batch get their verdicts."""
    spec = tmp_path / "spec"
    shutil.copytree(SPECIFICATION, spec)
    text = (spec / "rules" / "Airt.tla").read_text()
    assert text.count("DisAirt ==") == 1
    (spec / "rules" / "Airt.tla").write_text(
        text.replace("DisAirt ==", "DisAirt == CHOOSE nothing \\in {} : TRUE\nOld ==")
    )
    good, bad = tmp_path / "good.ndjson", tmp_path / "bad.ndjson"
    good.write_bytes(log_text())
    bad.write_bytes(log_text(event("DIS_AIRT", ret=1), header=RUN))
    said = tlc_batch.judge(tools, Processes(), spec, [good, bad]).verdicts
    assert said[0] == Judged("accepted")
    assert said[1].verdict.startswith("no verdict: error")


def test_a_specification_that_tlc_cannot_read(tools: tlc.Toolchain, tmp_path: Path) -> None:
    """No log is to blame."""
    with pytest.raises(tlc_batch.BatchError, match="TLC does not begin"):
        tlc_batch.judge(tools, Processes(), tmp_path, [all_cases()[0].put(tmp_path)])


def test_agreement_on_a_sample(tools: tlc.Toolchain, generator: Generator, tmp_path: Path) -> None:
    """Eight logs in a run of TLC."""
    results = tmp_path / "results.json"
    code, output = run("--logs", "8", "--seed", "7", "--keep", str(tmp_path / "kept"), "--json", str(results))
    assert code == 0, output
    found = json.loads(results.read_text())
    assert found["accepted"] + found["rejected"] == found["logs"] == len(found["verdicts"]) == 8
    assert found["differ"] == 0
    assert "the same verdict at the same line" in output
    assert not (tmp_path / "kept").exists()


def test_a_difference_is_found(tools: tlc.Toolchain, generator: Generator, tmp_path: Path) -> None:
    """TLC reads a specification whose EN_AIRT answers otherwise: the log is named and kept, with both verdicts."""
    spec = tmp_path / "spec"
    shutil.copytree(SPECIFICATION, spec)
    text = (spec / "rules" / "Airt.tla").read_text()
    assert "ELSE count - 1}" in text
    (spec / "rules" / "Airt.tla").write_text(text.replace("ELSE count - 1}", "ELSE count + 1}"))
    kept = tmp_path / "kept"
    results = tmp_path / "results.json"
    arguments = ["--logs", "20", "--seed", "7", "--spec", str(spec), "--keep", str(kept), "--json", str(results)]
    code, output = run(*arguments)
    assert code == 1, output
    differ = [one for one in json.loads(results.read_text())["verdicts"] if one["engine"] != one["tlc"]]
    assert differ
    assert f"{len(differ)} DIFFER" in output
    for one in differ:
        assert f"{one['log']}.ndjson: engine: {one['engine']}; TLC: {one['tlc']}" in output
        assert f"engine: {one['engine']}" in (kept / f"{one['log']}.txt").read_text()
        line = int(one["tlc"].rpartition(" ")[2])
        assert b'"EN_AIRT"' in (kept / f"{one['log']}.ndjson").read_bytes().split(b"\n")[line - 1]


@pytest.mark.parametrize(
    ("engine", "by_tlc", "agree"),
    [
        (Judged("accepted"), Judged("accepted"), True),
        (Judged("rejected", 3), Judged("rejected", 3), True),
        (Judged("rejected", 3), Judged("rejected", 4), False),
        (Judged("rejected", 3), Judged("accepted"), False),
        (Judged("no verdict", 3), Judged("no verdict: error 2132"), False),
    ],
)
def test_what_agrees(engine: Judged, by_tlc: Judged, agree: bool) -> None:
    """Verdict and line; to have none is to differ."""
    assert Compared(1, Generated(b"", "", ()), "", engine, by_tlc).agree is agree


def test_tools_missing(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, tools: tlc.Toolchain) -> None:
    """No TLC, no soft PLC, wrong arguments."""
    code, output = run("--logs", "1", "--tlc", str(tmp_path / "none.jar"))
    assert (code, "TLC's jar is not at" in output) == (3, True)
    monkeypatch.setattr(agree, "SOFT_PLC_PROGRAM", tmp_path / "none")
    code, output = run("--logs", "1")
    assert (code, "the soft PLC is not at" in output) == (3, True)
    assert run("--logs", "0")[0] == 2
    assert run("--spec", str(tmp_path / "nowhere"))[0] == 2


def test_a_soft_plc_that_fails(tmp_path: Path) -> None:
    """Its own words are passed on."""
    program = tmp_path / "plc"
    program.write_text("#!/bin/sh\necho 'no such thing' >&2\nexit 2\n")
    program.chmod(0o755)
    with pytest.raises(SoftPlcError, match="no such thing"):
        Generator(1, program, Alternatives())
