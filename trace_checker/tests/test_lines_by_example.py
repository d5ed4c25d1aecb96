"""The engine reads lines by examples as the reader reads them: the same verdict, line and report."""

import json
from collections.abc import Callable, Iterator
from datetime import datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from s7check.engine.client import Engine
from s7check.judging import check
from s7check.judging.check import check_log
from s7check.log import events, source
from s7check.report.report import Report
from tests.logs import HEADER, log_text
from tests.shipped import CASES, TRACES

NEVER = 1 << 60
BEGIN = datetime.fromisoformat(HEADER["clock"])

Judge = Callable[[Path, bool], Report]


@pytest.fixture
def judge(real_engine: Engine, monkeypatch: pytest.MonkeyPatch) -> Judge:
    """Judges a log; the engine reads all lines that come after those of the first piece, or none."""
    monkeypatch.setattr(source, "CHUNK", 100)

    def judge(log: Path, by_engine: bool) -> Report:
        monkeypatch.setattr(check, "_READ_FIRST", 0 if by_engine else NEVER)
        return check_log(str(log), real_engine, lambda _, __: None)

    return judge


def test_shipped_logs(judge: Judge) -> None:
    """The first time most lines become examples, the second time they are read by them."""
    for case in CASES:
        log = TRACES / case.file
        assert judge(log, False) == judge(log, True) == judge(log, True)


def lines_of(seconds: float) -> Iterator[dict[str, Any]]:
    """Lines with each field that may differ, so many seconds after the begin."""
    at = (BEGIN + timedelta(seconds=seconds)).isoformat(timespec="milliseconds")
    up = int(1000 * seconds)
    yield {"event": "restart", "type": "warm", "at": at, "up": up, "x_seq": up, "x_text": at}
    yield {"event": "start", "ob": 100, "at": at, "up": up, "info": {"time": at, "priority": 27, "x_a": up}}
    yield {"event": "SET_TINT", "ob": 10, "at": at, "up": up, "sdt": at, "period": "W#16#0401", "ret": 0}
    yield {"event": "clock", "at": at, "up": up, "to": at}
    yield {"event": "state", "ob": 10, "at": at, "up": up, "active": False, "left": up}
    yield {"event": "end", "ob": 100, "at": at, "up": up}
    yield {"event": "run", "at": at, "up": up}
    yield {"event": "stop", "at": at, "up": up}


DATES = st.one_of(
    st.datetimes(datetime(1989, 12, 30), datetime(2090, 1, 2)).map(lambda d: d.isoformat(timespec="milliseconds")),
    st.integers(-3000, 3000).map(lambda ms: (BEGIN + timedelta(milliseconds=ms)).isoformat(timespec="milliseconds")),
    st.sampled_from(
        [
            *("2026-02-29T06:00:00.000", "2028-02-29T06:00:00.000", "2026-11-31T06:00:00.000", "2100-02-29T00:00"),
            *("2026-11-21T24:00:00.000", "2026-11-21T06:60:00.000", "2026-11-21T06:00:60.000", "2026-13-01T06:00:00"),
            *("2026-11-21T06:00", "2026-11-21T06:00:01", "2026-11-21T06:00:01.5", "2026-11-21T06:00:01.50"),
            *("2026-11-21T06:00:01.", "2026-11-21T06:00:01.0000", "2026-11-21T6:00", "2026-11-21 06:00:00.000", ""),
            *("DT#2026-11-21-06:00:00.000", "2026-00-10T06:00:00.000", "0000-00-00T00:00:00.000", "2026-11-21T06:00Z"),
        ]
    ),
)
NUMBERS = st.one_of(
    st.integers(-2, 4000),
    st.sampled_from([0x7FFF_FFFF, 0x8000_0000, events.VARYING["up"][2], events.VARYING["up"][2] + 1, 10**15, 10**30]),
    st.sampled_from([0.0, 1.5, 1e3, -0.0, None, True, "5"]),
)
ODD = st.sampled_from(
    [
        *('{"event":"run","at":"2026-11-21T05:59:31.000","up":007}', '{"event":"run","up":1,"up":1}', "", " \t\r", "x"),
        *(
            '{"event":"run","at":"2026-11-21T05:59:31.000","at":"2026-11-21T05:59:31.000"}',
            "[]",
            '{"a":1',
            "\x01",
            "\x00",
        ),
        *('{"event":"run","x_o":{"at":"2026-11-21T05:59:31.000"}}', '{"event":"run","at":"2026-11-21T05:59:31.000",}'),
        *('{"event":"run","at" : "2026-11-21T05:59:31.000"}', '{"event":"run","at":"2026-11-21T05:59:31.\\u0030"}'),
        *('{"event":"run","at":"2026-11-21T05:59:31.000","x_a":"\\"at\\":"}', '{"event":"run","x_é":1,"at":"\\"}'),
        *('{"event":"run","at":"2026-11-21T05:59:31.000","info":{"time":"2026-11-21T05:59:31.000"}}', '{"event"'),
        *('{"event":"run","at":"2026-11-21T05:59:31.000","x_i":{"time":"1990-01-01T00:00"}}', '{"x_":"\\ud800"}'),
    ]
)


@st.composite
def logs(draw: st.DrawFn) -> bytes:
    """A log whose second half repeats the first, but for some fields with other values and some odd lines."""
    lines = [line for second in (1, 2, 3) for line in lines_of(second)]
    for _ in range(draw(st.integers(0, 3))):
        line = lines[draw(st.integers(len(lines) // 3, len(lines) - 1))]
        holder = line["info"] if "info" in line and draw(st.booleans()) else line
        field = draw(st.sampled_from(sorted(holder)))
        holder[field] = draw(DATES if field in ("at", "to", "time", "sdt") else NUMBERS)
    texts = [json.dumps(line, separators=draw(st.sampled_from([(",", ":"), (", ", ": ")]))) for line in lines]
    for _ in range(draw(st.integers(0, 1))):
        texts.insert(draw(st.integers(1, len(texts))), draw(ODD))
    header = HEADER | {"records": draw(st.sampled_from([["mode", "call"], ["clock", "mode"], ["state"]]))}
    return log_text(*texts, header=header)


@settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(log=logs())
def test_other_values(judge: Judge, tmp_path_factory: pytest.TempPathFactory, log: bytes) -> None:
    """Values in and out of the plain form, dates that do not exist, clocks that run backward, lines of no sense."""
    file = tmp_path_factory.getbasetemp() / "log.ndjson"
    file.write_bytes(log)
    assert judge(file, False) == judge(file, True)


def test_varying_fields() -> None:
    """A field that may differ is read alike in every event that has it."""
    for path, (form, low, high) in events.VARYING.items():
        readers = {
            reader
            for fields in (*events.FIELDS.values(), *events.OPERANDS.values())
            for name, reader in fields.items()
            if name == path
        }
        assert len(readers) <= 1
        assert form in ("date", "number")
        assert 0 <= low < high


def test_questions(real_engine: Engine, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Lines like an example need no question; where there are too many questions the reader goes on."""
    monkeypatch.setattr(source, "CHUNK", 1000)
    monkeypatch.setattr(check, "_READ_FIRST", 0)
    monkeypatch.setattr(check, "_ASKED", 20)
    asked: list[int] = []
    read = check.Judging._read

    def counted(*args: Any) -> dict[str, Any] | None:
        asked.append(args[-1])
        return read(*args)

    monkeypatch.setattr(check.Judging, "_read", counted)
    header = HEADER | {"mode": "RUN"}
    time = {"at": "2026-11-21T05:59:31.000", "ret": None}
    alike = [{"event": "EN_AIRT", **time, "x_n": n} for n in range(3000)]
    file = tmp_path / "log.ndjson"

    file.write_bytes(log_text(*alike, header=header))
    report = check_log(str(file), real_engine, lambda _, __: None)
    assert (report.verdict, report.events, len(asked)) == ("accepted", 3000, 1)

    asked.clear()
    other = [{"event": "EN_AIRT", **time, "x_n": [n]} for n in range(3000)]
    file.write_bytes(log_text(*other, header=header))
    report = check_log(str(file), real_engine, lambda _, __: None)
    assert (report.verdict, report.events) == ("accepted", 3000)
    assert 20 < len(asked) < 3000
