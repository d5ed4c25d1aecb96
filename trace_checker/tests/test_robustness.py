"""Hostile logs, streams without an end, little memory, failing engines, disks that are full."""

import gzip
import os
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from s7check import cli
from s7check.engine.command import CHOICE, engine_command
from s7check.engine.process import EngineProcess
from s7check.judging import check
from tests import fuzz
from tests.logs import event, log_text
from tests.processes import children
from tests.test_cli import ENVIRONMENT, RUNNER

MEMORY = 300 * 1024 * 1024
"""Bytes of address space that s7check itself must do with, as docs/checking/commands.md says."""

REJECTED = log_text(event("run"), event("EN_AIRT", ret=1))
UNUSABLE = log_text(event("run"), event("EN_AIRT", ret="abc"))


def limited(what: int, size: int) -> Callable[[], None]:
    """What makes a new process live with a limit."""
    return lambda: resource.setrlimit(what, (size, size))


MEGABYTE = 1024 * 1024
HOSTILE = {
    "long line": (b"a" * MEGABYTE, 100, "a line of at most 1048576 bytes; found a longer one"),
    "zeros": (b"\0" * MEGABYTE, 100, "a line of at most 1048576 bytes; found a longer one"),
    "nesting": (b'{"event":' + b"[" * 10**6 + b"\n", 1, "a JSON object; found too many levels of nesting"),
    "objects": (b'{"x_":' * 150_000 + b"\n", 1, "a JSON object; found too many levels of nesting"),
    "long number": (b'{"event": "run", "up": ' + b"9" * 10**6 + b"}\n", 1, "found integer value out of range"),
    "large number": (b'{"event": "run", "up": 1e999999}\n', 1, "found number out of range"),
}
"""What follows the first event of a log, how often, and how the engine's message ends."""


@pytest.mark.parametrize("real", [False, True])
def test_little_memory(tmp_path: Path, real: bool) -> None:
    """What would fill the memory is refused in one line; the logs are packed, 200 MB in 1 MB.

    The limit is for Python: the engine has its own, its heap.
    """
    for name, (piece, count, _) in HOSTILE.items():
        with gzip.open(tmp_path / f"{name}.gz", "wb", compresslevel=1) as file:
            file.write(log_text(event("restart", type="warm")))
            for _ in range(count):
                file.write(piece)
    run = subprocess.run(
        [*([sys.executable, "-m", "s7check"] if real else RUNNER), "trace", *(f"{name}.gz" for name in HOSTILE)],
        cwd=tmp_path,
        env={**ENVIRONMENT, "JDK_JAVA_OPTIONS": "-Xmx64m"},
        capture_output=True,
        text=True,
        timeout=60,
        preexec_fn=None if real else limited(resource.RLIMIT_AS, MEMORY),
        check=False,
    )
    assert (run.returncode, run.stderr.removeprefix("NOTE: Picked up JDK_JAVA_OPTIONS: -Xmx64m\n")) == (2, "")
    *said, total = run.stdout.splitlines()
    assert total == f"{len(HOSTILE)} logs: {len(HOSTILE)} unusable"
    for line, (name, (_, _, found)) in zip(said, HOSTILE.items(), strict=True):
        assert line.startswith(f"{name}.gz:3: unusable: ")
        assert line.endswith(found) or not real


def test_empty_lines_without_end() -> None:
    """Of lines that have hardly any bytes no more are kept than of others."""
    recent = check._RecentLines()
    for _ in range(40):
        recent.add(b"\n" * 1_000_000)
    assert sum(map(len, recent._chunks)) < 20_000_000
    assert recent.ended == 40_000_000
    assert recent.get(40_000_000) == b""
    assert recent.get(1) is None
    assert recent.up_to(1) == []


@pytest.mark.parametrize(("log", "code", "verdict"), [(REJECTED, 1, b"rejected"), (UNUSABLE, 2, b"unusable")])
def test_stream_that_never_ends(log: bytes, code: int, verdict: bytes) -> None:
    """The verdict comes with the line that decides it, though more and more lines follow."""
    endless = "import sys\nwhile True: sys.stdout.buffer.write(sys.argv[1].encode() + b'\\n' * 65536)"
    with subprocess.Popen(
        [sys.executable, "-c", endless, log.decode()], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
    ) as writer:
        run = subprocess.run(
            [*RUNNER, "trace", "-"], stdin=writer.stdout, env=ENVIRONMENT, capture_output=True, timeout=60, check=False
        )
        writer.kill()
    assert (run.returncode, run.stderr) == (code, b"")
    assert run.stdout.startswith(b"-:3: " + verdict)


@pytest.mark.usefixtures("_fake_engine")
def test_markup_and_control_characters(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What a log says is never markup of the page, wherever it stands, nor an order to a terminal."""
    monkeypatch.chdir(tmp_path)
    evil = "</title><script>alert(1)</script>\x1b[31m\0"
    names = {evil: evil, f"x_{evil}": {evil: evil}}
    for number, entry in enumerate([event("EN_AIRT", ret=1, x_=names), event("EN_AIRT", ret=evil), event(evil)]):
        # After the line that decides anything may follow.
        rest = [event("interrupt", ob=[evil], info=evil), event("clock", to={evil: 1})]
        (tmp_path / f"<script>{number}").write_bytes(log_text(entry, *rest, "[" * 5000))
    cli.main(["trace", "--format", "html", "--output", "page", *(str(path.name) for path in tmp_path.iterdir())])
    page = (tmp_path / "page").read_text(encoding="utf-8")
    assert page.count("<script>") == page.count("</script>") == 1
    assert page.replace("\n", "").isprintable()


def test_out_of_memory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """The engine itself, with a heap in which nothing has room."""
    monkeypatch.setenv(CHOICE, "jvm")
    monkeypatch.setenv("JDK_JAVA_OPTIONS", "-Xmx8m")
    (tmp_path / "log").write_bytes(log_text(event("restart", type="warm")))
    assert cli.main(["trace", str(tmp_path / "log")]) == 3
    (line,) = capsys.readouterr().out.splitlines()
    assert line.endswith(
        ": no verdict: the engine ran out of memory: give it more, JDK_JAVA_OPTIONS=-Xmx4g for instance"
    )


def test_killed_engine(tmp_path: Path) -> None:
    """The log at which the engine was killed has no verdict, the next one has, and no folder is left."""
    logs = tmp_path / "logs"
    logs.mkdir()
    (logs / "after").write_bytes(log_text(event("restart", type="warm")))
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    with subprocess.Popen(
        [*RUNNER, "trace", "-", "after"],
        cwd=logs,
        env=ENVIRONMENT | {"TMPDIR": str(scratch)},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as run:
        assert run.stdin is not None
        assert run.stdout is not None
        run.stdin.write(log_text(event("restart", type="warm")).decode())
        run.stdin.flush()
        limit = time.monotonic() + 60
        while not (engines := children(run.pid)) and time.monotonic() < limit:
            time.sleep(0.05)
        os.kill(min(engines), signal.SIGKILL)
        run.stdin.close()
        first, second, total = run.stdout.read().splitlines()
    assert first.startswith("-: no verdict: the engine ended (killed by SIGKILL)")
    assert second.startswith("after: accepted")
    assert total == "2 logs: 1 accepted, 1 no verdict"
    assert list(scratch.iterdir()) == []


def test_killed_parent(tmp_path: Path) -> None:
    """The engine ends with it, and removes its folder."""
    with subprocess.Popen(
        [sys.executable, "-m", "s7check", "trace", "-"],
        env=ENVIRONMENT | {"TMPDIR": str(tmp_path)},
        stdin=subprocess.PIPE,
    ) as run:
        assert run.stdin is not None
        run.stdin.write(log_text(event("restart", type="warm")))
        run.stdin.flush()
        limit = time.monotonic() + 60
        while not children(run.pid) and time.monotonic() < limit:
            time.sleep(0.05)
        time.sleep(1)
        run.kill()
    for _ in range(400):
        if not (left := list(tmp_path.iterdir())):
            break
        time.sleep(0.05)
    assert left == []


def test_ended_engine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A signal that ends it, as a terminal sends to all its processes, leaves no folder although nobody else clears."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    process = EngineProcess(engine_command())
    assert b"ready" in process.line()
    os.kill(process._process.pid, signal.SIGTERM)
    process._process.wait(60)
    assert list(tmp_path.iterdir()) == []
    process.end()


@pytest.mark.parametrize("old", [None, "old"])
def test_full_disk(tmp_path: Path, old: str | None) -> None:
    """A report that does not fit leaves what was there, and nothing beside it."""
    (tmp_path / "log").write_bytes(REJECTED)
    folder = tmp_path / "reports"
    folder.mkdir()
    if old is not None:
        (folder / "report").write_text(old)
    run = subprocess.run(
        [*RUNNER, "trace", "--output", folder / "report", tmp_path / "log"],
        env=ENVIRONMENT | {"PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True,
        text=True,
        preexec_fn=limited(resource.RLIMIT_FSIZE, 100),
        check=False,
    )
    assert (run.returncode, run.stdout) == (2, "")
    assert "report" in run.stderr
    assert "Traceback" not in run.stderr
    assert [path.read_text() for path in folder.iterdir()] == ([] if old is None else [old])


@pytest.mark.parametrize(
    ("what", "size", "advice"),
    [
        (resource.RLIMIT_NOFILE, 8, "allow 16 open files or more, ulimit -n; found 8"),
        (resource.RLIMIT_AS, 1024 * MEGABYTE, "allow 4 GB of address space or more, ulimit -v; found 1.0 GB"),
        (resource.RLIMIT_AS, 200 * MEGABYTE, "allow 4 GB of address space or more, ulimit -v; found 0.2 GB"),
    ],
)
def test_limits_too_small_for_java(tmp_path: Path, what: int, size: int, advice: str) -> None:
    """There is no verdict, and the message names the limit to raise; no folder is left."""
    (tmp_path / "scratch").mkdir()
    (tmp_path / "log").write_bytes(log_text(event("restart", type="warm")))
    run = subprocess.run(
        [sys.executable, "-m", "s7check", "trace", "log"],
        cwd=tmp_path,
        env=ENVIRONMENT | {"TMPDIR": str(tmp_path / "scratch"), CHOICE: "jvm"},
        capture_output=True,
        text=True,
        preexec_fn=limited(what, size),
        check=False,
    )
    assert (run.returncode, run.stderr) == (3, "")
    assert run.stdout.startswith("log: no verdict: ")
    assert run.stdout.endswith(f"{advice}\n")
    assert list((tmp_path / "scratch").iterdir()) == []


@pytest.mark.parametrize(("options", "code"), [("", 0), ("-Xmx400000g", 3)])
def test_folder_that_was_deleted(tmp_path: Path, options: str, code: int) -> None:
    """The current folder is not needed, not even to say why Java does not start."""
    (tmp_path / "log").write_bytes(log_text(event("restart", type="warm")))
    script = 'mkdir gone && cd gone && rmdir ../gone && exec "$@"'
    run = subprocess.run(
        ["sh", "-c", script, "sh", sys.executable, "-m", "s7check", "trace", str(tmp_path / "log")],
        cwd=tmp_path,
        env=ENVIRONMENT | {"JDK_JAVA_OPTIONS": options, CHOICE: "jvm"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (run.returncode, run.stderr) == (code, "")
    assert "working directory" not in run.stdout
    assert ("400000g" in run.stdout) == (code == 3)


def test_damaged_logs_and_sources(tmp_path: Path) -> None:
    """A sample of what `make fuzz` does."""
    tally = fuzz.Tally()
    fuzz.run_sources(range(50), 7, tmp_path, tally)
    fuzz.run_logs(range(50, 300), 7, tmp_path, tally)
    assert tally.faults == []
    assert sum(sum(counts.values()) for counts in tally.counts.values()) == 300
