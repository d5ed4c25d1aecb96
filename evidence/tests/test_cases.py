"""The notation of cases, and the logs that are written out."""

import gzip
import json
from pathlib import Path

import pytest

from evidence import cli
from evidence.common.cases import Case, CasesError, all_cases, read_cases

DEFAULTS = "cpu=S7-300 obs=1,10 clock=2026-03-02T08:00:30.000 mode=RUN\n"


def cases(folder: Path, text: str) -> list[Case]:
    """The cases of a file with these lines behind its defaults."""
    file = folder / "AREA.txt"
    file.write_text(DEFAULTS + text, encoding="utf-8")
    return list(read_cases(file))


def lines(folder: Path, text: str) -> list[dict[str, object]]:
    """The objects of the log of one case."""
    (case,) = cases(folder, text)
    return [json.loads(line) for line in case.lines]


def test_a_case(tmp_path: Path) -> None:
    """What its lines say of it, and its log."""
    text = "// x\n== a R3 TINT-01 AMB-02\n# Why it\n# is so.\ncycle=true\n0:31 set 10 09:00 0201 0\n1:00 end 10\n"
    (case,) = cases(tmp_path, text)
    assert (case.id, case.file, case.place) == ("AREA/a", "AREA/reject/a.ndjson", 3)
    assert (case.verdict, case.line, case.requirements) == ("rejected", 3, ["TINT-01", "AMB-02"])
    assert case.reason == "Why it is so."
    assert [json.loads(line) for line in case.log.splitlines()] == [
        {
            "format": "s7-interrupt-log/1",
            "cpu": "S7-300",
            "obs": [1, 10],
            "clock": "2026-03-02T08:00:30.000",
            "mode": "RUN",
            "cycle": True,
        },
        {
            "at": "2026-03-02T08:00:31.000",
            "event": "SET_TINT",
            "ob": 10,
            "sdt": "2026-03-02T09:00",
            "period": "W#16#0201",
            "ret": "W#16#0000",
        },
        {"at": "2026-03-02T08:01:00.000", "event": "end", "ob": 10},
    ]


def test_header_fields(tmp_path: Path) -> None:
    """Each group of fields, with the defaults of the file."""
    text = (
        "== a A\ncpu=CPU_318 AMB-01=b AMB-02=c priority.10=3 latency_ms=5 profile=1997 records=call,ob\n"
        "step7.10=once,2026-03-02T09:00,active step7.11=deselected\n"
        "== b A\n"
    )
    first, second = (json.loads(case.lines[0]) for case in cases(tmp_path, text))
    assert first["cpu"] == "CPU 318"
    assert first["readings"] == {"AMB-01": "b", "AMB-02": "c"}
    assert first["priority"] == {"10": 3}
    assert (first["latency_ms"], first["profile"], first["records"]) == (5, "1997", ["call", "ob"])
    assert first["step7"]["tod"] == {
        "10": {"execution": "once", "start": "2026-03-02T09:00", "active": True},
        "11": {"deselected": True},
    }
    assert second.keys() == {"format", "cpu", "obs", "clock", "mode"}


@pytest.mark.parametrize(
    ("line", "fields"),
    [
        ("1:00 start 10", {"at": "2026-03-02T08:01:00.000"}),
        ("9:01:00.5 start 10", {"at": "2026-03-02T09:01:00.500"}),
        ("2026-03-03T08:00:01 start 10", {"at": "2026-03-03T08:00:01"}),
        ("1:00 start 10 up=5 flt_id=5 ev=1", {"up": 5, "info": {"flt_id": "B#16#05", "ev": "W#16#0001"}}),
        ("1:00 start 10 time=1:00", {"info": {"time": "2026-03-02T08:01:00.000"}}),
        ("1:00 diag 4568 - 26 ev_ob=10", {"id": "W#16#4568", "priority": 26, "info": {"ev_ob": 10}}),
        ("1:00 state 10 active=true left=7", {"active": True, "left": 7}),
        ("1:00 act 10 null", {"ret": None}),
        ("1:00 qry 9 8090", {"ob": 9, "ret": "W#16#8090"}),
        ("1:00 clock 2:00", {"to": "2026-03-02T08:02:00.000"}),
    ],
)  # fmt: skip
def test_events(line: str, fields: dict[str, object], tmp_path: Path) -> None:
    """Operands by place and by name; a time ends like the one of the header's clock."""
    _, event = lines(tmp_path, f"== a A\n{line}\n")
    assert {name: event.get(name) for name in fields} == fields
    assert set(event) - set(fields) <= {"at", "event", "ob"}


def test_a_time_is_as_fine_as_the_clock(tmp_path: Path) -> None:
    """Where the header's clock has no milliseconds, a time has those that it is written with."""
    _, first, second = lines(tmp_path, "== a A\nclock=2026-03-02T08:00:30\n0:31 hold\n0:32.0 release\n")
    assert (first["at"], second["at"]) == ("2026-03-02T08:00:31", "2026-03-02T08:00:32.000")


def test_several_events_in_a_line(tmp_path: Path) -> None:
    """Each is a line of the log; one without a time has that of the event before it."""
    events = lines(tmp_path, "== a A\n0:31 hold; release; 0:32 hold\n")[1:]
    assert [(event["event"], event["at"]) for event in events] == [
        ("hold", "2026-03-02T08:00:31.000"),
        ("release", "2026-03-02T08:00:31.000"),
        ("hold", "2026-03-02T08:00:32.000"),
    ]


def test_raw_lines(tmp_path: Path) -> None:
    """They stand in the log as they are; the first line of a case is then no header of ours."""
    first, second = cases(tmp_path, "== a A\n0:31 hold\n| {} \n|\n== b U1\n| []\n0:31 hold\n")
    assert [line.strip() for line in first.lines[2:]] == [b"{}", b""]
    assert second.lines[0] == b"[]"
    assert len(second.lines) == 2


def test_bytes_of_the_file(tmp_path: Path) -> None:
    """Ends of lines, another encoding, a packed file."""
    text = "== a A\nas=crlf,cut\n0:31 hold\n== b U1\nas=latin-1\n| é\n== c A\nas=gzip\n0:31 hold\n== d U1\nas=cut\n|\n"
    a, b, c, d = cases(tmp_path, text)
    assert (a.log.count(b"\r\n"), a.log.endswith(b"}")) == (1, True)
    assert b.log == b"\xe9\n"
    assert gzip.decompress(c.log).splitlines() == c.lines
    assert c.file == "AREA/accept/c.ndjson.gz"
    assert d.log == b""


def test_ends(tmp_path: Path) -> None:
    """A beginning with several ends is a case for each end."""
    text = (
        "== a TINT-01\n0:31 hold\n-> A # So far all is well.\n"
        "-> R TINT-02 0:32 release; run # No.\n-> A release # At once.\n"
    )
    so_far, no, at_once = cases(tmp_path, text)
    assert [case.id for case in (so_far, no, at_once)] == ["AREA/a-1", "AREA/a-2", "AREA/a-3"]
    assert (so_far.verdict, len(so_far.lines), so_far.requirements) == ("accepted", 2, ["TINT-01"])
    assert (no.verdict, no.line, no.requirements, no.reason) == ("rejected", 4, ["TINT-02"], "No.")
    assert json.loads(at_once.lines[2])["at"] == "2026-03-02T08:00:31.000"


@pytest.mark.parametrize(
    ("text", "line", "expected"),
    [
        ("== a A\n0:31 activate 10\n", 3, "one of set, act"),
        ("== a A\n0:31 act 10 0000 0000\n", 3, "act OB RET"),
        ("== a A\n0:31 act ten\n", 3, "a whole number for ob"),
        ("== a A\n0:31 act 10 00G0\n", 3, "a hexadecimal number for ret"),
        ("== a A\nhold\n", 3, "FIELD=VALUE"),
        ("== a A\n31 hold\n", 3, "a time"),
        ("== a A\n0:31 hold;\n", 3, "one of set, act"),
        ("== a A\n== a A\n", 3, "another name"),
        ("== a X\n", 2, "FIELD=VALUE"),
        ("== a\n", 2, "a verdict"),
        ("== a A\nas=zip\n", 3, "one of crlf"),
        ("== a A obs=1,two\n", 2, "a whole number for obs"),
        ("== a-2 A\n== a\n-> A\n-> A\n", 3, "another name than a-2"),
    ],
)
def test_wrong_lines(text: str, line: int, expected: str, tmp_path: Path) -> None:
    """The message has file, line and what is expected."""
    with pytest.raises(CasesError) as caught:
        cases(tmp_path, text)
    assert str(caught.value).startswith(f"{tmp_path / 'AREA.txt'}:{line}: expected {expected}")


def test_no_cases(tmp_path: Path) -> None:
    """A folder without a case file is none of cases."""
    with pytest.raises(FileNotFoundError, match="no case file"):
        all_cases(tmp_path)


def test_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The logs of all cases are written; what was in the folder before is gone."""
    (tmp_path / "old").touch()
    assert cli.main(["views", "cases", "--output", str(tmp_path)]) == 0
    written = [path for path in tmp_path.rglob("*") if path.is_file()]
    assert capsys.readouterr().out == f"{tmp_path}: {len(written)} logs\n"
    assert {path.relative_to(tmp_path).as_posix(): path.read_bytes() for path in written} == {
        case.file: case.log for case in all_cases()
    }


def test_elapsed_time(tmp_path: Path) -> None:
    """It goes on with the clock, whatever the clock is set to."""
    events = lines(tmp_path, "== a A up=5\n0:31 clock 9:00:00\n9:00:01 hold; 60:02 release\n")[1:]
    assert [event["up"] for event in events] == [1005, 2005, 3005]
    assert events[2]["at"] == "2026-03-02T09:00:02.000"


def test_a_line_that_goes_on(tmp_path: Path) -> None:
    """A space at its beginning says so."""
    (case,) = cases(tmp_path, "== a A\n# Why\n  it is so.\n0:31\n hold\n")
    assert (case.reason, len(case.lines)) == ("Why it is so.", 2)
