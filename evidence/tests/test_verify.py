"""The steps of ``s7spec verify`` that ask other programs: what they say where something is missing or fails."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from evidence import verify


@pytest.fixture
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty project."""
    plc = tmp_path / "plc"
    paths = {"ROOT": tmp_path, "BUILD": tmp_path / "verify", "SOFT_PLC": plc}
    for name, path in (paths | {"SOFT_PLC_PROGRAM": plc / "build" / "soft_plc"}).items():
        monkeypatch.setattr(verify, name, path)
    (tmp_path / "verify").mkdir()
    return tmp_path


def script(path: Path, text: str) -> None:
    """Write a program."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)


def test_models_left_out_are_shown_as_not_run(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The table has their row, without a result."""
    monkeypatch.setattr(verify, "STEPS", {})
    ran = CliRunner().invoke(verify.verify_command, ["--without-models"], standalone_mode=False)
    assert ran.return_value == 0
    assert "not run" in ran.output
    assert not (root / "verify" / "models.json").exists()


def test_no_scenarios(root: Path) -> None:
    """Where nothing is run nothing is ok."""
    rows = verify._soft_plc()
    assert [row.result for row in rows] == ["FAILED", "FAILED"]
    assert rows[0].failures == ["plc/scenarios has no scenario for it"]


def test_a_soft_plc_that_fails(root: Path) -> None:
    """The log of an earlier run is not taken for that of this one."""
    script(root / "plc" / "build" / "soft_plc", "echo 'no such thing' >&2; exit 2")
    for name in ("some", "real_time"):
        scenario = root / "plc" / "scenarios" / f"{name}.json"
        scenario.parent.mkdir(exist_ok=True)
        scenario.touch()
        (root / "verify" / f"{name}.ndjson").touch()
    rows = verify._soft_plc()
    named = [[f"soft_plc {name}.json: no such thing"] for name in ("some", "real_time")]
    assert [row.failures for row in rows] == named
    assert list((root / "verify").iterdir()) == []


@pytest.mark.parametrize(
    ("text", "code", "results", "reasons"),
    [
        ("echo 'not run: none' >&2; exit 3", 0, ["not run"] * 3, ["not run: none", *["apalache-mc was not found"] * 2]),
        ("echo typecheck A; echo typecheck B", 0, ["ok", "ok", "not run"], ["2 modules", "1 queries, 9 cond", "make"]),
        ("exit 1", 1, ["FAILED", "FAILED", "not run"], ["0 modules, what they extend", "1 queries", "make apalache"]),
    ],
)
def test_apalache(
    root: Path, monkeypatch: pytest.MonkeyPatch, text: str, code: int, results: list[str], reasons: list[str]
) -> None:
    """Whether it is there the script says, for all rows; the proofs are judged by the exit code of their command."""
    script(root / "models" / "apalache.sh", text)
    run = subprocess.run

    def prove(command: list[str], **options: Any) -> subprocess.CompletedProcess[str]:
        if "prove" not in command:
            return run(command, **options)
        Path(command[-1]).write_text(json.dumps({"queries": [{"conditions": 9}]}))
        return subprocess.CompletedProcess(command, code)

    monkeypatch.setattr(subprocess, "run", prove)
    rows = verify._apalache()
    assert [row.result for row in rows] == results
    assert all(row.size.startswith(reason) for row, reason in zip(rows, reasons, strict=False))


@pytest.mark.parametrize(("code", "result"), [(0, "ok"), (1, "FAILED")])
def test_mutants(root: Path, monkeypatch: pytest.MonkeyPatch, code: int, result: str) -> None:
    """The numbers are those of the report; a survivor without a reason fails."""

    def run(command: list[str], **_: Any) -> subprocess.CompletedProcess[str]:
        assert "--fresh" in command, "what an earlier run found proves nothing"
        Path(command[-1]).write_text(json.dumps({"all": {"mutants": 12, "killed": 12 - code}}))
        return subprocess.CompletedProcess(command, code)

    monkeypatch.setattr(subprocess, "run", run)
    (row,) = verify._mutants()
    assert (row.result, row.size) == (result, f"12 mutants, {12 - code} killed")


def test_mutants_that_cannot_be_judged(root: Path) -> None:
    """No results are a failure."""
    (row,) = verify._mutants()
    assert (row.result, row.size) == ("FAILED", "")
