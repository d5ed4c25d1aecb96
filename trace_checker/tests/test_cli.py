"""``s7check`` as its users see it, with the fake engine."""

import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import msgspec
import pytest

from s7check import __version__, cli, trace_command
from s7check.engine import pool
from s7check.engine.client import Engine
from s7check.engine.command import EngineError, engine_kind
from s7check.judging import check
from s7check.report.clauses import clause
from tests.fake_engine import CANDIDATE, REFUSAL, SITUATION
from tests.logs import HEADER, event, log_text
from tests.processes import children, heed_ctrl_c

pytestmark = pytest.mark.usefixtures("_fake_engine")

RUNNER = [sys.executable, "-m", "tests.run_with_fake_engine"]
ENVIRONMENT = os.environ | {"PYTHONPATH": str(Path(cli.__file__).parents[1])}

ACCEPTED = log_text(event("run"), event("EN_AIRT", ret=0))
REJECTED = log_text(event("run"), event("EN_AIRT", ret="16#0001", x_who="me"), event("stop"))
UNUSABLE = log_text(event("run"), event("EN_AIRT", ret="abc"))
WRONG_RET = 'field "ret": expected a word such as "W#16#8090" or an integer -32768..65535, or null; found "abc"'
NO_VERDICT = log_text(event("hold"))
PLACE = "docs/rules/requirements.md#AIRT-07"
WHY = REFUSAL["why"]


@pytest.fixture
def logs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A log of each verdict in the working directory."""
    monkeypatch.chdir(tmp_path)
    contents = {"accepted": ACCEPTED, "rejected": REJECTED, "unusable": UNUSABLE, "no": NO_VERDICT}
    for name, content in contents.items():
        (tmp_path / name).write_bytes(content)
    return tmp_path


def objects(capsys: pytest.CaptureFixture[str]) -> list[dict[str, Any]]:
    """The JSON objects printed, and nothing else anywhere."""
    captured = capsys.readouterr()
    assert captured.err == ""
    return [json.loads(line) for line in captured.out.splitlines()]


@pytest.mark.parametrize(
    ("names", "code"),
    [
        (["accepted"], 0),
        (["rejected"], 1),
        (["unusable"], 2),
        (["no"], 3),
        (["accepted", "accepted"], 0),
        (["rejected", "accepted"], 1),
        (["accepted", "unusable", "rejected"], 2),
        (["no", "unusable", "accepted"], 3),
    ],
)
@pytest.mark.usefixtures("logs")
def test_exit_code(names: list[str], code: int, capsys: pytest.CaptureFixture[str]) -> None:
    """The exit code is the highest of all logs', in either format."""
    assert cli.main(["trace", *names]) == code
    assert capsys.readouterr().err == ""
    assert cli.main(["trace", "--format", "json", *names]) == code
    assert len(objects(capsys)) == len(names)


@pytest.mark.usefixtures("logs")
def test_json(capsys: pytest.CaptureFixture[str]) -> None:
    """One object a log with the fields of the contract."""
    cli.main(["trace", "--format", "json", "accepted", "rejected", "unusable", "no"])
    nothing: dict[str, Any] = {"line": None, "event": None, "expected": [], "requirements": []}
    assert objects(capsys) == [
        nothing
        | {"log": "accepted", "verdict": "accepted", "events": 2, "message": "the specification explains every event"},
        {
            "log": "rejected",
            "verdict": "rejected",
            "line": 3,
            "events": 1,
            "event": event("EN_AIRT", ret="16#0001", x_who="me"),
            "expected": ["EN_AIRT ret=16#0000"],
            "requirements": ["AIRT-07"],
            "message": "no behaviour of the specification explains this line",
            "prefix": {"first": 1, "last": 3},
            "why": WHY,
            "late": [],
            "clauses": [msgspec.to_builtins(clause("AIRT-07")) | {"place": PLACE}],
            "candidates": [CANDIDATE],
            "states": 2,
            "situations": [SITUATION["said"]],
            "readings": [
                {"change": "cpu S7-300", "verdict": "rejected", "line": 3, "place": None},
                {"change": "profile 2006", "verdict": "rejected", "line": 3, "place": None},
                {"change": "AMB-01 a", "verdict": "rejected", "line": 3, "place": clause("AMB-01").place},
                {"change": "AMB-12 b", "verdict": "accepted", "line": None, "place": clause("AMB-12").place},
            ],
            "untried": [],
        },
        nothing
        | {
            "log": "unusable",
            "verdict": "unusable",
            "line": 3,
            "events": 1,
            "message": WRONG_RET,
        },
        nothing
        | {
            "log": "no",
            "verdict": "no verdict",
            "line": 2,
            "events": 0,
            "message": "hold is not covered by the specification",
        },
    ]


@pytest.mark.usefixtures("logs")
def test_text(capsys: pytest.CaptureFixture[str]) -> None:
    """The verdict with its place, the line, what was expected; no colours in a file."""
    cli.main(["trace", "accepted", "rejected", "unusable", "no"])
    assert capsys.readouterr().out.splitlines() == [
        "accepted: accepted: the specification explains every event (2 events)",
        "rejected:3: rejected: no behaviour of the specification explains this line",
        '    {"event": "EN_AIRT", "at": "2026-11-21T05:59:31.000", "ret": "16#0001", "x_who": "me"}',
        "  expected: EN_AIRT ret=16#0000",
        "  requirements: AIRT-07",
        f"  why not: {WHY}",
        "    AIRT-07 Calls are counted.",
        "  shortest prefix that fails: lines 1 to 3",
        "  before the line 1 of 2:",
        "    mode: RUN",
        "    loaded: OB 1",
        "  would pass with: AMB-12 b",
        f"  formulas: {REFUSAL['formulas'][0]}",
        f"unusable:3: unusable: {WRONG_RET}",
        "no:2: no verdict: hold is not covered by the specification",
        "4 logs: 1 accepted, 1 rejected, 1 unusable, 1 no verdict",
        "  rejected by: AIRT-07 (1)",
    ]


def test_same_cause(logs: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A cause is explained in full once; what was expected and the readings are told of each log."""
    (logs / "again").write_bytes(REJECTED)
    cli.main(["trace", "rejected", "again"])
    out = capsys.readouterr().out
    assert out.count("formulas: ") == out.count("before the line 1 of 2:") == 1
    again = out[out.index("again:3: rejected") :].splitlines()
    assert again[2:6] == [
        "  expected: EN_AIRT ret=16#0000",
        "  requirements: AIRT-07",
        f"  why not: {WHY}",
        "  the same cause as: rejected:3",
    ]
    assert again[6].startswith("  would pass with: AMB-12 b")
    assert again[7:] == ["2 logs: 2 rejected", "  rejected by: AIRT-07 (2)"]


@pytest.mark.parametrize("header", [{}, {"readings": {"AMB-12": "a"}}])
def test_set(logs: Path, header: dict[str, Any], capsys: pytest.CaptureFixture[str]) -> None:
    """A reading of the command line goes before that of the header; other readings are tried from there."""
    (logs / "log").write_bytes(log_text(event("EN_AIRT", ret=1), header=HEADER | header))
    assert cli.main(["trace", "log"]) == 1
    capsys.readouterr()
    arguments = ["trace", "--format", "json", "--readings", "all", "--set", "AMB-01=a", "--set", "AMB-12=b", "log"]
    assert cli.main(arguments) == 0
    (report,) = objects(capsys)
    assert {one["change"]: one["verdict"] for one in report["readings"] if one["change"].startswith("AMB")} == {
        "AMB-01 c": "accepted",
        "AMB-12 a": "rejected",
    }


def test_hostile_line(logs: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A quoted line cannot send orders to the terminal or fill it."""
    (logs / "a").write_bytes(log_text(event("EN_AIRT", ret=1, x_a="\u202e\x9b31m" + "x" * 10_000)))
    raw = '{"event":"EN_AIRT","at":"2026-11-21T05:59:31","ret":1,"x_a":"\u202e\x9b31m\x7f' + "x" * 10_000 + '"}'
    (logs / "b").write_bytes(log_text(raw))
    assert cli.main(["trace", "a", "b"]) == 1
    out = capsys.readouterr().out
    assert out.replace("\n", "").isprintable()
    assert len(out) < 4000


def test_line_no_longer_at_hand(
    logs: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Only so many lines are kept for the report; a verdict does not depend on them."""
    monkeypatch.setattr(check, "_KEPT", 1)
    monkeypatch.setattr(Engine, "wait", lambda *_: True)
    (logs / "a").write_bytes(log_text(event("EN_AIRT", ret=1), *[event("run")] * 10_000))
    assert cli.main(["trace", "--format", "json", "a"]) == 1
    assert objects(capsys)[0]["event"] is None
    assert cli.main(["trace", "a"]) == 1


@pytest.mark.usefixtures("logs")
def test_unusable_without_an_engine(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """What cannot be opened needs no engine; everything else says what is missing."""

    def missing() -> list[str]:
        raise EngineError("run `make engine`")

    monkeypatch.setattr(pool, "Engine", lambda: Engine(missing))
    assert cli.main(["trace", "nowhere"]) == 2
    assert cli.main(["trace", "accepted"]) == 3
    assert capsys.readouterr().out.splitlines() == [
        "nowhere: unusable: expected a log that can be opened; found no such file or directory",
        "accepted: no verdict: run `make engine`",
    ]


@pytest.mark.parametrize("name", ["missing", ".", "unreadable", "a\0b", "x" * 5000])
def test_no_log(logs: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    """What cannot be opened is unusable, with one line that says why."""
    (logs / "unreadable").symlink_to("unreadable")
    assert cli.main(["trace", name]) == 2
    (line,) = capsys.readouterr().out.splitlines()
    assert re.search(r"(?<!:\d): unusable: expected", line), "it has no line"


@pytest.mark.parametrize(
    "arguments",
    [
        ["trace"],
        [],
        ["trace", "--format", "xml", "x"],
        ["trace", "--profile", "1998", "x"],
        ["trace", "--nope"],
        ["trace", "--set", "AMB-12", "x"],
        ["trace", "--set", "AMB-12=z", "x"],
        ["trace", "--set", "AMB-12=", "x"],
        ["trace", "--set", "AMB-12=a,AMB-99=a", "x"],
        ["trace", ""],
        ["trace", "x", ""],
        ["nope"],
        ["trace", "--format"],
    ],
)
def test_wrong_arguments(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    """Wrong arguments give exit code 2 and a message on standard error."""
    assert cli.main(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert "Error:" in captured.err or "Usage:" in captured.err


def test_help(capsys: pytest.CaptureFixture[str]) -> None:
    """Help explains the verdicts, the version is the package's."""
    assert cli.main(["trace", "--help"]) == 0
    shown = capsys.readouterr().out
    assert "rejected    1" in shown
    assert "\\" not in shown
    assert cli.main(["--help"]) == 0
    assert set(cli.COMMANDS) <= set(capsys.readouterr().out.split())
    assert cli.main(["--version"]) == 0
    assert capsys.readouterr().out == f"s7check, version {__version__}, engine {engine_kind()}\n"


@pytest.mark.parametrize(
    ("error", "code"), [(KeyboardInterrupt, 130), (RuntimeError("oops"), 3), (MemoryError, 3), (OSError(28, "full"), 3)]
)
@pytest.mark.usefixtures("logs")
def test_no_traceback(
    error: BaseException, code: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Whatever goes wrong inside ends with a sentence."""

    def fail(*_: object) -> None:
        raise error

    monkeypatch.setattr(trace_command, "check_log", fail)
    assert cli.main(["trace", "accepted"]) == code
    assert "Traceback" not in capsys.readouterr().err


def start(*arguments: str, **options: Any) -> subprocess.Popen[bytes]:
    """A process of ``s7check`` that reads standard input."""
    return subprocess.Popen(
        [*RUNNER, "trace", *arguments],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=ENVIRONMENT,
        **options,
    )


def test_standard_input_is_judged_while_it_is_written() -> None:
    """A verdict on a stream comes with the line that decides it, not with the stream's end."""
    with start("-") as process:
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(REJECTED)
        process.stdin.flush()
        assert process.stdout.readline().startswith(b"-:3: rejected: ")
        assert process.wait(30) == 1


def test_standard_input_to_its_end() -> None:
    """A stream that ends is a log like any other; a line without end counts."""
    with start("-", "--format", "json") as process:
        out, err = process.communicate(ACCEPTED.rstrip(), timeout=30)
    assert (json.loads(out)["verdict"], err, process.returncode) == ("accepted", b"", 0)


def test_standard_input_closed() -> None:
    """A closed standard input is no log."""
    run = subprocess.run(
        ["sh", "-c", '"$@" <&-', "sh", *RUNNER, "trace", "-"], capture_output=True, timeout=30, check=False
    )
    assert run.returncode == 2
    assert run.stderr == b""
    assert b"unusable: expected a log on standard input" in run.stdout


def wait_for_child(process: subprocess.Popen[bytes], seconds: float = 60) -> None:
    """Wait until the process has started one, which takes its time where others keep the cores busy."""
    end = time.monotonic() + seconds
    while not children(process.pid) and time.monotonic() < end:
        time.sleep(0.05)


def test_interrupt() -> None:
    """Ctrl-C while a stream is silent ends the process and its engine, without a traceback."""
    with start("-", start_new_session=True, preexec_fn=heed_ctrl_c) as process:
        assert process.stdin is not None
        assert process.stderr is not None
        process.stdin.write(ACCEPTED)
        process.stdin.flush()
        wait_for_child(process)
        with pytest.raises(subprocess.TimeoutExpired):
            process.wait(1)
        os.killpg(process.pid, signal.SIGINT)
        assert process.wait(30) == 130
        assert b"Traceback" not in process.stderr.read().partition(b"fake_engine")[0]


@pytest.mark.usefixtures("logs")
def test_reader_of_the_output_is_gone() -> None:
    """The exit code is still that of the verdict."""
    read, write = os.pipe()
    os.close(read)
    run = subprocess.run(
        [*RUNNER, "trace", "rejected", "accepted"],
        stdout=write,
        stderr=subprocess.PIPE,
        timeout=30,
        check=False,
        env=ENVIRONMENT,
    )
    os.close(write)
    assert (run.returncode, run.stderr) == (1, b"")


@pytest.mark.usefixtures("logs")
@pytest.mark.parametrize("output", ["text", "json", "html"])
@pytest.mark.parametrize(
    ("redirection", "message"),
    [
        (">/dev/full", "Error: standard output: cannot be written: No space left on device\n"),
        (">&-", "Error: standard output is closed: expected an open one, or --output FILE\n"),
    ],
)
def test_report_that_cannot_be_written(output: str, redirection: str, message: str) -> None:
    """It is no report: exit code 2 and one message, whatever the verdict."""
    command = ["sh", "-c", f'"$@" {redirection}', "sh", *RUNNER, "trace", "--format", output, "accepted"]
    run = subprocess.run(command, stderr=subprocess.PIPE, text=True, timeout=60, check=False, env=ENVIRONMENT)
    assert (run.returncode, run.stderr) == (2, message)


@pytest.mark.usefixtures("logs")
def test_file_of_the_report_while_standard_output_is_closed() -> None:
    """The report does not need it then."""
    command = ["sh", "-c", '"$@" >&-', "sh", *RUNNER, "trace", "--output", "report", "accepted"]
    run = subprocess.run(command, stderr=subprocess.PIPE, timeout=60, check=False, env=ENVIRONMENT)
    assert (run.returncode, run.stderr) == (0, b"")
    assert Path("report").read_text(encoding="utf-8").startswith("accepted: accepted")


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "cp437"])
def test_any_encoding_of_the_output(logs: Path, encoding: str) -> None:
    """A terminal that lacks a character gets it in another way and no error."""
    (logs / "a").write_bytes(log_text('{"event":"EN_AIRT","at":"2026-11-21T05:59:31","ret":1,"x_a":"\u20ac"}'))
    run = subprocess.run(
        [*RUNNER, "trace", "a"],
        capture_output=True,
        timeout=30,
        check=False,
        env=ENVIRONMENT | {"PYTHONIOENCODING": encoding},
    )
    assert (run.returncode, run.stderr) == (1, b"")
    assert run.stdout.startswith(b"a:2: rejected")


HEAVY = {
    *("asyncio", "click.shell_completion", "concurrent.futures", "dataclasses", "glob", "hashlib", "html", "jinja2"),
    *("json", "logging", "multiprocessing", "queue", "random", "rich", "shutil", "tempfile", "xml"),
    *("s7check.api", "s7check.asking", "s7check.importing", "s7check.kit", "s7check.report.as_html"),
}


def test_light(logs: Path) -> None:
    """Most of what a short log costs is Python's start: an accepted one imports nothing that it can do without."""
    # Java needs more: an archive of classes, a folder for its files. The first log of a specification writes the cache.
    native = engine_kind() == "native"
    use = "; s7check.cli.main(['trace', 'accepted'])" if native else ""
    script = f"import sys, s7check.cli, s7check.trace_command{use}; print(*sys.modules, file=sys.stderr)"
    for _ in range(2):
        ran = subprocess.run([sys.executable, "-c", script], cwd=logs, capture_output=True, text=True)
    loaded = set(ran.stderr.split())
    assert "s7check.judging.check" in loaded
    assert HEAVY.isdisjoint(loaded), HEAVY & loaded
