"""The events, field by field."""

from typing import Any

import pytest

from s7check.log.errors import UnusableLogError
from tests.log.reading import read_event
from tests.logs import BEGIN, at, event

SDT = {"year": 2026, "month": 2, "day": 30, "hour": 6, "minute": 0, "second": 0, "ms": 0}
TIME = {"min": BEGIN, "ms": 31_000}

LEGAL: list[tuple[dict[str, Any], dict[str, Any]]] = [
    (
        event("SET_TINT", ob=99, sdt="2026-02-30T06:00", period="16#0201", ret="W#16#8090"),
        {"ob": 99, "sdt": SDT, "period": 0x0201, "ret": 0x8090},
    ),
    (event("CAN_TINT", ob=-32768, ret=None), {"ob": -32768, "ret": -1}),
    (event("ACT_TINT", ob=10, ret=-32608), {"ob": 10, "ret": 0x80A0}),
    (event("QRY_TINT", ob=10, ret=0, status="16#0014"), {"ob": 10, "ret": 0, "status": 0x14}),
    (event("QRY_TINT", ob=10, ret=None), {"ob": 10, "ret": -1}),
    (event("QRY_DINT", ob=20, ret=-32624), {"ob": 20, "ret": 0x8090}),
    (
        event("SRT_DINT", ob=20, dtime="T#-5ms", sign="W#16#ABCD", ret=0),
        {"ob": 20, "dtime": -5, "sign": 0xABCD, "ret": 0},
    ),
    (event("CAN_DINT", ob=20, ret=0), {"ob": 20, "ret": 0}),
    (event("DIS_IRT", mode="B#16#82", ob=35, ret=0), {"mode": 0x82, "ob": 35, "ret": 0}),
    (event("EN_IRT", mode=255, ob=0, ret=0), {"mode": 255, "ob": 0, "ret": 0}),
    (event("DIS_AIRT", ret=1), {"ret": 1}),
    (event("EN_AIRT", ret="16#8080"), {"ret": 0x8080}),
    (event("start", ob=10), {"ob": 10}),
    (event("start", ob=10, info={}), {"ob": 10, "info": {}}),
    (
        event(
            "start",
            ob=80,
            info={
                "strt_info": 53,
                "flt_id": "B#16#02",
                "priority": "B#16#1A",
                "period": "16#0201",
                "sign": 1,
                "dtime": "T#1s",
                "error_info": -1,
                "ev": "16#1111",
                "ev_ob": 10,
                "time": at(31),
                "x_own": {},
            },
        ),
        {
            "ob": 80,
            "info": {
                "strt_info": 53,
                "flt_id": 2,
                "priority": 26,
                "period": 0x0201,
                "sign": 1,
                "dtime": 1000,
                "error_info": 0xFFFF,
                "ev": 0x1111,
                "ev_ob": 10,
                "time": TIME,
            },
        },
    ),
    (event("end", ob=122), {"ob": 122}),
    (event("clock", to=at(31)), {"to": TIME}),
    (event("restart", type="warm"), {"type": "warm"}),
    (event("restart", type="cold"), {"type": "cold"}),
    (event("restart", type="hot"), {"type": "hot"}),
    (event("run"), {}),
    (event("stop"), {}),
    (event("stop", cause="W#16#456D"), {"cause": 0x456D}),
    (event("hold"), {}),
    (event("release"), {}),
    (event("interrupt", ob=40), {"ob": 40}),
    (event("interrupt", ob=85, flt_id="B#16#A3"), {"ob": 85, "flt_id": 0xA3}),
    (event("load", ob=10), {"ob": 10}),
    (event("delete", ob=10), {"ob": 10}),
    (event("diag", id="16#3505"), {"id": 0x3505}),
    (
        event("diag", id=0x3505, ob=80, priority=26, info={"flt_id": 5}),
        {"id": 0x3505, "ob": 80, "priority": 26, "info": {"flt_id": 5}},
    ),
]


@pytest.mark.parametrize(("raw", "fields"), LEGAL, ids=lambda value: str(value.get("event", "")))
def test_legal(raw: dict[str, Any], fields: dict[str, Any]) -> None:
    """Every event, with `up` and an own field besides."""
    same = {"event": raw["event"], "at": TIME}
    assert read_event(raw) == same | fields
    up = {"min": 0, "ms": 5}
    assert read_event(raw | {"up": 5, "x_own": [{}]}) == same | fields | {"up": up, "counter": up}


CALL = event("SET_TINT", ob=10, sdt="2026-11-21T06:00", period=0, ret=0)
START = event("start", ob=10)


REFUSED: list[tuple[dict[str, Any], str]] = [
    (CALL | {"event": "set_tint"}, "event"),
    (CALL | {"event": None}, "event"),
    (CALL | {"event": ["SET_TINT"]}, "event"),
    ({"at": at(31), "ob": 10}, "event"),
    (CALL | {"at": "2026-02-30T06:00"}, "at"),
    (CALL | {"at": 5}, "at"),
    (CALL | {"up": -1}, "up"),
    (CALL | {"up": 1.0}, "up"),
    (CALL | {"up": "T#1s"}, "up"),
    (CALL | {"up": 10**15}, "up"),
    (CALL | {"ob": "10"}, "ob"),
    (CALL | {"ob": 10.0}, "ob"),
    (CALL | {"ob": True}, "ob"),
    (CALL | {"ob": 32768}, "ob"),
    (CALL | {"ob": -32769}, "ob"),
    (CALL | {"sdt": "2026-11-21"}, "sdt"),
    (CALL | {"sdt": 0}, "sdt"),
    (CALL | {"period": None}, "period"),
    (CALL | {"period": "daily"}, "period"),
    (CALL | {"ret": "abc"}, "ret"),
    (CALL | {"ret": 65536}, "ret"),
    (CALL | {"ret": 0.0}, "ret"),
    (CALL | {"status": 0}, "status"),
    (CALL | {"comment": ""}, "comment"),
    (CALL | {"X_own": ""}, "X_own"),
    (event("QRY_TINT", ob=10, ret=0), "status"),
    (event("QRY_DINT", ob=20, ret="16#0"), "status"),
    (event("QRY_TINT", ob=10, ret=0, status=None), "status"),
    (event("SRT_DINT", ob=20, dtime=2**31, sign=0, ret=0), "dtime"),
    (event("SRT_DINT", ob=20, dtime="1s", sign=0, ret=0), "dtime"),
    (event("SRT_DINT", ob=20, dtime=1, sign="", ret=0), "sign"),
    (event("DIS_IRT", mode=256, ob=10, ret=0), "mode"),
    (event("DIS_IRT", mode=-1, ob=10, ret=0), "mode"),
    (START | {"ob": 0}, "ob"),
    (START | {"ob": 32768}, "ob"),
    (START | {"info": None}, "info"),
    (START | {"info": {"flt": 1}}, "info.flt"),
    (START | {"info": {"time": "2026-02-30T06:00"}}, "info.time"),
    (START | {"info": {"flt_id": 256}}, "info.flt_id"),
    (START | {"info": {"period": None}}, "info.period"),
    (event("end", ob=10, info={}), "info"),
    (event("clock", to="2090-01-01T00:00"), "to"),
    (event("restart", type="luke"), "type"),
    (event("stop", cause=None), "cause"),
    (event("interrupt", ob=10), "ob"),
    (event("interrupt", ob=71, flt_id=1), "ob"),
    (event("interrupt", ob=True), "ob"),
    (event("interrupt", ob=80), "flt_id"),
    (event("interrupt", ob=85), "flt_id"),
    (event("interrupt", ob=82, flt_id=1), "flt_id"),
    (event("diag", id=70000), "id"),
    (event("diag", id=1, ob=256), "ob"),
]


@pytest.mark.parametrize(("raw", "field"), REFUSED)
def test_refused(raw: dict[str, Any], field: str) -> None:
    """Each wrong field is refused by its name."""
    with pytest.raises(UnusableLogError) as caught:
        read_event(raw)
    assert caught.value.field == field


@pytest.mark.parametrize(("raw", "fields"), LEGAL, ids=lambda value: str(value.get("event", "")))
def test_required(raw: dict[str, Any], fields: dict[str, Any]) -> None:
    """Without a required field an event is refused; `info`, `cause` and the like may be absent."""
    optional = {"info", "cause", "status"} | ({"ob", "priority"} if raw["event"] == "diag" else set())
    for name in {"at", *fields} - optional:
        with pytest.raises(UnusableLogError) as caught:
            read_event({field: value for field, value in raw.items() if field != name})
        assert caught.value.field == name
        assert caught.value.found == "none"


def test_second_header() -> None:
    """A header after the first line is refused as such."""
    with pytest.raises(UnusableLogError, match="expected an event; found a second header"):
        read_event({"format": "s7-interrupt-log/1"})
