"""The harness as a whole, on TLC: what is as pinned passes, each kind of drift fails with the right words."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from evidence.common.cases import read_cases
from evidence.models import canaries, unchanged
from evidence.models.models_command import models_command
from evidence.tests.models.conftest import Project
from s7check.engine.client import Engine
from s7check.judging.check import check_log
from tests.processes import heed_ctrl_c


def test_a_violation_becomes_a_log(tmp_path: Path, jar: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A control that changes a property: System has the behaviour, so that the trace checker accepts its log."""
    name = "neg-waiting-error-cancelled"
    monkeypatch.setattr(unchanged, "FULL", tmp_path / "full.json")  # a test leaves no result in the tree
    ran = CliRunner().invoke(models_command, ["--tlc", str(jar), "--logs", str(tmp_path / "logs.txt"), name])
    assert ran.exit_code == 0, ran.output
    (case,) = read_cases(tmp_path / "logs.txt")
    assert case.name == name
    assert json.loads(case.lines[-1])["event"] == "CAN_DINT"
    with Engine() as engine:
        assert check_log(str(case.put(tmp_path)), engine, lambda *_: None).verdict == "accepted"


def test_all_as_pinned(project: Project) -> None:
    """A passing model and a negative control of each kind are as pinned: exit 0, a table row and a JSON entry each."""
    logs = project.root / "logs.txt"
    exit_code, output, results = project.run("--logs", str(logs))
    assert exit_code == 0, output
    assert logs.read_bytes() == b"", "states of another specification, a lasso, a deadlock are no log"
    assert results["ok"] is True
    assert results["tlc"]["version"]
    kinds = {m["name"]: m["result"] for m in results["models"]}
    assert kinds == {
        "counter": "passed",
        "neg-overshoot": "invariant",
        "neg-definition": "invariant",
        "neg-step": "action",
        "neg-returns": "temporal",
        "neg-initial": "initial",
        "neg-deadlock": "deadlock",
        "neg-assumption": "assumption",
        "witness-end": "invariant",
    }
    assert "lane smoke: 9 of 9 models as pinned" in output
    (control,) = (line for line in output.splitlines() if line.startswith("neg-step "))
    assert control.split()[:2] == ["neg-step", "counter"]
    assert "Counter.tla: Count == x < Highest /\\ x' = x + 1 " in control
    assert "12 or 13" in control
    assert "as pinned: exit 1" in control
    assert "[9/9]" in output, "progress is lines where there is no terminal"
    exit_code, output, again = project.run("--changed")
    assert exit_code == 0, output
    assert "9 of 9 models are as they were when they came as pinned" in output
    assert again["not run again"] == 9
    assert again["models"] == results["models"]


def test_a_module_that_changes_meanwhile(project: Project, monkeypatch: pytest.MonkeyPatch) -> None:
    """TLC may have read the text of before: the result is not remembered."""
    times = iter(range(100))
    monkeypatch.setattr(unchanged, "written", lambda _: (next(times),))
    assert project.run("counter")[0] == 0
    assert not (project.root / unchanged.PASSED).exists()


def test_the_full_lane_is_remembered_in_the_tree(project: Project) -> None:
    """What came of it stays when the folder of builds is gone."""
    full = project.entry("counter", lane="full")
    project.write({"models": [full, *(one for one in project.document["models"] if one["name"] != "counter")]})
    exit_code, output, _ = project.run("counter")
    assert exit_code == 0, output
    shutil.rmtree(project.root / "build")
    exit_code, output, again = project.run("counter", "--changed")
    assert exit_code == 0, output
    assert again["not run again"] == 1


def test_a_shard_runs_its_part(project: Project) -> None:
    """Nine models in five parts: two models, and the report says which part it was; a part of none is refused."""
    exit_code, output, results = project.run("--shard", "2/5")
    assert exit_code == 0, output
    assert len(results["models"]) == 2
    assert results["lane"] == "smoke, shard 2/5"
    for wrong in ("0/5", "6/5", "2", "2/5/1"):
        exit_code, output, _ = project.run("--shard", wrong)
        assert exit_code == 2
        assert "expected I/N with I from 1 to N" in output


def test_runs_leave_nothing_behind(
    project: Project, monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """TLC's files and trace specifications do not stay in the project, nor in the temporary directory."""
    temporary = tmp_path_factory.mktemp("temporary")
    monkeypatch.setattr(tempfile, "tempdir", str(temporary))

    def files() -> list[Path]:
        return sorted(p for p in project.root.rglob("*") if p.name not in {"results.json", "as-pinned.json"})

    before = files()
    project.run("neg-overshoot", "neg-returns")
    assert files() == before
    assert list(temporary.iterdir()) == []


TWO_STEPS = [{"module": "Counter.tla", "replace": "Highest /\\ x' = x + 1", "by": "Highest /\\ x' = x + 2"}]

DRIFTS: dict[str, tuple[dict[str, Any], str]] = {
    "distinct": ({"expect": {"exit": 0, "states": 6, "distinct": 6, "depth": 5}}, "5 distinct, pinned 6"),
    "depth": ({"expect": {"exit": 0, "states": 6, "distinct": 5, "depth": 4}}, "5 depth, pinned 4"),
    "unpinned": ({"expect": {"exit": 0, "distinct": 5, "depth": 5}}, "states is not pinned, came 6"),
    "too-fast": ({"seconds": [50, 60]}, "is faster than 50 s"),
    "passes": (
        {"base": "counter", "constants": {"Limit": "= 3"}, "expect": {"exit": 12, "property": "InRange"}},
        "passed: no error found",
    ),
    "other-kind": (
        {"base": "counter", "constants": {"Overshoots": "= TRUE"}, "expect": {"exit": 13, "property": "Leaves"}},
        "invariant: Invariant InRange is violated",
    ),
    "other-invariant": (
        {
            "base": "counter",
            "invariants": ["InRange", "NeverAtEnd"],
            "expect": {"exit": 12, "property": "InRange"},
        },
        "violates NeverAtEnd",
    ),
    "other-action": (
        {"base": "counter", "mutate": TWO_STEPS, "expect": {"exit": 13, "property": "Leaves"}},
        "passed: no error found",
    ),
    "model-action": ({"mutate": TWO_STEPS}, "Action property StepByOne is violated"),
    "model-temporal": ({"deadlock": False, "constants": {"StartsOver": "= FALSE"}}, "(Returns)"),
    "deadlock-off": (
        {"base": "counter", "deadlock": False, "constants": {"StartsOver": "= FALSE"}, "expect": {"exit": 11}},
        "temporal: ",
    ),
    "parse-error": (
        {
            "base": "counter",
            "mutate": [{"module": "Counter.tla", "replace": "Init == x = 0", "by": "Init == x ="}],
            "expect": {"exit": 12, "property": "InRange"},
        },
        "broken: error 3002",
    ),
    "evaluation-error": (
        {"base": "counter", "invariants": ["Nonsense"], "expect": {"exit": 12, "property": "Nonsense"}},
        "broken: error 2111",
    ),
    "stale": (
        {
            "base": "counter",
            "mutate": [{"module": "Counter.tla", "replace": "no such text", "by": ""}],
            "expect": {"exit": 12, "property": "InRange"},
        },
        "stale: 'no such text' occurs 0 times in Counter.tla",
    ),
    "stale-twice": (
        {
            "base": "counter",
            "mutate": [{"module": "Counter.tla", "replace": "StartsOver", "by": "TRUE"}],
            "expect": {"exit": 12, "property": "InRange"},
        },
        "stale: 'StartsOver' occurs 2 times in Counter.tla",
    ),
    "no-liveness": (
        {
            "base": "counter",
            "kind": "liveness",
            "what": "Steps.",
            "properties": ["StepByOne"],
            "expect": {"exit": 0, "states": 6, "distinct": 5, "depth": 5},
        },
        "TLC checked no liveness property",
    ),
    "endless": ({"seconds": [0, 2], "lane": "smoke"}, "timeout: killed after 2 s"),
}


@pytest.fixture(scope="module")
def drifted(new_project: Callable[[], Project]) -> tuple[int, str, dict[str, Any]]:
    """One run of a manifest in which every entry but the base drifts."""
    project = new_project()
    document = project.document
    models = [project.entry("counter")]
    for name, (changes, _) in DRIFTS.items():
        if "base" in changes:
            models.append({"name": name, "lane": "smoke", **changes})
        else:
            models.append({**project.entry("endless" if name == "endless" else "counter"), "name": name, **changes})
    # The files of an entry stay named, whether or not it is there.
    project.write({**document, "models": models})
    exit_code, output, results = project.run()
    return exit_code, output, results


@pytest.mark.parametrize("name", DRIFTS)
def test_drift_fails(drifted: tuple[int, str, dict[str, Any]], name: str) -> None:
    """A drift fails the run, and the result says what came."""
    exit_code, output, results = drifted
    assert exit_code == 1, output
    result = next(m for m in results["models"] if m["name"] == name)
    assert result["ok"] is False
    assert DRIFTS[name][1] in " ".join(result["problems"])


def test_drift_says_how_to_see_it(drifted: tuple[int, str, dict[str, Any]]) -> None:
    """A failure has what was expected, the command that runs it alone, the parser's words and the error trace."""
    _, output, results = drifted
    assert next(m for m in results["models"] if m["name"] == "counter")["ok"] is True
    assert "expected  exit 12 (invariant), InRange" in output
    assert "other-invariant -v" in output
    assert "1: <Initial predicate>\nx = 0" in output
    assert "Was expecting" in output or "***Parse Error***" in output


def test_unlisted_file_fails(project: Project) -> None:
    """A configuration or MC module that no entry names fails the run; an exception needs a reason and a match."""
    (project.root / "models" / "MCForgotten.tla").write_text("---- MODULE MCForgotten ----\n====\n")
    (project.root / "models" / "APOther.cfg").write_text("")
    document = project.document
    project.write({**document, "others": {"AP*.cfg": "for another tool", "XX*.cfg": "none"}})
    exit_code, output, results = project.run("neg-overshoot")
    assert exit_code == 1
    assert "MCForgotten.tla: no model of models.txt names it" in output
    assert [line for line in results["drift"] if "APOther" in line] == []
    assert "other: 'XX*.cfg' matches no file" in output
    assert results["ok"] is False


def test_zero_models_fail(project: Project) -> None:
    """A lane without a model checks nothing and fails."""
    document = project.document
    for entry in document["models"]:
        entry["lane"] = "full"
    project.write(document)
    exit_code, output, _ = project.run("--lane", "ci")
    assert exit_code == 1
    assert "nothing was checked" in output


def test_lanes_include_the_lower_ones(project: Project) -> None:
    """Lane full has the models of smoke too."""
    document = project.document
    document["models"] = [m for m in document["models"] if m["name"] in ("neg-overshoot", "counter", "endless")]
    project.write(document)
    _, _, results = project.run("--lane", "full")
    assert {m["name"] for m in results["models"]} == {"counter", "neg-overshoot", "endless"}


@pytest.mark.parametrize("arguments", [("no-such-model",), ("--lane", "nightly"), ("--jobs", "0")])
def test_wrong_arguments_exit_2(project: Project, arguments: tuple[str, ...]) -> None:
    """A name that no model has, a lane that does not exist and zero jobs are wrong arguments."""
    assert project.run(*arguments)[0] == 2


def test_missing_jar_exits_3(project: Project) -> None:
    """Without TLC the exit code is 3 and the text says how to name a jar."""
    project.jar = project.root / "none.jar"
    exit_code, output, _ = project.run()
    assert exit_code == 3
    assert "TLA2TOOLS_JAR" in output


def test_other_file_as_jar_exits_3(project: Project) -> None:
    """A file that is no jar of TLC's is a missing tool, not a drift."""
    project.jar = project.path
    assert project.run()[0] == 3


@pytest.mark.parametrize("said", [None, 'openjdk version "1.8.0_402"'])
def test_missing_or_old_java_exits_3(project: Project, monkeypatch: pytest.MonkeyPatch, said: str | None) -> None:
    """Without Java, and with one that is too old, the exit code is 3."""
    folder = project.root / "home" / "bin"
    folder.mkdir(parents=True)
    if said:
        (folder / "java").write_text(f"#!/bin/sh\necho '{said}' >&2\n")
        (folder / "java").chmod(0o755)
    monkeypatch.setenv("JAVA_HOME", str(folder.parent))
    exit_code, output, _ = project.run()
    assert exit_code == 3
    assert "java" in output


def test_update_pins_counts_only(project: Project) -> None:
    """--update sets counts of what is else as pinned, says so, leaves the rest alone, and the next run passes."""
    document = project.document
    counter = project.entry("counter", expect={"exit": 0, "states": 1})
    wrong = {"name": "wrong", "base": "counter", "constants": {"Limit": "= 3"}, "expect": {"exit": 11, "states": 4}}
    document["models"] = [counter, project.entry("neg-overshoot"), project.entry("endless"), wrong]
    document["models"][1]["expect"]["distinct"] = 9
    project.write(document)
    exit_code, output, _ = project.run("--update")
    assert exit_code == 1, "the wrong exit is still wrong"
    assert "counter: states 1 -> 6" in output
    assert "counter: depth not pinned -> 5" in output
    assert "neg-overshoot: distinct 9 -> 6" in output
    pinned = {m["name"]: m["expect"] for m in project.document["models"]}
    assert pinned["counter"] == {"exit": 0, "states": 6, "distinct": 5, "depth": 5}
    assert pinned["wrong"] == wrong["expect"]
    assert project.run("counter", "neg-overshoot")[0] == 0


def test_update_pins_each_model_as_it_comes(project: Project, monkeypatch: pytest.MonkeyPatch) -> None:
    """A run that is stopped behind its first model has pinned that one."""

    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    document = project.document
    document["models"] = [project.entry(name) for name in ("counter", "neg-overshoot")]
    for entry in document["models"]:
        entry["expect"]["distinct"] = 99
    project.write(document)
    monkeypatch.setattr(unchanged, "keep", stop)
    assert project.run("--update")[0] == 130
    assert sorted(m["expect"]["distinct"] == 99 for m in project.document["models"]) == [False, True]


def test_interrupt_leaves_no_java(project: Project) -> None:
    """Ctrl-C ends the harness with 130, all its Java processes and their files."""
    document = project.document
    document["models"] = [project.entry("endless", seconds=[0, 300]), project.entry("counter")]
    project.write(document)
    temporary = project.root / "tmp"
    temporary.mkdir()
    command = [sys.executable, "-m", "evidence", "models", "--manifest", str(project.path), "--tlc", str(project.jar)]
    environment = {**os.environ, "TMPDIR": str(temporary), "PYTHONPATH": str(Path(canaries.__file__).parents[2])}
    with subprocess.Popen(
        [*command, "endless"], env=environment, stderr=subprocess.PIPE, text=True, preexec_fn=heed_ctrl_c
    ) as harness:
        assert _until(lambda: bool(_java_of(temporary))), "TLC did not start"
        harness.send_signal(signal.SIGINT)
        assert harness.stderr is not None
        assert "interrupted" in harness.stderr.read()
        assert harness.wait(timeout=20) == 130
    assert _until(lambda: not _java_of(temporary)), "a java is left behind"
    assert list(temporary.iterdir()) == []


def _java_of(temporary: Path) -> list[str]:
    """Return the processes whose command line names this directory."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            line = (process / "cmdline").read_bytes().decode(errors="replace")
        except OSError:
            continue
        if str(temporary) in line:
            found.append(process.name)
    return found


def _until(condition: Callable[[], bool], seconds: float = 20) -> bool:
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(0.1)
    return False


def test_canaries_answer_and_are_kept(asked: tuple[Path, canaries.Answers]) -> None:
    """Each canary has an answer for this jar, and the answers are kept so that they are not asked for twice."""
    build, answers = asked
    assert {canary.issue for canary in canaries.CANARIES} == {1302, 971, 525}
    assert set(answers.answers.values()) <= {"present", "absent"}
    kept = list(build.glob("tlc-canaries-*.json"))
    assert len(kept) == 1
    if answers.version.startswith("2.18"):
        assert answers.answers == {
            "CanaryLazyExcept": "present",
            "CanaryTwoWorkers": "present",
            "CanaryFormula": "present",
        }


def test_canaries_never_fail_a_run(project: Project, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the canaries' files the answers are "unknown", nothing is kept, and the run goes on."""
    for kept in (project.root / "build").iterdir():
        kept.write_text('{"version": "2.18", "answers": {}}')
    monkeypatch.setattr(canaries, "_ask", lambda *_: ("unknown", ""))
    exit_code, output, results = project.run("counter")
    assert exit_code == 0, output
    assert {c["state"] for c in results["canaries"].values()} == {"unknown"}
