"""From bytes to events: lines, JSON, times."""

import gzip
import json
import os
import zlib
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from s7check.engine.answer import Unusable
from s7check.engine.client import Engine
from s7check.judging.check import check_log
from s7check.log import source as source_module
from s7check.log.encoding import as_utf8
from s7check.log.errors import UnusableLogError
from s7check.log.source import open_log
from s7check.report.report import Report
from tests.log.reading import content, events_of
from tests.logs import BEGIN, HEADER, at, event, log_text

LONGEST = 1024 * 1024
"""Bytes of the longest line."""


@pytest.fixture
def check_bytes(real_engine: Engine, tmp_path: Path) -> Callable[[bytes], Report]:
    """A function that judges a log."""

    def checked(log: bytes) -> Report:
        (tmp_path / "log").write_bytes(log)
        return check_log(str(tmp_path / "log"), real_engine, lambda _, __: None)

    return checked


def unusable(*chunks: bytes) -> Unusable:
    """The error of a log."""
    error = content(*chunks).unusable
    assert error is not None
    return error


def test_lines() -> None:
    """The header comes first, events carry their line, blank lines count."""
    text = b"\n" + log_text(" \t", event("run"), "\r", event("stop", 31.5))
    read = content(text)
    assert read.header is not None
    assert read.header["cpu"] == "S7-400"
    assert [(event["line"], event["event"]) for event in read.events] == [(4, "run"), (6, "stop")]


_ALIKE = (
    '{"event": "start", "at": "AT", "ob": 1}',
    '{"event":"start","at":"AT","ob":1,"info":{"priority":1,"time":"AT"}}',
    '{"event":"start","ob":1,"info":{"time":"AT"},"x_time":"AT","at":"AT"}',
    '{"event": "start", "at": "AT", "ob": 1, "x_a": {"at": "AT"}}',
    '{"event": "start", "at": "DT#2026-11-21-06:30", "ob": 1, "x_a": {"at": "AT"}}',
    '{"event": "start", "at": "2026-11-21T06:30", "ob": 1, "x_a": {"time": "AT"}}',
    '{"event": "start", "\\u0061t": "2026-11-21T06:30:00.000", "ob": 1, "x_a": {"at": "AT"}}',
    '{"event": "clock", "at": "AT", "to": "AT"}',
    '{"event": "SET_TINT", "at": "AT", "ob": 10, "sdt": "AT", "period": "16#0201", "ret": 0}',
    '{"event": "run", "at": "AT", "up": 17}',
    '{"event": "start", "at": "AT", "ob": 1, "ob": 1}',
)
"""Lines, of which a date is to stand for AT."""


@pytest.mark.parametrize("line", _ALIKE)
@pytest.mark.parametrize(
    "date", ["2026-11-21T07:00:00.001", "2028-02-29T23:59:59.999", "2026-11-31T07:00:00.000", "2026-11-21T07:00:00 001"]
)
def test_lines_like_an_earlier_one(line: str, date: str) -> None:
    """A line is read as if there had been none that differs from it in dates alone."""
    example, other = (line.replace("AT", each) for each in ("2026-11-21T06:30:00.000", date))
    alone, behind = content(log_text(other)), content(log_text(example, other))
    assert _without_line(behind.events[-1:]) == _without_line(alone.events) or behind.unusable is not None
    found = [None if one.unusable is None else (one.unusable.field, one.unusable.found) for one in (alone, behind)]
    assert found[0] == found[1]


def _without_line(events: list[dict[str, Any]]) -> list[dict[str, Any]]:
    return [{name: value for name, value in event.items() if name != "line"} for event in events]


def test_crlf() -> None:
    """Lines may end in CR LF, the last may have no end."""
    text = log_text(event("run"), event("stop", 31.5)).replace(b"\n", b"\r\n").rstrip()
    assert [event["line"] for event in events_of([text])] == [2, 3]


@settings(deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.lists(st.integers(1, 400)))
def test_chunk_borders(real_engine: Engine, cuts: list[int]) -> None:
    """How the bytes come does not matter."""
    text = log_text(event("restart", type="warm"), event("start", 31.001, ob=100), "", event("end", 31.5, ob=100))
    borders = [0, *sorted(set(cuts)), len(text)]
    real_engine.begin()
    for begin, end in pairwise(borders):
        real_engine.send(text[begin:end])
    answer = real_engine.finish()
    assert (answer.verdict, answer.events) == ("accepted", 3)


@pytest.mark.parametrize("size", [1000, 65536, 2 << 20])
def test_longest_line(real_engine: Engine, size: int) -> None:
    """A longer line is refused at its number, whether it ends or not, after the lines before it."""
    fits, long = (log_text(json.dumps({**event("load", ob=10), "x_": "x" * more})) for more in (LONGEST - 70, LONGEST))
    assert LONGEST - 20 < len(fits.splitlines()[1]) <= LONGEST
    for log, verdict, line in ((fits, "accepted", 0), (long, "unusable", 2), (long.rstrip(), "unusable", 2)):
        real_engine.begin()
        for begin in range(0, len(log), size):
            real_engine.send(log[begin : begin + size])
        answer = real_engine.finish()
        assert answer.verdict == verdict
        assert (answer.unusable.line if answer.unusable else 0) == line
        assert answer.unusable is None or answer.unusable.expected == f"a line of at most {LONGEST} bytes"


@pytest.mark.parametrize("text", [b"", b"\n", b" \r\n\n"])
def test_empty(text: bytes) -> None:
    """An empty log is unusable at line 1."""
    assert str(unusable(text).error()) == "line 1: expected a header; found an empty log"


@pytest.mark.parametrize(
    ("line", "field", "found"),
    [
        (b"run", None, "run at byte 1 (invalid character)"),
        (b'{"event": "run"', None, 'a line cut off after {"event": "run"'),
        (b"[1]", None, "a list"),
        (b"1", None, "1"),
        (b'{"x_a": NaN}', None, "NaN} at byte 9 (invalid character)"),
        (b'{"x_a": -Infinity}', None, "Infinity} at byte 10"),
        (b'{"x_a": 1e999}', None, "number out of range"),
        (b'{"x_a": 1e' + b"9" * 30 + b"}", None, "number out of range"),
        (b'{"x_a": ' + b"9" * 5000 + b"}", None, "integer value out of range"),
        (b'{"x_a": "\xff"}', None, "the byte 16#FF"),
        (b'{"x_\xff": 1}', None, "the byte 16#FF"),
        (b'{"x_a": "\xed\xa0\x80"}', None, "a lone surrogate"),
        (b'{"x_a": "\xed"}', None, "the byte 16#ED"),
        (b'{"x_a": "\\ud800"}', None, "a lone surrogate"),
        (b'{"x_a": "\\ud800\\n"}', None, "a lone surrogate"),
        (b'{"x_a": "\\\\ud800}', None, "a line cut off"),
        (b'{"x_a": "\\ud83d\\udc0c}', None, "a line cut off"),
        (b'{"x_a": "\\udc00x"}', None, "a lone surrogate"),
        (b'{"x_a": "\x1b"}', None, "(invalid character)"),
        (b"\xef\xbb\xbf{}", None, "a byte order mark"),
        (b"{} {}", None, "trailing characters"),
        (b"{'event': 'run'}", None, "at byte 2"),
        (b'{"x_a": ' + b"[" * 100_000, None, "too many levels of nesting"),
        (b'{"event": "run", "event": "run"}', "event", "it twice"),
        (b'{"x_a": 1, "x_a"\t: 1}', "x_a", "it twice"),
        (b'{"x_a": 1, "x\\u005fa": 1}', "x_a", "it twice"),
        (b'{"event": "start", "info": {"ev": 1, "ev": 1}}', "ev", "it twice"),
        (b'{"x_a": [{"b": {"c": 1, "c": 2}}]}', "c", "it twice"),
        (b'{"x_a": {"b\\n": 1, "b\\n": 2}}', "b\\n", "it twice"),
        (b"{}", "event", "none"),
    ],
)
def test_strict_json(line: bytes, field: str | None, found: str) -> None:
    """What is not an object of strict JSON is refused with the line, the field and what was found."""
    error = unusable(log_text(event("run")) + line + b"\n" + log_text())
    assert (error.line, error.field) == (3, field)
    assert found in error.found
    assert error.found.isprintable()


@pytest.mark.parametrize("size", [1, 2, 3, 1000])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be"])
def test_encodings(encoding: str, size: int) -> None:
    """A byte order mark is skipped, UTF-16 is read if it has one, in chunks of any size."""
    text = log_text(event("run", x_a="\u20ac \U0001f40c"), event("stop")).decode()
    mark = {"utf-16-le": "\ufeff", "utf-16-be": "\ufeff"}.get(encoding, "")
    log = (mark + text).encode(encoding)
    chunks = [log[at : at + size] for at in range(0, len(log), size)]
    assert b"".join(as_utf8(chunks)) == text.encode()
    assert [entry["event"] for entry in events_of(chunks)] == ["run", "stop"]


def test_damaged_utf16(check_bytes: Callable[[bytes], Report]) -> None:
    """The line is named; what is before it is read."""
    log = log_text(event("restart", type="warm")).decode().encode("utf-16")
    report = check_bytes(log + b"\n")
    assert (report.verdict, report.line) == ("unusable", 3)
    assert report.message == "expected UTF-16; found half a character at its end"
    error = unusable(log + '{"x_a": "\udc00"}'.encode("utf-16-le", "surrogatepass")).error()
    assert str(error) == "line 3: expected whole characters; found a lone surrogate"


def test_keys_in_strings_are_no_duplicates() -> None:
    """What looks like a key inside a string or stands once in several objects is fine."""
    own = {"x_note": 'say "event": and "ob" :', "x_a": [{"b": 1}, {"b": 2}], "x_n": 10**30, "x_deep": {"x_deep": {}}}
    assert len(events_of([log_text(json.dumps(event("run") | own))])) == 1


def test_up_is_filled_in() -> None:
    """Elapsed time follows the clock but for its settings, and `up` where it is given."""
    read = events_of(
        [
            log_text(
                event("run", 31),
                event("clock", 32, to="2026-12-24T00:00:10"),
                {"event": "stop", "at": "2026-12-24T00:00:11"},
                {"event": "restart", "type": "warm", "at": "2026-12-24T00:00:11", "up": 60_000},
                {"event": "clock", "at": "2026-12-24T00:00:12", "to": at(0), "up": 60_500},
                event("run", 5),
            )
        ]
    )
    ups = [event["up"]["min"] * 60_000 + event["up"]["ms"] for event in read]
    assert ups == [1000, 2000, 3000, 60_000, 60_500, 65_500]
    assert read[0]["at"] == {"min": BEGIN, "ms": 31_000}
    assert read[3]["up"] == {"min": 1, "ms": 0}


def test_up_after_lines_without_it() -> None:
    """Elapsed time stands still rather than run backward where `up` lags behind the clock."""
    read = events_of([log_text(event("run", 31), event("stop", 31.5, up=100), event("restart", 31.6, type="warm"))])
    assert [event["up"]["ms"] for event in read] == [1000, 1000, 1100]


@pytest.mark.parametrize(
    ("entries", "line", "field"),
    [
        ([event("run", 29.999)], 2, "at"),
        ([event("run", 31), event("stop", 30.999)], 3, "at"),
        ([event("clock", 31, to=at(40)), event("run", 39)], 3, "at"),
        ([event("clock", 29, to=at(40))], 2, "at"),
        ([event("run", 31, up=5), event("stop", 31, up=4)], 3, "up"),
        ([event("clock", 31, to=at(31), up=5), event("stop", 31, up=4)], 3, "up"),
        ([event("run", 31, up=5), event("stop", 31), event("restart", 31, type="warm", up=4)], 4, "up"),
    ],
)
def test_time_runs_forward(entries: list[dict[str, Any]], line: int, field: str) -> None:
    """Neither clock runs backward but where the CPU's is set."""
    error = unusable(log_text(*entries))
    assert (error.line, error.field) == (line, field)


def test_clock_set_unseen() -> None:
    """If settings of the clock are not logged, `at` may jump, also backward and without `up`."""
    header = HEADER | {"records": ["call", "ob"]}
    (read,) = events_of([log_text(event("run", 5, up=70), header=header)])
    assert (read["at"]["ms"], read["up"]["ms"]) == (5000, 70)
    (read,) = events_of([log_text(event("run", 5), header=header)])
    assert read["at"]["ms"] == 5000


def test_events_before_an_unusable_line_are_given() -> None:
    """The first line that decides may lie before the unusable one."""
    read = content(log_text(event("run"), "oops"))
    assert [event["line"] for event in read.events] == [2]
    assert read.unusable is not None
    assert read.unusable.line == 3


def read_file(path: Path) -> bytes:
    """The bytes of a log file."""
    with open_log(str(path)) as source:
        return b"".join(source.chunks())


def test_gzip(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Gzip files of several members and padding are unpacked in small pieces."""
    monkeypatch.setattr(source_module, "_UNPACKED", 7)
    monkeypatch.setattr(source_module, "CHUNK", 5)
    path = tmp_path / "log.gz"
    path.write_bytes(gzip.compress(b"one" * 100) + b"\0" * 20 + gzip.compress(b"") + gzip.compress(b"two") + b"\0")
    assert read_file(path) == b"one" * 100 + b"two"


@pytest.mark.parametrize(
    "content",
    [
        *(b"", b"plain text", b"\0\0", gzip.compress(b"text", mtime=0)[:-1], gzip.compress(b"text", mtime=0)[:5]),
        *(
            gzip.compress(b"text", mtime=0) + b"garbage",
            zlib.compress(b"text"),
            gzip.compress(b"text", mtime=0)[:-8] + b"12345678",
        ),
    ],
)
def test_broken_gzip(tmp_path: Path, content: bytes) -> None:
    """Whatever is wrong with a gzip file, it is unusable."""
    path = tmp_path / "log.gz"
    path.write_bytes(content)
    with pytest.raises(UnusableLogError, match="a sound gzip file"):
        read_file(path)


def test_broken_gzip_has_a_line(real_engine: Engine, tmp_path: Path) -> None:
    """What could be unpacked is judged first, the error stands at the line after it."""
    path = tmp_path / "log.gz"
    for first, verdict in ((event("restart", type="warm"), ("unusable", 3)), (event("hold"), ("rejected", 2))):
        path.write_bytes(gzip.compress(log_text(first) + b'{"half') + b"garbage")
        report = check_log(str(path), real_engine, lambda _, __: None)
        assert (report.verdict, report.line) == verdict
    path.write_bytes(b"")
    assert check_log(str(path), real_engine, lambda _, __: None).line == 1


def test_folder_without_logs(tmp_path: Path) -> None:
    """Of a folder it is said what it should hold."""
    expected = r"expected a folder with \*\.ndjson or \*\.jsonl in it; found a folder without any"
    with pytest.raises(UnusableLogError, match=expected), open_log(str(tmp_path)):
        pass


def test_reading_stops_when_told(tmp_path: Path) -> None:
    """`wait` is asked before each read."""
    path = tmp_path / "log"
    path.write_bytes(b"text")
    with open_log(str(path)) as source:
        assert list(source.chunks(lambda _: False)) == []
        assert list(source.chunks()) == [b"text"]
        assert (source.size, source.taken) == (4, 4)


def test_files_are_closed(tmp_path: Path) -> None:
    """The descriptor is closed after the log."""
    path = tmp_path / "log"
    path.write_bytes(b"")
    with open_log(str(path)) as source:
        fd = source.fd
    with pytest.raises(OSError, match="Bad file descriptor"):
        os.fstat(fd)


@given(st.lists(st.binary() | st.sampled_from([b"\n", log_text(event("run")), b'{"event":', b"]}", b'"x_a":1,', b"{"])))
def test_any_bytes(pieces: list[bytes]) -> None:
    """No bytes whatever cause anything but an error with a line and a text that can be printed."""
    try:
        error = content(*pieces).unusable
    except UnusableLogError:
        return  # half a character of UTF-16
    assert error is None or (error.line >= 1 and str(error.error()).isprintable())
