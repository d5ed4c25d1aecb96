"""``s7check reduce``: a small log that is rejected alike."""

import json
from pathlib import Path

import pytest

import s7check
from s7check.cli import main
from s7check.reducing.candidate import Judge
from tests.logs import HEADER, at, event, log_text

RUN = HEADER | {"mode": "RUN", "latency_ms": 20, "x_site": "mill"}


def test_fewer_lines(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Lines, OBs, fields and odd times go that the rejection does not need; the reason stays."""
    calls = [event("EN_IRT", 30 + n / 50, mode=2, ob=40, ret=0) for n in range(200)]
    lost = [
        event("SRT_DINT", 40, ob=20, dtime=1234, sign=1, ret=0, up=9),
        event("CAN_DINT", 41.5, ob=20, ret="16#80A0"),
    ]
    log, small = tmp_path / "log.ndjson", tmp_path / "small.ndjson"
    log.write_bytes(log_text(*calls, *lost, event("hold", 42), header=RUN))
    before = s7check.check(log)
    assert before.verdict == "rejected"
    assert main(["reduce", "-o", str(small), str(log)]) == 0
    header, *events = (json.loads(line) for line in small.read_bytes().splitlines())
    after = s7check.check(small)
    assert (after.verdict, after.line) == ("rejected", len(events) + 1)
    assert before.requirements[0] in after.requirements
    assert [one["event"] for one in events] == ["SRT_DINT", "CAN_DINT"]
    assert set(header) == {"format", "cpu", "obs", "clock", "mode"}
    assert header["obs"] == [85], "it had to start for OB 20, which is missing"
    assert not {"up"} & set(events[0])
    assert capsys.readouterr().err.startswith(f"{log}:203: 3 of 203 lines, ")


def test_no_time(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """Without time the log itself is written, up to the rejected line, and the message says so: it is judged once."""
    monkeypatch.delattr(Judge, "answer")
    log = tmp_path / "log.ndjson"
    log.write_bytes(log_text(event("DIS_AIRT", ret=1), event("EN_AIRT", ret=7), event("hold"), header=RUN))
    assert main(["reduce", "--budget", "0", str(log)]) == 0
    captured = capsys.readouterr()
    assert captured.out.count("\n") == 3
    assert "not everything was tried (see --budget)" in captured.err


def test_every_rejection(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """With --keep-going each rejection has a log of its own, also one behind a line that was judged as another."""
    log, small = tmp_path / "log.ndjson", tmp_path / "small.ndjson"
    wrong = [event("DIS_AIRT", 31, ret=2), event("EN_AIRT", 32, ret=0), event("EN_AIRT", 33, ret=7)]
    log.write_bytes(log_text(*wrong, event("CAN_DINT", 34, ob=20, ret=0), event("hold", 42), header=RUN))
    assert main(["reduce", "--keep-going", "-o", str(small), str(log)]) == 0
    said = capsys.readouterr().err.splitlines()
    files = [small, tmp_path / "small-2.ndjson", tmp_path / "small-3.ndjson"]
    assert sorted(tmp_path.glob("small*")) == sorted(files)
    for file, line, text in zip(files, (2, 4, 5), said, strict=True):
        report = s7check.check(file)
        assert report.verdict == "rejected"
        assert text.startswith(f"{log}:{line}: 2 of {line} lines, {report.requirements[0]}")


@pytest.mark.parametrize("arguments", [["log.ndjson"], ["-o", "small.ndjson", "-"]])
def test_keep_going_needs_files(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    """Several logs need several files, and a log that can be read again."""
    assert main(["reduce", "--keep-going", *arguments]) == 2
    assert "expected --output FILE, and a log that can be read again" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "code", "words"),
    [
        (log_text(event("DIS_AIRT", ret=1), header=RUN), 1, "accepted"),
        (log_text("{", header=RUN), 2, "unusable: expected a JSON object"),
    ],
)
def test_nothing_to_reduce(
    text: bytes, code: int, words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A log that is not rejected has a sentence and an exit code."""
    log = tmp_path / "log.ndjson"
    log.write_bytes(text)
    assert main(["reduce", str(log)]) == code
    captured = capsys.readouterr()
    assert captured.out == ""
    assert words in captured.err


def test_the_end_of_a_long_log(tmp_path: Path) -> None:
    """A line that only the lines before the end explain is left out, not kept with all of them."""
    cycles = [event("interrupt", 31, ob=40), event("start", 31, ob=40)]
    cycles += [event("QRY_DINT", 31, ob=20, ret=0, status=16) for _ in range(300)]
    log, small = tmp_path / "log.ndjson", tmp_path / "small.ndjson"
    header = RUN | {"obs": [1, 20, 40]}
    log.write_bytes(log_text(*cycles, event("end", 31, ob=40), event("EN_AIRT", 31, ret=0), header=header))
    assert main(["reduce", "-o", str(small), str(log)]) == 0
    assert [json.loads(line)["event"] for line in small.read_bytes().splitlines()[1:]] == ["EN_AIRT"]
    assert json.loads(small.read_bytes().splitlines()[1])["at"].startswith(at(0)[:17])


def test_a_restart_forgets_the_lines_before(tmp_path: Path) -> None:
    """The log begins at it, with the OBs that were loaded then."""
    before = [event("load", 30, ob=40), *(event("DIS_AIRT", 31, ret=count) for count in range(1, 300))]
    restarted = [event("stop", 32), event("restart", 33, type="warm"), event("run", 33), event("interrupt", 34, ob=40)]
    wrong = event("start", 34, ob=40, info={"priority": 9})
    log, small = tmp_path / "log.ndjson", tmp_path / "small.ndjson"
    log.write_bytes(log_text(*before, *restarted, wrong, header=RUN | {"obs": [1, 80, 85]}))
    assert main(["reduce", "-o", str(small), str(log)]) == 0
    header, *events = (json.loads(line) for line in small.read_bytes().splitlines())
    assert 40 in header["obs"]
    assert [one["event"] for one in events][-2:] == ["interrupt", "start"]
    assert len(events) <= 4
