"""What a report of a rejected log says was expected: in the place of the line, or before it, the log is accepted."""

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from s7check import cli
from s7check.log.source import open_log
from s7check.log.values import instant, iso
from s7check.report.report import Report
from tests.logs import HEADER, event, log_text
from tests.shipped import CASES, TRACES, log_of

Judge = Callable[[Path], Report]
REJECTED = [TRACES / case.file for case in CASES if case.verdict == "rejected"]
MOST = 4
"""Items tried of one log: where calls are not recorded there may be thousands."""

SAID = re.compile(r"(.*), within (\d+) ms(?: of (.*))?")
"""What had to come before a line, the latency, and since when it could come."""


@pytest.fixture(scope="module")
def rejections(judge: Judge) -> list[tuple[Path, Report]]:
    """The rejected logs of the project and their reports."""
    return [(log, judge(log)) for log in REJECTED]


def lines_of(log: Path) -> list[bytes]:
    """The lines of a log, packed or not."""
    with open_log(str(log)) as source:
        return b"".join(source.chunks()).splitlines()


def in_place_of(line: dict[str, Any], item: str) -> dict[str, Any] | None:
    """The event that the item names, at the time of the line; None for what is no single event."""
    name, *pairs = item.split()
    fields: dict[str, Any] = dict(pair.split("=") for pair in pairs)
    if "ob" in fields:
        fields["ob"] = int(fields["ob"])
    if name == line["event"] and "ret" in line:
        answered = line | fields
        asks = name.startswith("QRY") and int(fields.get("ret", "1").removeprefix("16#"), 16) == 0
        return None if asks and "status" not in answered else answered
    if name == "call" or not fields:
        return None
    if name == "state":
        fields = {field: json.loads(str(value)) for field, value in fields.items()}
    if name in ("start", "diag"):
        of_line = {field: fields.pop(field) for field in ("ob", "id") if field in fields}
        words = {"time", "strt_info", "flt_id", "period", "sign", "error_info", "ev"}
        info = {field: value if field in words else json.loads(str(value)) for field, value in fields.items()}
        entry = {"id": line["id"]} if name == "diag" and "id" not in of_line else {}
        fields = of_line | entry | ({"info": info} if info else {})
    return {key: line[key] for key in ("at", "up") if key in line} | {"event": name} | fields


def with_line(log: Path, number: int, event: dict[str, Any], tmp_path: Path) -> Path:
    """The log up to this line, which is another."""
    changed = tmp_path / "changed.ndjson"
    changed.write_bytes(b"\n".join([*lines_of(log)[: number - 1], json.dumps(event).encode()]) + b"\n")
    return changed


def test_expected(rejections: list[tuple[Path, Report]], judge: Judge, tmp_path: Path) -> None:
    """Each item explains the line that it takes the place of."""
    tried, refused = 0, []
    for log, report in rejections:
        if report.late:
            continue
        assert report.event is not None
        assert report.line is not None
        others = (in_place_of(json.loads(report.event), item) for item in report.expected[:MOST])
        for other in filter(None, others):
            tried += 1
            if judge(with_line(log, report.line, other, tmp_path)).verdict != "accepted":
                refused.append((log.name, other))
    assert refused == []
    assert tried > 500


def test_stop_in_place_of_a_wrong_answer(judge: Judge, tmp_path: Path) -> None:
    """DIS_AIRT is active, the clock was set over a point, OB 80 is missing: the CPU may as well stop."""
    header = HEADER | {"obs": [1, 10, 100], "mode": "RUN", "cycle": True}
    calls = [
        event("SET_TINT", ob=10, sdt="2026-11-21T06:00", period="W#16#0201", ret=0),
        event("ACT_TINT", ob=10, ret=0),
        event("DIS_AIRT", ret=1),
        event("clock", 32, to="2026-11-21T06:10:30"),
    ]
    wrong = {"event": "EN_AIRT", "at": "2026-11-21T06:10:30.001", "ret": 3}
    log = tmp_path / "log.ndjson"
    log.write_bytes(log_text(*calls, wrong, header=header))
    report = judge(log)
    assert report.expected == ["EN_AIRT ret=16#0000", "stop cause=16#4568"]
    for item in report.expected:
        right = in_place_of(wrong, item)
        assert right is not None
        assert judge(with_line(log, 6, right, tmp_path)).verdict == "accepted"


def test_late(rejections: list[tuple[Path, Report]], judge: Judge, tmp_path: Path) -> None:
    """An OB that starts at the last moment that the report names is in time, a millisecond later it is not."""
    tried = 0
    for log, report in rejections:
        assert report.event is not None
        assert report.line is not None
        line = json.loads(report.event)
        for said in report.late:
            found = SAID.fullmatch(said)
            assert found is not None, said
            item, latency, since = found.groups()
            if since is None or "up" in line:
                continue
            tried += 1
            for more, verdict in ((0, "accepted"), (1, "rejected")):
                other = in_place_of(line | {"at": iso(instant(since) + int(latency) + more)}, item)
                assert other is not None
                assert judge(with_line(log, report.line, other, tmp_path)).verdict == verdict, (log.name, other)
    assert tried > 100


def test_message_of_a_late_line(rejections: list[tuple[Path, Report]]) -> None:
    """A line that comes too late is called so, and no other."""
    for log, report in rejections:
        too_late = (report.message or "").startswith("something had to come before this line")
        assert bool(report.late) == too_late, log.name
        assert [said.partition(", within ")[0] for said in report.late] == (report.expected if too_late else [])


@pytest.mark.parametrize("form", ["text", "html", "json", "junit", "sarif"])
def test_late_in_every_form(form: str, capsys: pytest.CaptureFixture[str]) -> None:
    """An OB 40 that starts a millisecond too late is expected before the line, not in its place."""
    log = log_of("OBS-01-hardware-interrupt-one-millisecond-late")
    assert cli.main(["trace", "--format", form, "--readings", "none", str(log)]) == 1
    out = capsys.readouterr().out
    assert "something had to come before this line" in out
    assert "start ob=40, within 10 ms of 2026-03-02T08:00:31.000" in out
    assert "set is empty" not in out
