"""The progress of long logs."""

import io
import sys
from pathlib import Path

import pytest

from s7check.log.source import open_log
from s7check.report import progress


class Terminal(io.StringIO):
    """Standard error as a terminal."""

    def isatty(self) -> bool:
        """Claim to be one."""
        return True


def show(log: Path, logs: int = 1) -> str:
    """What reaches standard error when half a log has been read."""
    with open_log(str(log)) as source, progress.ProgressBar(logs) as line:
        line.begin(log.name)
        source.taken = 50
        line.update(source, 1234)
        line.update(source, 1235)
    stream = sys.stderr
    assert isinstance(stream, io.StringIO)
    return stream.getvalue()


@pytest.fixture
def log(tmp_path: Path) -> Path:
    """A file of a hundred bytes."""
    path = tmp_path / "log"
    path.write_bytes(b"x" * 100)
    return path


def test_long_log_on_a_terminal(log: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The log, its events and the part read."""
    monkeypatch.setattr(sys, "stderr", Terminal())
    monkeypatch.setattr(progress, "_DELAY", 0)
    monkeypatch.setenv("TERM", "xterm")
    shown = show(log)
    assert "log" in shown
    assert "1,235 events, 50%" in shown


def test_long_name_on_a_narrow_terminal(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The name is cut; the counts are whole, on one line."""
    monkeypatch.setattr(sys, "stderr", Terminal())
    monkeypatch.setattr(progress, "_DELAY", 0)
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("COLUMNS", "80")
    path = tmp_path / ("TINT-33-a-name-that-says-what-the-log-is-about-" + "x" * 60 + ".ndjson")
    path.write_bytes(b"x" * 100)
    shown = show(path, 1234)
    assert "0/1234" in shown
    assert "TINT-33-a-name" in shown
    assert "1,235 events, 50%" in shown
    assert "0:00:00" in shown


def test_short_log(log: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing flickers for a log that is read at once."""
    monkeypatch.setattr(sys, "stderr", Terminal())
    assert show(log) == ""


def test_no_terminal(log: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing goes to a file."""
    monkeypatch.setattr(sys, "stderr", io.StringIO())
    monkeypatch.setattr(progress, "_DELAY", 0)
    assert show(log) == ""
