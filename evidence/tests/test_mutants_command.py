"""``s7spec mutants`` with TLC on a specification of its own, and the shipped logs with the engine."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest

from evidence.common.cases import all_cases
from evidence.mutants import against_logs as logs
from evidence.mutants import mutants_command as command
from evidence.mutants.mutants_command import mutants_command
from evidence.tests.lamp import run_command, write_lamp
from evidence.tests.test_mutants_bench import TEXT, FakeCheck
from s7check.engine.command import EngineError, jvm_command

ROOT = Path(__file__).parents[2]

SPEC = r"""---- MODULE Lamp ----
\* A lamp that is on for a while.
EXTENDS Integers
VARIABLE left
Full == 2
Init == left = 0
On == left = 0 /\ left' = Full
Burn == left > 0 /\ left' = left - 1
Dim == IF left > Full THEN left' = 7 ELSE Burn
Next == On \/ Dim
Spec == Init /\ [][Next]_left
====
"""
MODEL = """---- MODULE MCLamp ----
EXTENDS Lamp
InRange == left \\in 0..2
====
"""


@pytest.fixture
def lamp(tmp_path: Path) -> Path:
    """Make a small project."""
    files = {
        "spec/Lamp.tla": SPEC,
        "models/MCLamp.tla": MODEL,
        "models/MCLamp.cfg": "SPECIFICATION Spec\nINVARIANT InRange\n",
    }
    return write_lamp(tmp_path, files, states=4, distinct=3, depth=3)


def run(lamp: Path, *arguments: str) -> tuple[int, str, dict[str, Any]]:
    """Run the command; return exit code, output and results."""
    return run_command(mutants_command, lamp, *arguments)


def test_mutants_with_tlc(lamp: Path) -> None:
    """Kills of several kinds, a survivor and its reason, a second run, an unsound baseline."""
    chosen = ["Lamp/On/unchanged/*", "Lamp/Burn/arithmetic/*", "Lamp/Dim/*", "Lamp/Burn/drop-conjunct/*"]
    code, output, document = run(lamp, "--jobs", "1", *chosen)
    assert code == 1
    came = {f"{m['was']} -> {m['by']}": (m["how"], m["detail"]) for m in document["mutants"]}
    assert came["left - 1 -> left + 1"] == ("property", "InRange")
    assert came["left > 0 -> TRUE"][0] == "property"
    assert came["left ' = Full -> left ' = left"][0] == "count"
    assert came["left > Full -> left <= Full"] == ("property", "InRange")
    assert came["7 -> 8"] == ("survived", "")
    assert next(m for m in document["mutants"] if m["was"] == "7")["got_past"] == []
    assert "no check evaluates it" in output
    assert "NO REASON" in output

    code, output, alone = run(lamp, "--jobs", "1", "--against", "properties", *chosen)
    assert code == 0
    assert {m["how"] for m in alone["mutants"]} == {"property", "survived"}
    assert alone["all"]["counted"] == alone["all"]["mutants"] - alone["all"]["unevaluated"]
    assert alone["all"]["unevaluated"] == sum(not m["got_past"] and m["how"] == "survived" for m in alone["mutants"])
    assert alone["all"]["killed"] == sum(m["how"] == "property" for m in document["mutants"])
    assert "score by properties alone" in output

    (lamp / "models" / "survivors.json").write_text('[{"id": "Lamp/Dim/*", "reason": "never", "equivalent": true}]')
    code, output, again = run(lamp, "--jobs", "1", *chosen)
    assert (code, again["all"]["score"]) == (0, 1.0)
    assert [m["how"] for m in again["mutants"]] == [m["how"] for m in document["mutants"]]

    (lamp / "spec" / "Lamp.tla").write_text(SPEC.replace("Full == 2", "Full == 3"))
    code, output, _ = run(lamp, *chosen)
    assert code == 3
    assert "the unchanged specification does not pass lamp: property: InRange" in output


def test_lists_and_samples(lamp: Path) -> None:
    """Lists are deterministic, samples depend on the seed alone."""
    code, everything, _ = run(lamp, "--list")
    assert code == 0
    ids = [line.split()[0] for line in everything.splitlines() if line.startswith("Lamp/")]
    assert not any(i.startswith("Lamp/Spec/") for i in ids)
    samples = [
        {line.split()[0] for line in run(lamp, "--list", "--sample", "5", "--seed", seed)[1].splitlines()} & set(ids)
        for seed in ("1", "1", "2")
    ]
    assert samples[0] == samples[1] != samples[2]
    assert len(samples[0]) == 5
    assert "-Full == 2\n+Full == 3" in run(lamp, "--diff", "Lamp/Full/*")[1]


def test_models_see_what_the_logs_leave(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The second stage is not even calibrated where the first one has noticed everything."""
    for folder in ("spec", "models"):
        (tmp_path / folder).mkdir()
    (tmp_path / "spec" / "M.tla").write_text(TEXT)
    (tmp_path / "models" / "models.txt").touch()
    (tmp_path / "models" / "survivors.json").write_text('[{"id": "M/B/*", "reason": "not asked here"}]')
    quick, slow = FakeCheck("logs", {"x - 1": "log"}), FakeCheck("model", {"x + 2": "property", "x + 0": "property"})
    monkeypatch.setattr(command, "_stages", lambda *_: [[quick], [slow]])
    code, _, document = run(tmp_path, "M/A/arithmetic/*")
    assert (code, document["all"]["killed"], slow.ran) == (0, 1, [])
    code, _, document = run(tmp_path, "M/A/*")
    assert (code, document["all"]["killed"]) == (0, 3)
    assert {m["by"]: m["check"] for m in document["mutants"]} == {"x - 1": "logs", "2": "model", "0": "model"}
    assert len(slow.ran) == 3, "the unchanged specification, and what the logs have left"
    ran = len(quick.ran)
    assert run(tmp_path, "M/A/*", "--fresh")[0] == 0
    assert len(quick.ran) == ran + 4


def test_survivors_with_a_reason_are_not_tried_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """With --explained the models are asked about the others only."""
    for folder in ("spec", "models"):
        (tmp_path / folder).mkdir()
    (tmp_path / "spec" / "M.tla").write_text(TEXT)
    (tmp_path / "models" / "models.txt").touch()
    (tmp_path / "models" / "survivors.json").write_text('[{"id": "M/A/*", "reason": "nothing differs"}]')
    quick, slow = FakeCheck("logs", {}), FakeCheck("model", {"x + 2": "property"})
    monkeypatch.setattr(command, "_stages", lambda *_: [[quick], [slow]])
    code, _, document = run(tmp_path, "--explained", "M/A/*")
    assert (code, document["all"]["killed"], slow.ran) == (0, 0, [])
    (tmp_path / "models" / "survivors.json").unlink()
    code, _, document = run(tmp_path, "--explained", "M/A/*")
    assert (code, document["all"]["killed"]) == (1, 1)


@pytest.fixture
def copy(tmp_path: Path) -> Path:
    """Copy the specification."""
    try:
        jvm_command()
    except EngineError as missing:
        pytest.skip(str(missing))
    shutil.copytree(ROOT / "spec", tmp_path / "spec")
    return tmp_path / "spec"


@pytest.mark.parametrize(("by", "how"), [("{count + 2}", {"log", "error"}), ("{nothing}", {"invalid"})])
def test_mutants_with_the_shipped_logs(copy: Path, tmp_path: Path, by: str, how: set[str]) -> None:
    """A wrong answer is noticed by a log; an unknown name is no specification."""
    airt = copy / "rules" / "Airt.tla"
    text = airt.read_text()
    assert "{count + 1}" in text
    airt.write_text(text.replace("{count + 1}", by))
    cases = [case for case in all_cases() if case.area == "AIRT"]
    judged = logs.judge(copy, logs.keep(cases, tmp_path / "cases.json"))
    assert judged.how in how
    assert judged.detail


def test_an_engine_that_is_killed_shows_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It says nothing about the mutant."""
    java = tmp_path / "java"
    java.write_text("#!/bin/sh\nkill -KILL $$\n")
    java.chmod(0o755)
    monkeypatch.setattr(logs, "jvm_command", lambda *_: [str(java), ""])
    with pytest.raises(EngineError, match="SIGKILL"):
        logs.judge(ROOT / "spec", logs.keep(all_cases()[:1], tmp_path / "cases.json"))
