"""From bytes to events: lines, JSON, times."""

import gzip
import json
import os
import zlib
from collections.abc import Iterable
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from s7check.log import lines as lines_module
from s7check.log import source as source_module
from s7check.log.encoding import as_utf8
from s7check.log.errors import UnusableLogError
from s7check.log.lines import split_lines
from s7check.log.reader import read_log
from s7check.log.source import open_log
from tests.logs import BEGIN, HEADER, at, event, log_text


def events_of(chunks: Iterable[bytes]) -> list[dict[str, Any]]:
    """All events of a log."""
    return [event for batch in read_log(chunks) for event in batch.events]


def unusable(*chunks: bytes) -> UnusableLogError:
    """The error of a log."""
    with pytest.raises(UnusableLogError) as caught:
        events_of(chunks)
    return caught.value


def test_batches() -> None:
    """The header comes first, events carry their line, blank lines count."""
    text = b"\n" + log_text(" \t", event("run"), "\r", event("stop", 31.5))
    (batch,) = read_log([text])
    assert batch.header is not None
    assert batch.header["cpu"] == "S7-400"
    assert [(event["line"], event["event"]) for event in batch.events] == [(4, "run"), (6, "stop")]


def test_crlf() -> None:
    """Lines may end in CR LF, the last may have no end."""
    text = log_text(event("run"), event("stop", 31.5)).replace(b"\n", b"\r\n").rstrip()
    assert [event["line"] for event in events_of([text])] == [2, 3]


@given(st.lists(st.integers(1, 400)))
def test_chunk_borders(cuts: list[int]) -> None:
    """How the bytes come does not matter."""
    text = log_text(event("run"), event("start", 31.5, ob=10), "", event("end", 31.5, ob=10))
    borders = [0, *sorted(set(cuts)), len(text)]
    pieces = [text[begin:end] for begin, end in pairwise(borders)]
    assert events_of(pieces) == events_of([text])


def test_lines_come_as_soon_as_they_are_complete() -> None:
    """A line is yielded with the chunk that ends it."""
    taken = []

    def chunks() -> Iterable[bytes]:
        for chunk in (b"a", b"b\nc", b"d\n", b"e"):
            taken.append(chunk)
            yield chunk

    come = [(len(taken), batch.first, batch.texts) for batch in split_lines(chunks())]
    assert [entry for entry in come if entry[2]] == [(2, 1, [b"ab"]), (3, 2, [b"cd"]), (4, 3, [b"e"])]


def test_longest_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """A longer line is refused at its number, whether it ends or not, after the lines before it."""
    monkeypatch.setattr(lines_module, "LONGEST_LINE", 4)
    assert [batch.texts for batch in split_lines([b"1234\n5678"])] == [[b"1234"], [b"5678"]]
    for chunks in ([b"a\nb\n12345\nc\n"], [b"a\nb\n12", b"345"], [b"a\nb\n1", b"2", b"3", b"45\n"]):
        batches = split_lines(chunks)
        assert next(batches).texts[:2] == [b"a", b"b"]
        with pytest.raises(UnusableLogError, match="line 3: expected a line of at most 4 bytes") as caught:
            list(batches)
        assert caught.value.line == 3


@pytest.mark.parametrize("text", [b"", b"\n", b" \r\n\n"])
def test_empty(text: bytes) -> None:
    """An empty log is unusable at line 1."""
    assert str(unusable(text)) == "line 1: expected a header; found an empty log"


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
    content = (mark + text).encode(encoding)
    chunks = [content[at : at + size] for at in range(0, len(content), size)]
    assert b"".join(as_utf8(chunks)) == text.encode()
    assert [entry["event"] for entry in events_of(chunks)] == ["run", "stop"]


def test_damaged_utf16() -> None:
    """The line is named; what is before it is read."""
    content = log_text(event("run")).decode().encode("utf-16")
    assert str(unusable(content + b"\n")) == "line 3: expected UTF-16; found half a character at its end"
    assert (
        str(unusable(content + '{"x_a": "\udc00"}'.encode("utf-16-le", "surrogatepass")))
        == "line 3: expected whole characters; found a lone surrogate"
    )


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
    batches = read_log([log_text(event("run"), "oops")])
    assert [event["line"] for event in next(batches).events] == [2]
    with pytest.raises(UnusableLogError, match=r"^line 3: "):
        next(batches)


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


def test_broken_gzip_has_a_line(tmp_path: Path) -> None:
    """What could be unpacked is read first, the error stands at the line after it."""
    path = tmp_path / "log.gz"
    path.write_bytes(gzip.compress(log_text(event("run"))) + b"garbage")
    with open_log(str(path)) as source:
        batches = read_log(source.chunks())
        assert [event["line"] for event in next(batches).events] == [2]
        with pytest.raises(UnusableLogError, match="line 3: expected a sound gzip file"):
            next(batches)


def test_log_that_cannot_be_opened(tmp_path: Path) -> None:
    """Missing files, folders and impossible names are unusable, without a line."""
    for name in (str(tmp_path / "missing"), str(tmp_path), "a\0b", "x" * 5000):
        with pytest.raises(UnusableLogError) as caught, open_log(name):
            pass
        assert caught.value.line == 0


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
    """No bytes whatever cause another exception than the one."""
    try:
        events_of(pieces)
    except UnusableLogError as error:
        # The log may be usable as well, so this is no case for pytest.raises.
        if error.line < 1 or not str(error).isprintable():
            raise
