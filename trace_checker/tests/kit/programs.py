"""A small program for the tests."""

import copy
from typing import Any

PROGRAM: dict[str, Any] = {
    "format": "s7-interrupt-program/1",
    "name": "AIRT-nested",
    "about": "Delays nest: only the last EN_AIRT lets OB 35 start.",
    "requirements": ["AIRT-03"],
    "header": {"cpu": "S7-400", "obs": [1, 10, 35, 80, 85, 100], "clock": "2026-11-21T05:59:30", "mode": "RUN"},
    "duration": 5000,
    "outside": [
        {"after": 1000, "event": "interrupt", "ob": 35},
        {"after": 500, "event": "clock", "by": -60000},
        {"after": 1500, "event": "interrupt", "ob": 80, "flt_id": "16#01", "every": 2000},
    ],
    "bodies": [
        {
            "ob": 1,
            "run": 1,
            "steps": [
                {"call": "SET_TINT", "ob": 10, "sdt": "2026-02-30T06:00", "period": "W#16#0201"},
                {"call": "DIS_AIRT"},
                {"wait": 2000},
                {"event": "clock", "to": "2026-11-21T06:00"},
                {"end": True},
            ],
        },
        {"ob": 35, "steps": []},
    ],
}


def changed(path: str, value: object) -> dict[str, Any]:
    """The program with ``value`` at the path, such as ``bodies.1.run`` (lists from 1); None takes the field away."""
    program = copy.deepcopy(PROGRAM)
    place: Any = program
    *parents, last = path.split(".")
    for name in parents:
        place = place[int(name) - 1 if name.isdigit() else name]
    key: Any = int(last) - 1 if last.isdigit() else last
    if value is None:
        del place[key]
    else:
        place[key] = value
    return program
