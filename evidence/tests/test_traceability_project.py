"""``s7spec views requirements`` over this project."""

import pytest

from evidence import cli


def test_this_project(capsys: pytest.CaptureFixture[str]) -> None:
    """Nothing is missing, and the pages are up to date."""
    code = cli.main(["views", "requirements"])
    assert code == 0, capsys.readouterr()
