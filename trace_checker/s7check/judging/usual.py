"""Logs in which nothing special happens: what their explanations come to is shown by every log."""

from typing import Any

_HEADER: dict[str, Any] = {
    "format": "s7-interrupt-log/1",
    "cpu": "S7-400",
    "obs": [1, 10, 20, 40, 80, 85, 100],
    "clock": "2026-11-21T06:00",
    "mode": "RUN",
}


def _event(minute: int, name: str, **fields: object) -> dict[str, Any]:
    return {"event": name, "at": f"2026-11-21T06:{minute:02}", **fields}


_NOTHING = _event(30, "clock", to="2026-11-21T06:30")
"""Half an hour has passed, and the clock is set to its own reading."""

IDLE: list[list[dict[str, Any]]] = [[_HEADER, _NOTHING], [_HEADER | {"mode": "STOP"}, _NOTHING]]
"""Logs in which nothing happens."""

_EVENTS = [
    [
        _HEADER,
        _event(1, "interrupt", ob=40),
        _event(1, "start", ob=40),
        _event(1, "end", ob=40),
        _event(2, "SET_TINT", ob=10, sdt="2026-11-21T06:03", period=0x1001, ret=0),
        _event(2, "ACT_TINT", ob=10, ret=0),
        _event(3, "start", ob=10),
        _event(3, "end", ob=10),
        _event(3, "CAN_TINT", ob=10, ret=0),
        _event(3, "SRT_DINT", ob=20, dtime=60000, sign=7, ret=0),
        _event(4, "start", ob=20),
        _event(4, "end", ob=20),
        _event(4, "SRT_DINT", ob=20, dtime=1000, sign=7, ret=0),
        _event(4, "CAN_DINT", ob=20, ret=0),
        _event(4, "DIS_IRT", mode=2, ob=40, ret=0),
        _event(4, "EN_IRT", mode=2, ob=40, ret=0),
        _event(5, "DIS_AIRT", ret=1),
        _event(5, "EN_AIRT", ret=0),
        _event(6, "stop"),
    ],
    [
        _HEADER | {"mode": "STOP"},
        _event(1, "restart", type="warm"),
        _event(1, "start", ob=100),
        _event(1, "end", ob=100),
        _event(1, "run"),
    ],
]

PLAIN: list[list[dict[str, Any]]] = [
    [header | {"cpu": cpu}, *events] for cpu in ("S7-300", "S7-400") for header, *events in _EVENTS
]
"""OBs that run alone, each call that sets something with success, a restart."""
