"""`s7spec kit faults`: the kit against deliberate faults."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from evidence.common.checkout import SOFT_PLC
from evidence.kit.faults_command import HELD_OUT, faults_command

CHANGES = json.loads((HELD_OUT / "changes.json").read_text(encoding="utf-8"))


def test_a_fault_of_each_kind_is_found(tmp_path: Path) -> None:
    """One that the soft PLC offers, one that is held out; the report says by which program."""
    report = tmp_path / "report.json"
    result = CliRunner().invoke(faults_command, ["airt-flag", "airt-count-from-0", "--json", str(report)])
    assert result.exit_code == 0, result.output
    assert "2 of 2 faults found; of 1 held out 1" in result.output
    first, second = json.loads(report.read_text())["faults"]
    assert first["program"]
    assert not first["held_out"]
    assert "AIRT-06" in second["requirements"]


def test_an_unknown_fault_is_told() -> None:
    """By its name, with exit code 2."""
    result = CliRunner().invoke(faults_command, ["no-such-fault"])
    assert result.exit_code == 2
    assert "no such fault: no-such-fault" in result.output


@pytest.mark.parametrize("change", CHANGES, ids=lambda change: change["name"])
def test_each_held_out_fault_changes_one_place(change: dict[str, str]) -> None:
    """Its old text occurs once in its file, and the new one is another."""
    text = (SOFT_PLC / "s7cpu" / change["file"]).read_text(encoding="utf-8")
    assert text.count(change["old"]) == 1
    assert change["new"] != change["old"]
    assert change["text"].endswith("]")


def test_at_least_forty_are_held_out() -> None:
    """Each with a name of its own."""
    assert len({change["name"] for change in CHANGES}) == len(CHANGES) >= 40
