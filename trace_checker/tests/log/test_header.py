"""The header."""

import pytest

from s7check.log.errors import UnusableLogError
from tests.log.reading import read_header
from tests.logs import BEGIN, HEADER


def test_defaults() -> None:
    """A header of required fields only is filled in."""
    assert read_header(HEADER) == {
        "cpu": "S7-400",
        "obs": [1, 10, 80, 85, 100],
        "clock": {"min": BEGIN, "ms": 30_000},
        "mode": "STOP",
        "latency": 10,
        "zone": 0,
        "cycle": False,
        "classes": [],
        "queue": [],
        "priority": [],
        "step7": [],
        "readings": [],
        "profile": "",
        "records": ["call", "ob", "clock", "mode", "interrupt", "load"],
    }


def test_everything_given() -> None:
    """Every field, and own fields on every level."""
    header = HEADER | {
        "obs": [80, 1],
        "mode": "RUN",
        "latency_ms": 0,
        "records": ["diag"],
        "cycle": True,
        "priority": {"20": 3, "10": 0, "x_own": None},
        "step7": {
            "tod": {
                "11": {"execution": "daily", "start": "2026-11-21T05:59:59", "active": True, "x_own": [1]},
                "12": {"deselected": True},
            }
        },
        "readings": {"AMB-02": "a"},
        "x_own": {"any": {"thing": 1.5}},
    }
    normalised = read_header(header)
    assert normalised["obs"] == [1, 80]
    assert (normalised["mode"], normalised["latency"], normalised["cycle"]) == ("RUN", 0, True)
    assert normalised["records"] == ["diag"]
    assert normalised["priority"] == [[20, 3], [10, 0]]
    assert normalised["step7"] == [
        {"ob": 11, "execution": "daily", "start": BEGIN, "active": True, "deselected": False, "local": False},
        {"ob": 12, "execution": "none", "start": -1, "active": False, "deselected": True, "local": False},
    ]
    assert normalised["readings"] == [["AMB-02", "a"]]


@pytest.mark.parametrize("field", ["format", "cpu", "obs", "clock"])
def test_required(field: str) -> None:
    """The error names the field that is missing."""
    header = {name: value for name, value in HEADER.items() if name != field}
    with pytest.raises(UnusableLogError) as caught:
        read_header(header)
    assert caught.value.field == field
    assert caught.value.found == "none"


REFUSED: list[tuple[str, object, str]] = [
    ("format", "s7-interrupt-log/2", "format"),
    ("cpu", "S7-1200", "cpu"),
    ("obs", 1, "obs"),
    ("obs", [1, True], "obs"),
    ("obs", [0], "obs"),
    ("obs", [123], "obs"),
    ("obs", [10, 10], "obs"),
    ("clock", "2026-02-30T00:00", "clock"),
    ("mode", "HOLD", "mode"),
    ("latency_ms", -1, "latency_ms"),
    ("latency_ms", 10.0, "latency_ms"),
    ("latency_ms", 2**31, "latency_ms"),
    ("records", ["calls"], "records"),
    ("records", ["call", "call"], "records"),
    ("records", "call", "records"),
    ("cycle", 1, "cycle"),
    ("priority", [], "priority"),
    ("priority", {"1": 2}, "priority.1"),
    ("priority", {"80": 26}, "priority.80"),
    ("priority", {"55": 3}, "priority.55"),
    ("priority", {"71": 3}, "priority.71"),
    ("priority", {"010": 3}, "priority.010"),
    ("priority", {"10": 1}, "priority.10"),
    ("priority", {"10": 24}, "priority.10"),
    ("priority", {"10": True}, "priority.10"),
    ("priority", {"70": 29}, "priority.70"),
    ("priority", {"81": 27}, "priority.81"),
    ("priority", {"85": 23}, "priority.85"),
    ("step7", {"delay": {}}, "step7.delay"),
    ("step7", {"tod": {"18": {}}}, "step7.tod.18"),
    ("step7", {"tod": {"10": {"execution": "Daily"}}}, "step7.tod.10.execution"),
    ("step7", {"tod": {"10": {"execution": "daily"}}}, "step7.tod.10.start"),
    ("step7", {"tod": {"10": {"start": "2090-01-01T00:00"}}}, "step7.tod.10.start"),
    ("step7", {"tod": {"10": {"active": 0}}}, "step7.tod.10.active"),
    ("step7", {"tod": {"10": {"deselected": None}}}, "step7.tod.10.deselected"),
    ("step7", {"tod": {"10": []}}, "step7.tod.10"),
    ("readings", {"AMB-89": "a"}, "readings.AMB-89"),
    ("profile", "1998", "profile"),
    ("profile", 2006, "profile"),
    ("readings", {"AMB-00": "a"}, "readings.AMB-00"),
    ("readings", {"amb-02": "a"}, "readings.amb-02"),
    ("readings", {"AMB-02": "c"}, "readings.AMB-02"),
    ("readings", {"AMB-02": "A"}, "readings.AMB-02"),
    ("cycletime", 150, "cycletime"),
    ("a\x1b[2J", 150, "a\\x1b[2J"),
]


@pytest.mark.parametrize(("field", "value", "path"), REFUSED)
def test_refused(field: str, value: object, path: str) -> None:
    """Each wrong value is refused with the path of its field."""
    with pytest.raises(UnusableLogError) as caught:
        read_header(HEADER | {field: value})
    assert caught.value.field == path


@pytest.mark.parametrize(
    ("ob", "classes"),
    [(10, (2, 23)), (23, (2, 23)), (38, (2, 23)), (47, (2, 23)), (72, (2, 28)), (81, (2, 26)), (85, (24, 26))],
)
def test_priority_classes(ob: int, classes: tuple[int, int]) -> None:
    """The ends of each range of classes, and 0 for a deselected OB [OBS-05, OBS-06]."""
    for level in (*classes, 0):
        header = HEADER | {"cpu": "CPU 318", "priority": {str(ob): level}}
        assert read_header(header)["priority"] == [[ob, level]]


def test_priority_on_s7_300() -> None:
    """The S7-300's classes are fixed."""
    with pytest.raises(UnusableLogError, match=r'field "priority": expected on .*S7-400.* only'):
        read_header(HEADER | {"cpu": "S7-300", "priority": {"10": 3}})


def test_event_instead_of_header() -> None:
    """A log that begins with an event lacks its header."""
    with pytest.raises(UnusableLogError, match='the header in the first line; found the event "run"'):
        read_header({"event": "run", "at": "2026-11-21T06:00"})
