"""``s7check trace --keep-going``: every rejection of a log."""

import json
from pathlib import Path
from typing import Any

import pytest

from s7check.cli import main
from tests.logs import HEADER, event, log_text

RUN = HEADER | {"mode": "RUN", "obs": [1, 10, 35, 40, 80, 85, 100]}

Lines = list[dict[str, Any]]


def rejections(tmp_path: Path, capsys: pytest.CaptureFixture[str], *events: dict[str, Any] | str) -> Lines:
    """The reports of the log with these events."""
    log = tmp_path / "log.ndjson"
    log.write_bytes(log_text(*events, header=RUN))
    assert main(["trace", "--keep-going", "--readings", "none", "--format", "json", str(log)]) == 1
    return [json.loads(line) for line in capsys.readouterr().out.splitlines()]


def test_a_wrong_answer_costs_no_later_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The right answer takes its place: the lines behind it are judged as if it had stood there."""
    first, second = rejections(
        tmp_path,
        capsys,
        event("DIS_AIRT", 31, ret=2),
        event("EN_AIRT", 31, ret=0),
        event("EN_AIRT", 31, ret=7),
        event("EN_AIRT", 31, ret="16#8080"),
    )
    assert (first["line"], first.get("after")) == (2, None)
    assert (second["line"], second["after"]) == (4, "line 2 taken as DIS_AIRT ret=16#0001")
    assert second["expected"] == ["EN_AIRT ret=16#8080"]
    assert "prefix" in first
    assert "prefix" not in second


def test_a_run_out_of_the_blue_is_one_rejection(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Its calls and its end go with its start."""
    found = rejections(
        tmp_path,
        capsys,
        event("start", 31, ob=35),
        event("QRY_TINT", 31, ob=10, ret=0, status=16),
        event("end", 31, ob=35),
        event("interrupt", 32, ob=40),
        event("start", 32, ob=40),
        event("end", 32, ob=40),
        event("EN_AIRT", 33, ret=0),
    )
    assert [(one["line"], one.get("after")) for one in found] == [(2, None), (8, "line 2 left out with its run")]


def test_what_is_owed_is_put_in(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """An OB that did not start is taken as started; what is wrong behind it is found."""
    found = rejections(
        tmp_path,
        capsys,
        event("interrupt", 31, ob=40),
        event("DIS_IRT", 35, mode=2, ob=40, ret=0),
        event("EN_IRT", 36, mode=9, ob=40, ret=0),
    )
    assert [one["line"] for one in found] == [3, 4]
    assert found[1]["after"] == "line 3 taken with start ob=40 before it"


def test_it_ends_at_a_line_that_cannot_be_read(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """As the verdict about the log does; an accepted log has no further report."""
    assert len(rejections(tmp_path, capsys, event("EN_AIRT", ret=0), "{", event("EN_AIRT", ret=0))) == 1
    log = tmp_path / "log.ndjson"
    log.write_bytes(log_text(event("DIS_AIRT", ret=1), header=RUN))
    assert main(["trace", "--keep-going", str(log)]) == 0
    assert capsys.readouterr().out.count("accepted") == 1


def test_text_counts_logs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The sum has one verdict a log, and every rejection's requirements."""
    log = tmp_path / "log.ndjson"
    log.write_bytes(log_text(event("EN_AIRT", ret=0), event("EN_AIRT", ret=0), header=RUN))
    assert main(["trace", "--keep-going", "--readings", "none", str(log), str(log)]) == 1
    out = capsys.readouterr().out
    assert "2 logs: 2 rejected" in out
    assert "AIRT-07 (4)" in out
    assert "judged on after line 2 taken as EN_AIRT ret=16#8080" in out


def test_a_stream_cannot_be_read_again(capsys: pytest.CaptureFixture[str]) -> None:
    """Standard input is refused at once."""
    assert main(["trace", "--keep-going", "-"]) == 2
    assert "expected logs that can be read again" in capsys.readouterr().err
