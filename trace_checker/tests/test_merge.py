"""``s7check merge``."""

import json
from pathlib import Path

import pytest

from s7check import cli


def report(log: str, verdict: str, events: int, *requirements: str) -> str:
    """A line of a report."""
    return json.dumps({"log": log, "verdict": verdict, "events": events, "requirements": requirements, "line": None})


def test_merge(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Sums over all files; the reports as they were, in their order."""
    first = [report("a", "accepted", 7), report("b", "rejected", 5, "TINT-14", "TINT-19")]
    second = [report("c", "rejected", 3, "TINT-14"), "", report("a", "unusable", 0)]
    (tmp_path / "1.json").write_text("\n".join(first) + "\n")
    (tmp_path / "2.json").write_text("\n".join(second))
    assert cli.main(["merge", str(tmp_path / "1.json"), str(tmp_path / "2.json")]) == 2
    merged = json.loads(capsys.readouterr().out)
    assert merged["sums"] == {
        "logs": 4,
        "accepted": 1,
        "rejected": 2,
        "unusable": 1,
        "no verdict": 0,
        "events": 15,
        "requirements": {"TINT-14": 2, "TINT-19": 1},
    }
    assert merged["reports"] == [json.loads(line) for line in first + second if line]


def test_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """With --output nothing goes to standard output; no logs are no fault."""
    (tmp_path / "1.json").touch()
    assert cli.main(["merge", "--output", str(tmp_path / "all.json"), str(tmp_path / "1.json")]) == 0
    assert capsys.readouterr().out == ""
    assert json.loads((tmp_path / "all.json").read_text())["sums"]["logs"] == 0


@pytest.mark.parametrize("line", ["{", "[]", '{"log": "a", "verdict": "fine", "events": 1}', '{"log": "a"}', "\x80"])
def test_no_report(line: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A file that is something else is named with the line."""
    file = tmp_path / "1.json"
    file.write_text(report("a", "accepted", 1) + "\n" + line)
    assert cli.main(["merge", str(file)]) == 2
    assert f"{file}:2: expected the report about a log" in capsys.readouterr().err
