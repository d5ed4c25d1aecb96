"""Logs as TLA+."""

from pathlib import Path

from evidence.common.cases import all_cases
from evidence.tla.log_as_tla import read, value


def test_fields(tmp_path: Path) -> None:
    """A log's header and lines have the fields that stand there, and not the number of the line."""
    (case,) = (case for case in all_cases() if case.name == "AIRT-03-nested-delay")
    header, events = read(case.put(tmp_path))
    assert header.startswith("[NoHeader EXCEPT !.")
    assert len(events) == len(case.lines) - 1
    assert all(event.startswith("[NoEvent EXCEPT !.") and "!.line" not in event for event in events)


def test_no_fields(tmp_path: Path) -> None:
    """TLA+ has no EXCEPT without a field."""
    file = tmp_path / "a.ndjson"
    header = '{"format":"s7-interrupt-log/1","cpu":"S7-300","obs":[1,40],"clock":"2026-03-02T08:00:00","mode":"RUN"}'
    file.write_text(f'{header}\n{{"at":"2026-03-02T08:00:01","event":"start","ob":40,"info":{{}}}}\n')
    assert "!.info = NoInfo," in read(file)[1][0]


def test_values() -> None:
    """JSON in TLA+; TLC reads no 2147483648 to negate."""
    assert value({"a": True, "b": ["x", -1]}) == '[a |-> TRUE, b |-> <<"x", -1>>]'
    assert value(-(2**31)) == "(-2147483647 - 1)"
    assert value(-(2**31) + 1) == "-2147483647"
