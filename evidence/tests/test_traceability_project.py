"""``s7check requirements`` over this project."""

from pathlib import Path

import pytest

from s7check import cli

PROJECT = Path(cli.__file__).parents[2]


def test_this_project(capsys: pytest.CaptureFixture[str]) -> None:
    """Nothing is missing, and the pages are up to date."""
    code = cli.main(["requirements", "--project", str(PROJECT)])
    assert code == 0, capsys.readouterr()
