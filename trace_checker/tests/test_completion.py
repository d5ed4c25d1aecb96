"""Completion in the shell, by click's protocol; bash itself where it is there."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from s7check import cli


def asked(shell: str, typed: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> list[str]:
    """What ``shell`` is answered when the cursor stands at the end of ``typed``."""
    words = typed.split(" ")
    monkeypatch.setenv("_S7CHECK_COMPLETE", f"{shell}_complete")
    monkeypatch.setenv("COMP_WORDS", typed)
    # fish says which word it is about, the others say how many come before it.
    monkeypatch.setenv("COMP_CWORD", words[-1] if shell == "fish" else str(len(words) - 1))
    with pytest.raises(SystemExit):
        cli.main([])
    return capsys.readouterr().out.split()


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
@pytest.mark.parametrize(
    ("typed", "offered"),
    [("s7check tr", "trace"), ("s7check trace --format sa", "sarif"), ("s7check trace --out", "--output")],
)
def test_names(
    shell: str, typed: str, offered: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Commands, options and their values."""
    assert any(offered in line.split(",")[-1] for line in asked(shell, typed, monkeypatch, capsys))


@pytest.mark.parametrize("typed", ["s7check trace lo", "s7check import lo", "s7check trace --output lo"])
def test_files(typed: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """Where a file is meant the shell completes its name."""
    assert asked("bash", typed, monkeypatch, capsys) == ["file,lo"]


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_script(shell: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """The script that the shell reads at its start."""
    if shell == "bash" and shutil.which("bash") is None:
        pytest.skip("click asks bash for its version")
    monkeypatch.setenv("_S7CHECK_COMPLETE", f"{shell}_source")
    with pytest.raises(SystemExit) as ended:
        cli.main([])
    assert ended.value.code == 0
    assert f"{shell}_complete" in capsys.readouterr().out


@pytest.mark.skipif(shutil.which("bash") is None, reason="bash is not there")
def test_bash(tmp_path: Path) -> None:
    """As docs/checking/commands.md says it: bash reads the script, then completes."""
    (tmp_path / "s7check").write_text(f'#!/bin/sh\nexec {sys.executable} -m s7check "$@"\n', encoding="utf-8")
    (tmp_path / "s7check").chmod(0o755)
    script = (
        f'PATH="{tmp_path}:$PATH"; eval "$(_S7CHECK_COMPLETE=bash_source s7check)"; complete -p s7check; '
        'COMP_WORDS=(s7check impo) COMP_CWORD=1; _s7check_completion s7check; echo "${COMPREPLY[@]}"'
    )
    project = Path(cli.__file__).parents[2]
    run = subprocess.run(["bash", "-c", script], cwd=project, capture_output=True, text=True, check=False)
    assert run.stdout.splitlines() == ["complete -o nosort -F _s7check_completion s7check", "import"], run.stderr
