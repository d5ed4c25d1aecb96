"""Entries of the diagnostic buffer: their bytes, and what they tell of the mode."""

from datetime import datetime, timedelta
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from s7check.importing.asking import Imported, entries_of, kind_of, log_of
from s7check.importing.errors import SourceError

TIME = "2611210559300007"
"""2026-11-21T05:59:30.000, a Saturday."""


def records(*codings: str) -> bytes:
    """Records a second apart, given oldest first, as the CPU has them: newest first."""
    packed = [bytes.fromhex(f"{coding}26112105593{second}0007") for second, coding in enumerate(codings)]
    return b"".join(reversed(packed))


GIVEN = {"cpu": "S7-400", "obs": [1]}


def read(content: bytes, kind: str = "szl") -> Imported:
    """The log of a buffer; the mode is RUN where the buffer does not tell it, and the header has no such field then."""
    try:
        return log_of(content, kind, GIVEN)
    except SourceError as error:
        if 'field "mode"' not in str(error):
            raise
        imported = log_of(content, kind, GIVEN | {"mode": "RUN"})
        del imported.log[0]["mode"]
        return imported


def imported(*codings: str) -> Imported:
    """The log of records given oldest first."""
    return read(records(*codings))


def names(imported: Imported) -> list[str]:
    """The mode events."""
    return [event["event"] for event in imported.log[1:] if event["event"] != "diag"]


@pytest.mark.parametrize(
    ("coding", "fields"),
    [
        (
            "3502 1A50 C358 0000 1136 0C23",
            {"ob": 80, "priority": 26, "info": ["B#16#02", "W#16#0000", "W#16#1136", 35]},
        ),
        (
            "3502 1A50 C358 0201 1111 020A",
            {"ob": 80, "priority": 26, "info": ["B#16#02", "W#16#0201", "W#16#1111", 10]},
        ),
        ("3501 1C50 0000 0096 1103 0101", {"ob": 80, "priority": 28, "info": ["B#16#01", "W#16#0096", "W#16#1103", 1]}),
        ("3505 1A50 C358 0001 0000 0000", {"ob": 80, "priority": 26, "info": ["B#16#05", "W#16#0001"]}),
        ("350A 1A50 C358 0012 0000 0000", {"ob": 80, "priority": 26, "info": ["B#16#0A", "W#16#0012"]}),
        ("3503 1A50 C358 0012 0000 0000", {"ob": 80, "priority": 26, "info": ["B#16#03"]}),
        (
            "35A2 1A55 C358 0201 1111 0101",
            {"ob": 85, "priority": 26, "info": ["B#16#A2", "W#16#0201", "W#16#1111", 1]},
        ),
        ("35A3 1955 C358 0201 1111 0101", {"ob": 85, "priority": 25, "info": ["B#16#A3"]}),
        ("39C4 1956 C054 1FFF 1FF4 0111", {"ob": 86, "priority": 25}),
        ("38C4 FE56 C054 1FFF 1FF4 0111", {"ob": 86}),
        ("1381 1B64 C700 4304 1404 7710", {"ob": 100, "priority": 27, "info": {"strt_info": "B#16#81"}}),
        ("A146 0101 59C9 0200 0000 0020", {"ob": 1, "priority": 1}),
        ("5380 FFFF 0000 0000 0000 0000", {}),
        ("4300 FF46 C700 0000 0000 0000", {}),
    ],
)
def test_fields(coding: str, fields: dict[str, Any]) -> None:
    """Bytes become fields where their meaning is known, and stand there as they are."""
    if isinstance(fields.get("info"), list):
        fields = fields | {"info": dict(zip(["flt_id", "error_info", "ev", "ev_ob"], fields["info"], strict=False))}
    expected = {"event": "diag", "at": "2026-11-21T05:59:30.000", "id": f"W#16#{coding[:4]}", **fields}
    assert imported(coding).log[1] == expected | {"x_coding": coding}


def test_answer_with_its_transport() -> None:
    """Four bytes stand before the header of the list in an answer on the network; their length has to fit."""
    data = records("4301 FF46 C700 0000 0000 0000", RUN)
    listed = bytes.fromhex("00A0 0000 0014 0002") + data
    answer = bytes.fromhex("FF09") + len(listed).to_bytes(2, "big") + listed
    assert read(answer) == read(answer.hex(" ").encode()) == read(data)
    assert kind_of(answer) == "szl"
    for wrong in (bytes.fromhex("FF09 0001") + listed, bytes.fromhex("0A09") + answer[2:]):
        with pytest.raises(SourceError):
            read(wrong)


def test_time_of_day_and_delay() -> None:
    """An entry of such an OB, if a CPU makes one, has its parameters."""
    ordinary = imported("1111 020A 0000 0201 0000 0000", "1121 0314 0000 1234 0000 05DC")
    assert [event["info"] for event in ordinary.log[1:]] == [
        {"strt_info": "B#16#11", "period": "W#16#0201"},
        {"strt_info": "B#16#21", "sign": "W#16#1234", "dtime": 1500},
    ]


RESTART = "4301 FF46 C700 0000 0000 0000"
RUN = "4302 FF68 C700 0000 0000 0000"


@pytest.mark.parametrize(
    ("codings", "mode", "events", "modes_complete"),
    [
        ([RESTART, RUN], "STOP", ["restart", "run"], True),
        ([RUN, "4303 FF84 C700 0000 0000 0000", RESTART], "STARTUP", ["run", "stop", "restart"], True),
        (["4568 FF84 C700 0000 0000 0000"], "RUN", ["stop"], True),
        (["4555 FF54 C700 0000 0000 0000"], "STARTUP", ["stop"], True),
        (["4562 FF44 C700 0000 0000 0000"], "STOP", [], True),
        (["4305 FF8A C700 0000 0000 0000", "4306 FFA8 C700 0000 0000 0000"], "RUN", ["hold", "release"], True),
        (["4305 FF8A C700 0000 0000 0000", "430A FFA4 C700 0000 0000 0000"], "RUN", ["hold", "stop"], True),
        # HOLD in STARTUP and back cannot be said.
        (["4305 FF6A C700 0000 0000 0000", "4306 FFA6 C700 0000 0000 0000", RUN], "STARTUP", ["run"], False),
        # Power failed in RUN: no entry of the STOP.
        ([RUN, "4300 FF46 C700 0000 0000 0000", RESTART], "STARTUP", ["run", "restart"], False),
        ([RUN, RESTART], "STARTUP", ["run", "restart"], False),
        # Bytes that contradict the event ID.
        (["4302 FF84 C700 0000 0000 0000"], None, [], False),
        (["4303 FF00 C700 0000 0000 0000"], None, [], False),
        # No change of the mode.
        (["4562 FF8D C700 0000 0000 0000"], None, [], False),
        (["3502 1A50 C358 0000 1136 0C23"], None, [], False),
        (["430E FF44 C700 0000 0000 0000"], None, [], False),
    ],
)
def test_modes(codings: list[str], mode: str | None, events: list[str], modes_complete: bool) -> None:
    """Mode events where unambiguous; the kind `mode` is complete only if none can be missing."""
    made = imported(*codings)
    assert made.log[0].get("mode") == mode
    assert names(made) == events
    assert made.log[0]["records"] == (["mode", "diag"] if modes_complete else ["diag"])


@pytest.mark.parametrize(
    ("startup", "request_", "kind"),
    [
        ("46", None, "warm"),
        ("45", None, None),
        ("45", "1381", "warm"),
        ("45", "1382", "warm"),
        ("45", "1385", "cold"),
        ("45", "1386", "cold"),
        ("46", "1385", None),
        ("47", None, "hot"),
        ("47", "1383", "hot"),
        ("47", "1384", "hot"),
        ("47", "1381", None),
        ("45", "1384", None),
    ],
)
def test_kind_of_restart(startup: str, request_: str | None, kind: str | None) -> None:
    """Editions disagree about the mode 5; the request that follows decides."""
    codings = [f"4301 FF{startup} C700 0000 0000 0000"]
    codings += [f"{request_} 1B64 C700 0000 0000 0000"] if request_ else []
    header, *events = imported(*codings, RUN).log
    restarts = [event["type"] for event in events if event["event"] == "restart"]
    assert restarts == ([kind] if kind else [])
    assert ("mode" in header["records"]) == bool(kind)


def test_request_of_another_restart() -> None:
    """Only the request before the next change of the mode counts."""
    made = imported("4301 FF45 C700 0000 0000 0000", RUN, "1381 1B64 C700 0000 0000 0000")
    assert names(made) == ["run"]


@pytest.mark.parametrize(
    ("ids", "mode", "events"),
    [
        ([0x4301, 0x1381, 0x4302], "STOP", ["restart", "run"]),
        ([0x4301, 0x4302], "STOP", ["run"]),
        ([0x4302, 0x4305, 0x430A], "STARTUP", ["run", "hold", "stop"]),
        ([0x4302, 0x4305, 0x4306], "STARTUP", ["run", "hold"]),
        ([0x4303], None, ["stop"]),
        ([0x4305], None, []),
    ],
)
def test_modes_by_event_ids_alone(ids: list[int], mode: str | None, events: list[str]) -> None:
    """A text without codings tells less, and nothing is added."""
    made = read(text(*reversed(ids)), "step7")
    assert made.log[0].get("mode") == mode
    assert names(made) == events


def text(*ids: int) -> bytes:
    """A text of entries without codings, the newest first."""
    lines = [
        f"Event {at} of 9: Event ID 16# {id_:04X}\n05:59:{30 - at}.000 21.11.2026\n" for at, id_ in enumerate(ids, 1)
    ]
    return "".join(lines).encode()


RAW = records("4568 FF84 C700 0000 0000 0000", "3502 1A50 C358 0000 1136 0C23")


@pytest.mark.parametrize(
    "content",
    [
        RAW,
        b"\x00\xa0\x00\x00\x00\x14\x00\x02" + RAW,
        b"\x01\xa0\x00\x02\x00\x14\x00\x02" + RAW,
        b"\x00\x14\x00\x02" + RAW,
        RAW.hex().encode(),
        RAW.hex(" ", 2).upper().encode(),
        b"16#" + RAW.hex(" ", 20).encode().replace(b" ", b"\r\n16#"),
        RAW + bytes(40),
    ],
)
def test_forms_of_szl(content: bytes) -> None:
    """Binary or digits, with or without the list's header, with slots that were never written."""
    made = read(content)
    assert [event["id"] for event in made.log[1:] if event["event"] == "diag"] == ["W#16#4568", "W#16#3502"]
    empty = len(content) // 20 - 2 if content.endswith(bytes(40)) else 0
    assert made.told[0] == f"{2 + empty} entries read, {empty} skipped; 3 events written"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (RAW[:-1], "expected records of 20 bytes of SZL 16#00A0; found 39 bytes"),
        (b"\x00\x11\x00\x00\x00\x14\x00\x02" + RAW, "expected records of 20 bytes of SZL 16#00A0; found 48 bytes"),
        (b"\x00\xa0\x00\x00\x00\x1c\x00\x02" + RAW, "header: expected records of 20 bytes; found records of 28"),
        (
            b"\x00\xa0\x00\x00\x00\x14\x00\x03" + RAW,
            "header: expected 2 records, as many as follow; found a count of 3",
        ),
        (
            RAW[:20] + b"\x45" * 12 + b"\x26\x13" + RAW[34:],
            "entry 2: expected a DATE_AND_TIME in BCD in the last eight",
        ),
        (
            RAW[:20] + b"\x45" * 12 + b"\x2a\x11" + RAW[34:],
            "entry 2: expected a DATE_AND_TIME in BCD in the last eight",
        ),
        (RAW.hex().encode()[:-1], "expected two hexadecimal digits a byte; found 79 digits"),
    ],
)
def test_szl_that_cannot_be_read(content: bytes, message: str) -> None:
    """One message: the entry, what was expected."""
    with pytest.raises(SourceError) as error:
        read(content)
    assert str(error.value).startswith(message)


def test_oldest_first() -> None:
    """The numbers tell which entry is the newest, whatever the order in the source."""
    entries = text(0x4303, 0x4302).replace(b"Event 2", b"\0Event 2").split(b"\0")
    assert read(b"".join(reversed(entries)), "step7").log == read(b"".join(entries), "step7").log


def test_no_entry() -> None:
    """A buffer of empty slots gives no log."""
    with pytest.raises(SourceError, match="expected an entry to import; found no entry"):
        read(bytes(100))


@given(st.datetimes(datetime(1990, 1, 1), datetime(2089, 12, 31)))
def test_bcd(moment: datetime) -> None:
    """Every DATE_AND_TIME of a CPU is read as what it is."""
    moment -= timedelta(microseconds=moment.microsecond % 1000)
    digits = moment.strftime("%y%m%d%H%M%S") + f"{moment.microsecond // 1000:03}{moment.isoweekday() % 7 + 1}"
    (entry,) = entries_of([bytes(12) + bytes.fromhex(digits)])
    assert entry.at == moment.isoformat(timespec="milliseconds")


@given(st.lists(st.binary(min_size=12, max_size=12).filter(any), min_size=1, max_size=8))
def test_any_coding_gives_a_usable_log(codings: list[bytes]) -> None:
    """Whatever the CPU writes into its entries, the log is of the format."""
    content = b"".join(coding + bytes.fromhex(TIME) for coding in codings)
    assert sum(event["event"] == "diag" for event in read(content).log[1:]) == len(codings)
