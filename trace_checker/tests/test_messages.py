"""What a newcomer reads who gives a command the wrong file: the file, the line, what was expected."""

from pathlib import Path

import pytest

from s7check import cli

TWO_SIDES = ["--cpu", "S7-300", "--cpu", "S7-400"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["decide", "absent"], "absent: expected a file of logs; found none"),
        (["explain", "absent"], "absent: unusable: expected a log that can be opened; found no such file or directory"),
        (["explain", "text"], "text:1: unusable: expected a JSON object; found hello at byte 1"),
        (["compare", "text", *TWO_SIDES], "text:1: unusable: expected a JSON object; found hello at byte 1"),
        (["simulate", "absent"], "absent: expected a file that can be read; found No such file or directory"),
        (["coverage", "absent"], "absent: unusable (`s7check trace` says why)"),
        (["kit", "matrix", "absent"], "expected NAME=FILE, such as plc=results.json; found absent"),
        (["kit", "matrix", "plc=absent"], "absent: expected a result of `s7check kit run`; found No such file or"),
        (["import", "text", "--cpu", "S7-300", "--obs", "1"], "SOURCE does not show what it is: expected the text of"),
    ],
)
def test_wrong_file(
    arguments: list[str],
    said: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """One message on standard error, exit code 2."""
    monkeypatch.chdir(tmp_path)
    Path("text").write_text("hello\n")
    assert cli.main(arguments) == 2
    assert said in capsys.readouterr().err
