"""The JSON Schema of the format: it takes the lines that the reader takes and refuses those that it refuses."""

import json
from collections.abc import Iterable
from typing import Any

import jsonschema_rs
import pytest

from s7check.engine.client import Engine
from s7check.log.calls import OPERANDS
from s7check.log.errors import UnusableLogError
from tests.log import test_events, test_header
from tests.log.reading import read_event
from tests.logs import HEADER, event
from tests.shipped import CASES
from tests.shipped import SCHEMA as FILE

SCHEMA = jsonschema_rs.validator_for(json.loads(FILE.read_text(encoding="utf-8")))
SCHEMA_OF_LINES = json.loads(FILE.read_text(encoding="utf-8"))["$defs"]


def test_shipped_logs() -> None:
    """Every line of every log that can be read is of the schema."""
    refused = [
        (case.id, number)
        for case in CASES
        if case.verdict != "unusable"
        for number, line in enumerate(case.lines, 1)
        if line.strip() and not SCHEMA.is_valid(json.loads(line))
    ]
    assert refused == []


def refuses(line: object) -> bool:
    """Whether the schema does; 10.0, which it calls an integer and the reader does not, is left to the reader."""
    return not SCHEMA.is_valid(line)


def is_whole(value: object) -> bool:
    """Whether a number is spelled with a fraction of 0."""
    return isinstance(value, float) and value.is_integer()


@pytest.mark.parametrize(
    ("field", "value"), [(field, value) for field, value, _ in test_header.REFUSED if not is_whole(value)]
)
def test_damaged_header(field: str, value: object) -> None:
    """What the reader refuses in a header, the schema refuses."""
    assert refuses(HEADER | {field: value})


def test_damaged_headers() -> None:
    """A required field that is missing, and classes on a CPU that has fixed ones."""
    assert all(refuses({name: value for name, value in HEADER.items() if name != field}) for field in HEADER)
    assert refuses(HEADER | {"cpu": "S7-300", "priority": {"10": 3}})


@pytest.mark.parametrize(
    "line", [line for line, _ in test_events.REFUSED if not any(is_whole(value) for value in line.values())]
)
def test_damaged_event(line: dict[str, Any]) -> None:
    """What the reader refuses in an event, the schema refuses."""
    assert refuses(line)


@pytest.mark.parametrize("line", [line for line, _ in test_events.LEGAL])
def test_legal_event(line: dict[str, Any]) -> None:
    """What the reader takes, the schema takes."""
    assert not refuses(line | {"up": 5, "x_own": [{}]})


def test_words(real_engine: Engine) -> None:
    """OBs have the classes of the specification and 0, ambiguities its letters, families and editions its names."""
    words = real_engine.alternatives()

    def taken(field: str, values: Iterable[Any], name: str | None = None, **header: object) -> list[Any]:
        made = ((value, value if name is None else {name: value}) for value in values)
        return [value for value, said in made if not refuses(HEADER | header | {field: said})]

    for family, some in words.classes:
        if family in words.settable:
            classes = {ob: taken("priority", range(-1, 31), str(ob), cpu=family, obs=[1]) for ob in range(123)}
            assert {ob: levels for ob, levels in classes.items() if levels} == dict(some)
    for family, lacking in words.unknown:
        others = [ob for ob in range(1, 123) if not refuses(HEADER | {"cpu": family, "obs": [ob]})]
        assert others == [ob for ob in words.obs if ob not in lacking]
    letters = {
        name: taken("readings", "abcdefg", name) for name in (f"{a}-{n:02}" for a in ("AMB", "A15") for n in range(100))
    }
    assert {name: some for name, some in letters.items() if some} == words.readings
    properties = SCHEMA_OF_LINES["header"]["properties"]
    assert properties["cpu"]["enum"] == words.families
    assert properties["profile"]["anyOf"][0]["enum"] == words.profiles


def test_calls() -> None:
    """A call has its operands, and its RET_VAL behind them."""
    required = {name.removeprefix("event_"): one.get("required", ()) for name, one in SCHEMA_OF_LINES.items()}
    calls = {name: (*fields,) for name, fields in required.items() if "ret" in fields}
    assert calls == {name: (*operands, "ret") for name, operands in OPERANDS.items()}


SPELLINGS: list[tuple[str, dict[str, Any], list[object], list[object]]] = [
    (
        "ret",
        event("DIS_AIRT"),
        ["w#16#80a1", "16#8", "B#16#80", -32768, 65535, None],
        ["B#16#080", "16#00201", "W#16#", -32769],
    ),
    (
        "mode",
        event("DIS_IRT", ob=10, ret=0),
        ["W#16#00A2", "b#16#a2", 255],
        ["16#0100", "B#16#0A2", -1],
    ),
    (
        "dtime",
        event("SRT_DINT", ob=20, sign=0, ret=0),
        ["T#1s500ms", "t#1S_500MS", "TIME#2m", "T#-24d_20h_31m_23s_648ms", -5],
        ["T#", "T#1s_", "T#1ms1s", "T#12345678901ms", "1s", 1.5],
    ),
    (
        "sdt",
        event("SET_TINT", ob=10, period=0, ret=0),
        ["2026-02-30T06:00", "DT#2026-2-3-6:0", "date_and_time#2026-11-21-06:00:00.5"],
        ["2026-2-3T06:00", "DT#2026-11-21T06:00", "2026-11-21T06:00Z"],
    ),
    (
        "to",
        event("clock"),
        ["1990-01-01T00:00", "DT#2089-12-31-23:59:59.999", "dt#2026-2-3-6:5:4.3"],
        ["1989-12-31T23:59", "2090-01-01T00:00", "2026-04-31T00:00", "2026-02-30T00:00", "DT#2026-2-30-0:0"],
    ),
]


@pytest.mark.parametrize(("field", "line", "legal", "illegal"), SPELLINGS, ids=[row[0] for row in SPELLINGS])
def test_spellings(field: str, line: dict[str, Any], legal: list[object], illegal: list[object]) -> None:
    """Words, bytes, durations and dates are spelled as the reader has them."""
    for value in legal:
        read_event(line | {field: value})
    for value in illegal:
        with pytest.raises(UnusableLogError):
            read_event(line | {field: value})
    assert [value for value in [*legal, *illegal] if not refuses(line | {field: value})] == legal
