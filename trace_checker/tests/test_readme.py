"""The example of the README is run as it stands there."""

import re
from pathlib import Path

import pytest

from s7check.cli import main

README = Path(__file__).resolve().parents[2] / "README.md"


def test_the_log_of_the_readme_gets_the_verdict_of_the_readme(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The README shows a log of a few lines, the command and the beginning of its output."""
    text = README.read_text(encoding="utf-8")
    log = re.search(r"```json\n(.*?)```", text, re.DOTALL)
    session = re.search(r"\$ s7check trace log\.ndjson\n(.*?)```", text, re.DOTALL)
    assert log is not None
    assert session is not None
    (tmp_path / "log.ndjson").write_text(log[1], encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert main(["trace", "log.ndjson"]) == 1
    assert capsys.readouterr().out.startswith(session[1])
    assert len((log[1] + session[1]).splitlines()) <= 10, "a log, checked in ten lines"
