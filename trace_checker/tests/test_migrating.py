"""``s7check migrate``."""

import json
from pathlib import Path

import pytest

from s7check import cli, resources
from s7check.migrating.table import read
from tests.logs import HEADER, RUN, event, log_text

LOG = (
    event("SET_TINT", ob=10, sdt="2026-11-21T06:00", period="W#16#0201", ret=0),
    event("ACT_TINT", 31.001, ob=10, ret=0),
    event("clock", 50, to="2026-11-21T06:00:05"),
    {"event": "start", "at": "2026-11-21T06:00:05.001", "ob": 80, "info": {"flt_id": "B#16#05"}},
    {"event": "end", "at": "2026-11-21T06:00:05.002", "ob": 80},
    {"event": "start", "at": "2026-11-21T06:00:05.003", "ob": 10},
    {"event": "end", "at": "2026-11-21T06:00:05.004", "ob": 10},
    {"event": "start", "at": "2026-11-21T06:01:00.001", "ob": 10},
    {"event": "stop", "at": "2026-11-21T06:01:30.001"},
)


@pytest.fixture
def log(tmp_path: Path) -> Path:
    """A log of an S7-400 whose clock was set by 15 s over a point."""
    path = tmp_path / "log.ndjson"
    path.write_bytes(log_text(*LOG, header=RUN))
    return path


def test_first_line_and_what_to_do(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """OB 80 does not come: line 5 is the first, and the run after it is no difference."""
    assert cli.main(["migrate", str(log)]) == 1
    out = capsys.readouterr().out
    assert f"{log}: on an S7-1500, first line that changes: 5" in out
    assert "MD-01 (clock, H): CLK-02, CLK-03 -> T15-90" in out
    assert "do:  Move the reaction to small steps from OB 80 into OB 10, behind CaughtUp." in out
    assert "T15-90 Set forward by less than 20 s" in out
    assert "\n7:" not in out
    assert "\n9:" not in out


def test_json_has_a_line_for_each_point(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The hints about OB 85 and SDT, and the line that does not come."""
    assert cli.main(["migrate", str(log), "--format", "json"]) == 1
    points = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [(point["line"], point["kind"]) for point in points] == [(1, "hint"), (2, "hint"), (5, "will")]
    assert [point["differences"][0]["id"] for point in points] == ["MD-09", "MD-29", "MD-01"]
    assert "start ob=10" in points[2]["instead"]


def test_page_has_both_timelines(log: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """OB 10 starts at once on the new CPU, where the old one has OB 80."""
    assert cli.main(["migrate", str(log), "--format", "html"]) == 1
    row = "<tr><td>2026-11-21T06:00:05.000</td><td></td><td>start ob=10</td></tr>"
    page = capsys.readouterr().out
    assert "<strong>start ob=80" in page
    assert row in page


def test_a_log_without_differences(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """DIS_AIRT is the same on both."""
    path = tmp_path / "log.ndjson"
    path.write_bytes(log_text(event("DIS_AIRT", ret=1), event("EN_AIRT", ret=0), header=RUN | {"obs": [1, 80]}))
    assert cli.main(["migrate", str(path)]) == 0
    assert capsys.readouterr().out == f"{path}: nothing of it changes on an S7-1500, as far as its texts say\n"


def test_priorities_are_kept_or_new(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """OB 21 interrupts OB 20 with the priorities of the old CPU, not with those of a new project."""
    lines = (
        event("SRT_DINT", ob=20, dtime=100, sign=1, ret=0),
        event("SRT_DINT", 31.001, ob=21, dtime=200, sign=1, ret=0),
        event("start", 31.102, ob=20),
        event("start", 31.203, ob=21),
    )
    path = tmp_path / "log.ndjson"
    path.write_bytes(log_text(*lines, header=RUN | {"obs": [1, 20, 21]}))
    assert cli.main(["migrate", str(path)]) == 0
    assert cli.main(["migrate", "--new-project", str(path)]) == 1
    assert "MD-17" in capsys.readouterr().out


def test_hot_restart(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """No log of an S7-1500 can have it; the rest goes on after a warm one."""
    lines = (event("restart", type="hot"), event("run", 32))
    path = tmp_path / "log.ndjson"
    path.write_bytes(log_text(*lines, header=HEADER | {"obs": [1]}))
    assert cli.main(["migrate", str(path)]) == 1
    out = capsys.readouterr().out
    assert "MD-25 (modes, H)" in out
    assert "\n3:" not in out


def test_a_log_that_cannot_be_used(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The message names the line."""
    path = tmp_path / "log.ndjson"
    path.write_bytes(log_text("{}", header=RUN))
    assert cli.main(["migrate", str(path)]) == 2
    assert f"{path}:2: unusable: " in capsys.readouterr().err


def test_a_table_that_is_not_of_the_format(tmp_path: Path) -> None:
    """Without what to do a difference is of no use."""
    file = tmp_path / "table.txt"
    file.write_text("// table\n== MD-01 clock H CLK-02 -> T15-90\nwas: this\nis: that\nnone: nothing\n")
    with pytest.raises(ValueError, match="MD-01 clock H CLK-02 -> T15-90: expected a heading, was, is, do"):
        read(file)


MARKED = {
    "clock-over-point-without-ob80": (4, "MD-03"),
    "due-while-running-without-ob80": (5, "MD-11"),
    "due-twice-while-running": (7, "MD-36"),
    "missing-ob10-and-ob85": (4, "MD-08"),
    "missing-async-error-ob": (4, "MD-20"),
    "clock-back-s7-400": (5, "MD-05"),
}
"""Cases of the gallery: the line that a reviewer marked, and the difference, with the texts of both CPUs in hand and
before migrate was run on them. It missed MD-05, MD-20 and MD-36 then."""


@pytest.mark.parametrize("name", MARKED)
def test_what_a_reviewer_marked(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    """The line of each case has the difference, and only OB 85 in the header comes before it."""
    line, difference = MARKED[name]
    assert cli.main(["migrate", str(resources.GALLERY / f"{name}.ndjson"), "--format", "json"]) == 1
    points = [json.loads(text) for text in capsys.readouterr().out.splitlines()]
    found = [(point["line"], one["id"]) for point in points for one in point["differences"]]
    assert next(each for each in found if each != (1, "MD-09")) == (line, difference)
