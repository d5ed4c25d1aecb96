"""``import s7check``: a whole log, and events while a program runs."""

import re
import subprocess
import sys
import threading
from pathlib import Path

import click
import pytest

import s7check
from s7check.engine import pool
from s7check.engine.client import Engine
from s7check.engine.command import CHOICE
from s7check.report.as_text import TextReports
from tests.logs import RUN, event, log_text
from tests.shipped import log_of

NOTHING_DELAYED = event("EN_AIRT", ret=0)
REJECTED = log_of("AIRT-07-nothing-delayed-answers-0000")
PAGE = Path(s7check.__file__).parents[2] / "docs" / "checking" / "python.md"


def test_check_of_a_file() -> None:
    """The report says what the command says."""
    report = s7check.check(REJECTED)
    assert (report.verdict, report.line, report.expected) == ("rejected", 3, ["EN_AIRT ret=16#8080"])
    assert "AIRT-07" in report.requirements
    assert report.log == str(REJECTED)
    assert report.readings is None
    assert str(report) == click.unstyle(TextReports().add(report))
    assert str(report).startswith(f"{REJECTED}:3: rejected: ")


def test_check_of_events() -> None:
    """Fields and texts are lines alike; the report quotes the line."""
    report = s7check.check([RUN, '{"event": "DIS_AIRT", "at": "2026-11-21T05:59:31", "ret": 1}\n', NOTHING_DELAYED])
    assert (report.verdict, report.events) == ("accepted", 2)
    report = s7check.check([RUN, NOTHING_DELAYED], name="plc")
    assert (report.log, report.line) == ("plc", 2)
    assert report.event is not None
    assert b"EN_AIRT" in report.event


def test_checker_and_the_end_of_the_log() -> None:
    """A `done` owes what had to come by then, and nothing can be fed behind it."""
    dis = event("DIS_AIRT", ret=1)
    late = event("done", at="2026-11-21T05:59:40")
    due = event("interrupt", ob=40)
    with pytest.raises(s7check.NotAcceptedError, match="something had to come before this line") as caught:
        _fed([RUN | {"obs": [1, 40, 80, 85]}, due, late])
    assert caught.value.report.expected == ["start ob=40"]
    _fed([RUN | {"obs": [1, 40, 80, 85]}, dis, due, late])
    with pytest.raises(s7check.NotAcceptedError, match='nothing behind "done"'):
        _fed([RUN, late, late])


def _fed(lines: list[s7check.Line]) -> None:
    with s7check.Checker() as checker:
        for each in lines:
            checker.feed(each)


@pytest.mark.parametrize(
    ("lines", "line", "words"),
    [
        ([], 1, "found an empty log"),
        ([NOTHING_DELAYED], 1, "expected the header in the first line"),
        ([RUN, "{"], 2, "a line cut off"),
        ([RUN, "", b"\xff"], 3, "expected"),
        ([RUN, {"event": "EN_AIRT"}], 2, 'field "at": expected in every EN_AIRT'),
    ],
)
def test_unusable(lines: list[s7check.Line], line: int, words: str) -> None:
    """``check`` and ``Checker`` refuse the same line with the same words."""
    report = s7check.check(lines)
    assert (report.verdict, report.line) == ("unusable", line)
    assert words in report.message
    with pytest.raises(s7check.NotAcceptedError) as raised:
        _fed(lines)
    assert (raised.value.report.line, raised.value.report.message) == (line, report.message)


def test_other_readings(tmp_path: Path) -> None:
    """On demand they are tried, of a file and of lines."""
    log = tmp_path / "log.ndjson"
    log.write_bytes(log_text(event("SET_TINT", ob=10, sdt="2026-12-31T06:00", period=0x1401, ret=0), header=RUN))
    of_file = s7check.check(log, other_readings=True)
    assert of_file.readings
    of_lines = s7check.check(log.read_bytes().splitlines(), other_readings=True)
    assert of_lines.readings == of_file.readings
    passing = next(one for one in of_file.readings if one.kind == "letter" and one.verdict == "accepted")
    ambiguity, letter = passing.change.split()
    assert s7check.check(log, letters={ambiguity: letter}).verdict == "accepted"


@pytest.mark.parametrize(
    ("profile", "letters", "words"),
    [("1998", {}, "profile: expected 1997"), (None, {"AMB-99": "a"}, "AMB-99"), (None, {"AMB-01": "x"}, "a or b or c")],
)
def test_choices_that_there_are_not(profile: str | None, letters: dict[str, str], words: str) -> None:
    """They are errors of the caller."""
    with pytest.raises(ValueError, match=words):
        s7check.check(REJECTED, profile=profile, letters=letters)
    with pytest.raises(ValueError, match=words):
        s7check.Checker(profile=profile, letters=letters)


def test_checker_raises_at_the_event() -> None:
    """The error comes where the event is fed, says what the report says, and comes again."""
    checker = s7check.Checker()
    checker.feed(RUN)
    checker.feed(event("DIS_AIRT", ret=1))
    checker.feed(event("EN_AIRT", ret=0))
    with pytest.raises(s7check.NotAcceptedError) as raised:
        checker.feed(NOTHING_DELAYED)
    report = checker.report()
    assert (report.verdict, report.line, report.events) == ("rejected", 4, 2)
    assert raised.value.report is report
    assert str(raised.value) == str(report)
    with pytest.raises(AssertionError):
        checker.feed(event("DIS_AIRT", ret=1))


def test_checker_takes_several_lines() -> None:
    """A text with several lines counts as so many; what follows the deciding line does not matter."""
    checker = s7check.Checker()
    checker.feed(log_text(event("DIS_AIRT", ret=1), "", event("EN_AIRT", ret=0), header=RUN))
    with pytest.raises(s7check.NotAcceptedError) as raised:
        checker.feed(log_text("{", event("DIS_AIRT", ret=1), header=NOTHING_DELAYED))
    assert (raised.value.report.verdict, raised.value.report.line) == ("rejected", 5)


def test_checker_is_done_after_its_report() -> None:
    """What is fed too late is no part of the verdict: that is an error of the caller."""
    checker = s7check.Checker()
    checker.feed(RUN)
    assert checker.report().verdict == "accepted"
    assert checker.report() is checker.report()
    with pytest.raises(RuntimeError, match="feed a new one"):
        checker.feed(NOTHING_DELAYED)


def test_checker_leaves_other_errors_alone() -> None:
    """An error of the program comes through, whatever the verdict."""
    with pytest.raises(ZeroDivisionError), s7check.Checker() as checker:
        _ = 1 / 0
    assert checker.report().verdict == "unusable"


def test_engines_are_used_again(monkeypatch: pytest.MonkeyPatch) -> None:
    """Checks one after the other share an engine; checkers at the same time have one each."""
    started: list[Engine] = []

    def begin() -> Engine:
        started.append(Engine())
        return started[-1]

    pool.end()
    monkeypatch.setattr(pool, "Engine", begin)
    for _ in range(3):
        assert s7check.check([RUN]).verdict == "accepted"
    assert len(started) == 1
    with s7check.Checker() as one, s7check.Checker() as other:
        one.feed(RUN)
        other.feed(RUN)
        one.feed(event("DIS_AIRT", ret=1))
        other.feed(event("EN_AIRT", ret=0x8080))
    assert len(started) == 2


def test_threads() -> None:
    """Threads check at the same time."""
    verdicts: list[str] = []
    work = [threading.Thread(target=lambda: verdicts.append(s7check.check(REJECTED).verdict)) for _ in range(3)]
    for thread in work:
        thread.start()
    for thread in work:
        thread.join()
    assert verdicts == ["rejected"] * 3


def test_no_engine(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Without Java there is no verdict, with the remedy; the next check tries again."""
    pool.end()
    monkeypatch.setenv(CHOICE, "jvm")
    monkeypatch.setenv("JAVA_HOME", str(tmp_path))
    report = s7check.check([RUN])
    assert report.verdict == "no verdict"
    assert "install Java" in report.message
    with pytest.raises(s7check.NotAcceptedError, match="install Java"), s7check.Checker() as checker:
        checker.feed(RUN)
    monkeypatch.undo()
    assert s7check.check([RUN]).verdict == "accepted"


def test_the_engine_ends_with_python() -> None:
    """A script that checks a log ends at once, and says nothing on standard error."""
    script = f"import s7check; print(s7check.check({str(REJECTED)!r}).verdict)"
    command = [sys.executable, "-W", "error", "-X", "dev", "-c", script]
    run = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60)
    assert (run.stdout, run.stderr) == ("rejected\n", "")


def test_examples_of_the_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The Python examples of the page run, in their order."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "log.ndjson").write_bytes(log_text(NOTHING_DELAYED, header=RUN))
    examples = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert len(examples) >= 2
    scope: dict[str, object] = {}
    for example in examples:
        exec(example, scope)  # noqa: S102 - the project's own page
