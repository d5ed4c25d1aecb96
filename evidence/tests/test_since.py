"""``s7spec since``: two revisions of a small project, whose command reads its verdict in the log."""

import json
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from evidence.common.cases import Case
from evidence.common.checkout import ROOT
from evidence.logs import since_command as command
from evidence.logs.revision import Checkout
from evidence.logs.since_command import since_command

S7CHECK = """#!/usr/bin/env python3
import json, sys
output, *logs = sys.argv[sys.argv.index("--output") + 1:]
with open(output, "w") as file:
    for log in logs:
        verdict, line, *ids = json.loads(open(log).read().splitlines()[-1])["x_said"].split()
        report = {"verdict": verdict.replace("_", " "), "line": int(line) or None, "requirements": ids, "message": "so"}
        print(json.dumps(report), file=file)
"""
TEXT = "traces/TINT.txt"


def case(name: str, verdict: str, said: str, second: int) -> str:
    """A case of which the command says this; the reader passes over the field x_said."""
    fields = {"event": "run", "at": f"2026-03-02T06:00:0{second}", "x_said": said}
    return f"== {name} {verdict} TINT-01\n# Why.\n0:00 hold\n| {json.dumps(fields)}\n"


CASES = "cpu=S7-300 obs=1 clock=2026-03-02T06:00:00\n" + case("one", "A", "accepted 0", 1)
CASES += case("two", "R3", "rejected 3 TINT-01", 2)
MODELS = "== airt model smoke MCAirt.tla 0\nstates 7\n\n== neg airt 12\n"
OLDER = {"models": [{"name": "airt", "expect": {"exit": 0, "states": 7}}, {"name": "neg", "expect": {"exit": 12}}]}
"""The same as JSON, as older revisions have it."""
SURVIVORS = [{"id": "A/B/constant/01", "reason": "Out of reach."}, {"id": "A/C/constant/02", "reason": "As good."}]

Since = Callable[..., tuple[int, str]]


def git(root: Path, *arguments: str) -> None:
    """Run git as somebody."""
    who = ["-c", "user.name=Somebody", "-c", "user.email=somebody@example.org", "-c", "commit.gpgsign=false"]
    subprocess.run(["git", "-C", str(root), *who, *arguments], check=True, capture_output=True)


def write(path: Path, content: Any) -> None:
    """Write a text, or JSON."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A project with two logs, two models and two reasons, committed, and built in its own folder."""
    root = tmp_path / "project"
    write(root / "Makefile", "setup:\n\tmkdir -p .venv/bin\n\tcp s7check .venv/bin/\n\tchmod +x .venv/bin/s7check\n")
    write(root / "s7check", S7CHECK)
    write(root / ".gitignore", "/build/\n/.venv/\n")
    write(root / "traces" / "TINT.txt", CASES)
    write(root / "models" / "models.txt", MODELS)
    write(root / "models" / "survivors.json", SURVIVORS)
    write(root / "models" / "witnesses.json", [])
    git(root, "init", "--initial-branch", "main")
    git(root, "add", ".")
    git(root, "commit", "--message", "First")
    subprocess.run(["make", "setup"], cwd=root, check=True, capture_output=True)
    monkeypatch.setattr(command, "ROOT", root)
    return root


@pytest.fixture
def since(project: Path) -> Since:
    """The command without random logs: its exit code and all that it says."""

    def run(*arguments: str) -> tuple[int, str]:
        ran = CliRunner().invoke(since_command, ["--logs", "0", *(arguments or ["main"])])
        return ran.exit_code, ran.output

    return run


def test_nothing_differs(since: Since, project: Path) -> None:
    """Also not if a log and a model are new, and a log has another name."""
    text = CASES.replace("== one", "== uno") + case("new", "A", "accepted 0", 3)
    write(project / "traces" / "TINT.txt", text)
    write(project / "models" / "models.txt", f"{MODELS}\n== dint airt 11\n")
    code, said = since()
    assert code == 0, said
    assert "no unexpected difference" in said
    assert [line.split() for line in said.splitlines() if line.startswith(("cases", "logs", "models"))] == [
        ["cases", "with", "the", "same", "events", "and", "words", "2", "1", "0", "0", "1"],
        ["logs", "of", "cases", "2", "1", "0", "0", "1"],
        ["models", "and", "negative", "controls,", "pinned", "2", "0", "0", "0", "1"],
    ]


@pytest.mark.parametrize(
    ("file", "content", "difference"),
    [
        (TEXT, CASES.replace("accepted 0", "rejected 2"), "log/TINT/one: accepted; now rejected at line 2: so"),
        (TEXT, CASES.replace("rejected 3", "rejected 4"), "rejected at line 3; now rejected at line 4: so"),
        (TEXT, CASES.replace("rejected 3", "no_verdict 0"), "rejected at line 3; now no verdict: so"),
        (TEXT, CASES.replace("06:00:01", "06:00:09"), "case/TINT/one: its log has other events"),
        ("models/models.txt", MODELS.partition("\n\n")[0], "model/neg: exit 12; the model is gone"),
        ("models/models.txt", MODELS.replace("states 7", "states 8"), "exit 0, states 7; now exit 0, states 8"),
        ("models/survivors.json", SURVIVORS[:1], "survivor/A/C/constant/02: gone: As good."),
    ],
)
def test_a_difference(since: Since, project: Path, file: str, content: Any, difference: str) -> None:
    """Each is named, and fails the command unless it is expected."""
    write(project / file, content)
    code, said = since()
    assert code == 1
    assert difference in said
    assert "UNEXPECTED" in said
    expected = project / "expected.json"
    write(expected, [{"id": "*", "reason": "Wanted."}])
    code, said = since("main", "--expected", str(expected))
    assert code == 0, said
    assert "(Wanted.)" in said


def test_a_log_that_is_gone(since: Since, project: Path) -> None:
    """It is not passed over."""
    write(project / TEXT, CASES.partition("== two")[0].replace("06:00:01", "06:00:09").replace("one", "other"))
    code, said = since()
    assert code == 1
    assert "log/TINT/one: accepted; the log is gone" in said


def test_no_verdict_is_none(since: Since, project: Path) -> None:
    """Two checkers that fail alike do not agree."""
    write(project / TEXT, CASES.replace("accepted 0", "no_verdict 0"))
    git(project, "commit", "--all", "--message", "Second")
    code, said = since()
    assert code == 1
    assert "log/TINT/one: no verdict: so" in said


def test_notes(since: Since, project: Path) -> None:
    """Other requirements, a reason that moved with its text, and an expectation that nothing meets are no failures."""
    write(project / TEXT, CASES.replace("rejected 3 TINT-01", "rejected 3 TINT-02").replace("# Why.", "# Because."))
    write(project / "models" / "survivors.json", [SURVIVORS[0], SURVIVORS[1] | {"id": "A/D/constant/03"}])
    write(project / "expected.json", [{"id": "model/*", "reason": "Perhaps."}])
    code, said = since("main", "--expected", str(project / "expected.json"))
    assert code == 0, said
    assert "note: log/TINT/two: requirements TINT-01; now TINT-02" in said
    assert "note: case/TINT/two: another reason" in said
    assert "note: survivor/A/C/constant/02: now A/D/constant/03" in said
    assert "note: model/*: expected to differ, and nothing does" in said


def test_json(since: Since, project: Path, tmp_path: Path) -> None:
    """The same for programs."""
    write(project / TEXT, CASES.replace("accepted 0", "rejected 2"))
    assert since("main", "--json", str(tmp_path / "out.json"))[0] == 1
    document = json.loads((tmp_path / "out.json").read_text(encoding="utf-8"))
    assert document["ok"] is False
    assert [one["differences"][0]["id"] for one in document["compared"] if one["differences"]] == ["log/TINT/one"]


def test_wrong_arguments_and_failures(since: Since, project: Path) -> None:
    """A revision that is none, a manifest that is none, and a checkout that cannot be built or run."""
    assert since("nothing-of-the-kind") == (2, f"Error: nothing-of-the-kind: {NO_REVISION.format(project)}\n")
    write(project / "models" / "models.txt", "[]")
    code, said = since()
    assert code == 2
    assert f"Error: {project}/models/models.txt:1: " in said
    write(project / "models" / "manifest.json", "[]")
    assert f"Error: {project}/models/manifest.json: " in since()[1]
    write(project / "models" / "manifest.json", OLDER)
    assert since()[0] == 0
    (project / "models" / "manifest.json").unlink()
    write(project / ".venv" / "bin" / "s7check", "#!/bin/sh\necho no Java >&2; exit 3\n")
    code, said = since()
    assert code == 3
    assert "reported about 0 of 2 logs (exit code 3): no Java" in said
    write(project / "Makefile", "setup:\n\techo no Maven >&2; exit 1\n")
    git(project, "commit", "--all", "--message", "Second")
    code, said = since()
    assert code == 3
    assert "ended with exit code 2: no Maven" in said


NO_REVISION = "no such revision in {}: name a commit, a tag or a branch that is fetched"


def test_random_logs() -> None:
    """Both checkers get the same ones; here both are this checkout's."""
    this = Checkout(ROOT)
    found = command._random(this, this, 8, 1, lambda _: None)
    assert found.same + len(found.undecided) == 8
    assert found.same > 0
    assert found.differences == []


def test_a_revision_with_a_file_for_each_log(tmp_path: Path) -> None:
    """Verdict, line, requirements and reason stand in the index of an area."""
    entry = {
        "file": "reject/two.ndjson.gz",
        "verdict": "rejected",
        "line": 3,
        "requirements": ["TINT-01"],
        "reason": "No.",
    }
    write(tmp_path / "traces" / "TINT" / "index.json", [entry])
    write(tmp_path / "traces" / "TINT" / "reject" / "two.ndjson.gz", "log")
    (found,) = Checkout(tmp_path).cases()
    assert found == Case("TINT", "two", "rejected", 3, ["TINT-01"], "No.", b"log", packed=True)
    assert found.file == "TINT/reject/two.ndjson.gz"
