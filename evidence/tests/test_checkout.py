"""Which checkout ``s7spec`` works on: the one around the current folder, and only if it is its own."""

from pathlib import Path

import pytest

from evidence.cli import main
from evidence.common.checkout import ROOT


def test_a_folder_of_the_checkout(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """It need not be the root."""
    monkeypatch.chdir(ROOT / "docs" / "rules")
    assert main(["prove", "--list", "series-steps"]) == 0
    assert capsys.readouterr().out.startswith("series-steps: ")


@pytest.mark.parametrize("command", [["models"], ["prove", "--list"], ["kit", "paths"]])
def test_no_checkout(
    command: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Every command says the same."""
    monkeypatch.chdir(tmp_path)
    assert main(command) == 2
    said = f"{tmp_path} is in no checkout, but this s7spec checks {ROOT}"
    assert said in capsys.readouterr().err.replace("\n", " ")


def test_another_checkout(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """A work tree below this checkout is not this checkout."""
    other = tmp_path / "evidence" / "cli.py"
    other.parent.mkdir(parents=True)
    other.touch()
    (tmp_path / "spec").mkdir()
    monkeypatch.chdir(tmp_path / "spec")
    assert main(["models"]) == 2
    assert f"in the checkout {tmp_path}, but this s7spec checks {ROOT}" in capsys.readouterr().err.replace("\n", " ")
