"""Logs with so many explanations that the engine merges them."""

import s7check
from tests.logs import HEADER, event

HARDWARE = range(40, 48)
S7_1500 = HEADER | {
    "cpu": "S7-1500",
    "mode": "RUN",
    "obs": [1, 35, *HARDWARE, 80, 100],
    "queue": {"35": {"events": 1, "threshold": 1, "overflow": False}},
}


def test_what_was_told_stays() -> None:
    """OB 80 is told of an overload once; each hardware interrupt may have filled the queue of its class."""
    hardware = [event("interrupt", 33, ob=ob) for ob in [*HARDWARE, *HARDWARE]]
    log = [
        S7_1500,
        event("DIS_AIRT", ret=1),
        *(event("interrupt", second, ob=35) for second in (31, 32)),
        *hardware,
        *(event("interrupt", second, ob=35) for second in (34, 35)),
        event("EN_AIRT", 36, ret=0),
        event("start", 36, ob=80, info={"flt_id": 2}),
        event("end", 36, ob=80),
        event("start", 36, ob=40),
    ]
    report = s7check.check(log)
    assert (report.verdict, report.line) == ("accepted", None)
    assert "not all told apart" in report.message
