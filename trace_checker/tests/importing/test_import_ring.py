"""The ring of the SCL instrumentation: its layout in the source, dumps of it, what they become.

Dumps are packed here byte by byte after the table in instrumentation/scl/README.md, without the
reader's own tables.
"""

import json
import re
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from s7check import cli
from s7check.importing.asking import Imported, events_of, log_of, slots_of
from s7check.importing.errors import SourceError

INSTRUMENTATION = Path(cli.__file__).parents[2] / "instrumentation" / "scl"
SOURCE = (INSTRUMENTATION / "s7log.scl").read_text(encoding="ascii")

SIZES = {"BYTE": 1, "WORD": 2, "INT": 2, "DWORD": 4, "DINT": 4, "TIME": 4, "DATE_AND_TIME": 8}


def bcd(time: str) -> bytes:
    """DATE_AND_TIME of ``2026-11-21T05:59:30.000``; the weekday is 0."""
    return bytes.fromhex(re.sub("[^0-9]", "", time)[2:] + "0")


def word(value: int) -> bytes:
    """Two bytes, whatever the sign."""
    return (value & 0xFFFF).to_bytes(2, "big")


def double(value: int) -> bytes:
    """Four bytes, whatever the sign."""
    return (value & 0xFFFFFFFF).to_bytes(4, "big")


NO_DATE = bcd("1990-01-01T00:00:00.000")


def entry(code: int, second: float, caller: int = 1, **fields: Any) -> dict[str, Any]:
    """An entry, made at that second of the minute 2026-11-21T05:59; the clock and TIME_TCK go alike."""
    at = f"2026-11-21T05:59:{second:06.3f}"
    return {"code": code, "clk": bcd(at), "tick": 5000 + round(second * 1000), "caller": caller, **fields}


def begins(ob: int, second: float, number: int = 0x11, priority: int = 2, **fields: Any) -> dict[str, Any]:
    """The entry of an OB that begins; it was requested 2 ms before."""
    stamp = bcd(f"2026-11-21T05:59:{second - 0.002:06.3f}")
    start = {"ob": ob, "ev_class": 0x11, "ev_num": number, "priority": priority, "stamp": stamp}
    return entry(200, second, ob, **start, **fields)


def packed(number: int, fields: dict[str, Any]) -> bytes:
    """A slot."""
    slot: bytes = double(number) + double(fields["tick"]) + fields["clk"]
    slot += word(fields["code"]) + bytes([fields["caller"], fields.get("mode", 0)])
    slot += word(fields.get("ob", 0)) + word(fields.get("info_1", 0)) + double(fields.get("info_2", 0))
    slot += word(fields.get("ret", 0)) + word(fields.get("status", 0)) + fields.get("stamp", NO_DATE)
    slot += bytes(fields.get(name, 0) for name in ("ev_class", "ev_num", "priority"))
    slot += bytes([fields.get("done", 1)])
    assert len(slot) == 44
    return slot


def dump(*entries: dict[str, Any], capacity: int = 20, later: int = 0) -> bytes:
    """A ring into which ``entries`` were written, the last ``later`` of them after its header was read."""
    slots = [bytes(44)] * capacity
    for number, fields in enumerate(entries, 1):
        slots[(number - 1) % capacity] = packed(number, fields)
    written = len(entries) - later
    header = word(0x5337) + word(1) + word(capacity) + word(44) + word(written % capacity) + word(0)
    return header + double(written) + double(max(0, written - capacity)) + b"".join(slots)


def read(content: bytes, entries: str | None = None) -> Imported:
    """The log of a dump."""
    return log_of(content, "ring", {"cpu": "S7-400", "obs": [1]}, entries=entries)


def imported(*entries: dict[str, Any], **options: Any) -> list[dict[str, Any]]:
    """The events of entries without their times."""
    found = read(dump(*entries, **options)).log[1:]
    return [{name: value for name, value in event.items() if name not in ("at", "up")} for event in found]


CALLS: list[tuple[dict[str, Any], dict[str, Any]]] = [
    (
        entry(28, 1, ob=10, stamp=bcd("2026-11-21T06:00:00.000"), info_1=0x1202),
        {"event": "SET_TINT", "ob": 10, "sdt": "2026-11-21T06:00:00.000", "period": "W#16#1202", "ret": "W#16#0000"},
    ),
    (entry(29, 1, ob=99, ret=-32624), {"event": "CAN_TINT", "ob": 99, "ret": "W#16#8090"}),
    (entry(30, 1, ob=10), {"event": "ACT_TINT", "ob": 10, "ret": "W#16#0000"}),
    (entry(31, 1, ob=10, status=0x14), {"event": "QRY_TINT", "ob": 10, "ret": "W#16#0000", "status": "W#16#0014"}),
    (
        entry(32, 1, ob=20, info_1=0xABCD, info_2=1500),
        {"event": "SRT_DINT", "ob": 20, "dtime": 1500, "sign": "W#16#ABCD", "ret": "W#16#0000"},
    ),
    (
        entry(32, 1, ob=-1, info_2=-5, ret=-32623),
        {"event": "SRT_DINT", "ob": -1, "dtime": -5, "sign": "W#16#0000", "ret": "W#16#8091"},
    ),
    (entry(33, 1, ob=20), {"event": "CAN_DINT", "ob": 20, "ret": "W#16#0000"}),
    (entry(34, 1, ob=20, status=0x10), {"event": "QRY_DINT", "ob": 20, "ret": "W#16#0000", "status": "W#16#0010"}),
    (entry(39, 1, ob=10, mode=0x81), {"event": "DIS_IRT", "mode": "B#16#81", "ob": 10, "ret": "W#16#0000"}),
    (entry(40, 1, ob=10, mode=2), {"event": "EN_IRT", "mode": "B#16#02", "ob": 10, "ret": "W#16#0000"}),
    (entry(41, 1, ret=3), {"event": "DIS_AIRT", "ret": "W#16#0003"}),
    (entry(42, 1, ret=-32640), {"event": "EN_AIRT", "ret": "W#16#8080"}),
    (entry(42, 1, done=0), {"event": "EN_AIRT", "ret": None}),
    (entry(31, 1, ob=10, done=0), {"event": "QRY_TINT", "ob": 10, "ret": None}),
    (
        entry(28, 1, ob=10, stamp=bcd("2026-02-31T25:00:00.000"), ret=-32623),
        {"event": "SET_TINT", "ob": 10, "sdt": "2026-02-31T25:00:00.000", "period": "W#16#0000", "ret": "W#16#8091"},
    ),
    (
        entry(51, 1, ob=20, status=0x14, info_2=1500),
        {
            "event": "state",
            "ob": 20,
            "blocked": False,
            "loaded": True,
            "entries_off": False,
            "active": True,
            "left": 1500,
        },
    ),
    (
        entry(51, 1, ob=35, status=0x42, info_2=7),
        {"event": "state", "ob": 35, "blocked": True, "loaded": False, "entries_off": True},
    ),
    (
        entry(0, 1, stamp=bcd("2026-12-24T18:00:00.000")),
        {"event": "clock", "to": "2026-12-24T18:00:00.000"},
    ),
]


@pytest.mark.parametrize(("written", "event"), CALLS, ids=[call[1]["event"] for call in CALLS])
def test_calls(written: dict[str, Any], event: dict[str, Any]) -> None:
    """Each SFC with what the program passed and what the CPU answered."""
    assert imported(written) == [event | {"x_ob": 1}]


@pytest.mark.parametrize(
    ("written", "info"),
    [
        (begins(10, 3, info_1=0x0201), {"strt_info": "B#16#11", "period": "W#16#0201", "priority": 2}),
        (
            begins(20, 3, number=0x21, priority=3, info_1=0x1234, info_2=1500),
            {"strt_info": "B#16#21", "sign": "W#16#1234", "dtime": 1500, "priority": 3},
        ),
        (begins(35, 3, number=0x36, priority=12), {"strt_info": "B#16#36", "priority": 12}),
        (
            begins(80, 3, number=2, priority=26, info_1=0x201, info_2=0x1111020A),
            {"flt_id": "B#16#02", "error_info": "W#16#0201", "ev": "W#16#1111", "ev_ob": 10, "priority": 26},
        ),
        (begins(86, 3, number=0xC4, priority=26, info_1=0x7FF), {"priority": 26}),
    ],
)
def test_start_information(written: dict[str, Any], info: dict[str, Any]) -> None:
    """An OB begins with what its start information says, and ends."""
    assert imported(entry(30, 1, ob=10), written, entry(201, 4, written["ob"], ob=written["ob"]))[1:] == [
        {"event": "start", "ob": written["ob"], "info": info | {"time": "2026-11-21T05:59:02.998"}},
        {"event": "end", "ob": written["ob"]},
    ]


def test_restart_and_run() -> None:
    """A startup OB proves a restart, the first cycle of OB 1 proves RUN."""
    for ob, number, kind, first in ((100, 0x81, "warm", 1), (101, 0x83, "hot", 2), (102, 0x85, "cold", 4)):
        header, *events = read(
            dump(begins(ob, 1, number), entry(201, 2, ob, ob=ob), begins(1, 3, first, 1), begins(1, 4, 3, 1))
        ).log
        assert header["mode"] == "STOP"
        assert [event["event"] for event in events] == ["restart", "start", "end", "run", "start", "start"]
        assert events[0]["type"] == kind


def test_clock_that_was_not_set() -> None:
    """A refused SET_CLK changes nothing and is counted."""
    told = read(dump(entry(30, 1, ob=10), entry(0, 2, ret=-32639))).told
    assert told[:2] == ["2 entries read, 1 skipped; 1 events written", "1 skipped: SET_CLK that did not set the clock"]


def test_state_that_was_not_read() -> None:
    """A system list that is still being read, or an index that the CPU refuses, is counted."""
    told = read(dump(entry(30, 1, ob=10), entry(51, 2, ob=20, done=0), entry(51, 3, ob=20, ret=-32637))).told
    assert told[:2] == ["3 entries read, 2 skipped; 1 events written", "2 skipped: RDSYSST that did not answer"]


def test_overwritten() -> None:
    """A full ring holds the newest entries; how many are lost is said."""
    made = read(dump(*(entry(30, second, ob=10 + second) for second in range(8)), capacity=5))
    assert [event["ob"] for event in made.log[1:]] == [13, 14, 15, 16, 17]
    assert (made.told[0], made.log[0]["mode"]) == ("5 entries read, 0 skipped; 5 events written", "RUN")
    assert "note: 3 older entries were overwritten in the ring" in made.told


def test_written_while_read() -> None:
    """Entries that came after the header was read are left for the next dump, so are those they overwrote."""
    made = imported(*(entry(30, second, ob=10 + second) for second in range(8)), capacity=5, later=2)
    assert [event["ob"] for event in made] == [13, 14, 15]


def test_begin_in_the_middle_of_an_ob() -> None:
    """Before the first entry of OB 1 or a startup OB it is unknown what is interrupted."""
    made = read(dump(entry(41, 1, 35), entry(201, 2, 35, ob=35), entry(30, 3, ob=10)))
    assert [event["event"] for event in made.log[1:]] == ["ACT_TINT"]
    assert "2 skipped: before the first entry of OB 1 or a startup OB" in made.told
    made = read(dump(entry(41, 1, 35), entry(30, 2, 100, ob=10), begins(1, 3, 1, 1)))
    assert made.log[0]["mode"] == "STARTUP"
    made = read(dump(begins(1, 3, 1, 1)))
    assert (made.log[0]["mode"], made.log[1]["event"]) == ("STARTUP", "run")


def test_entries() -> None:
    """--entries takes a part of the ring by the entries' numbers."""
    content = dump(*(entry(30, second, ob=10 + second) for second in range(8)), capacity=5)
    made = read(content, "6-7")
    assert [event["ob"] for event in made.log[1:]] == [15, 16]
    assert "3 skipped: outside --entries" in made.told


GOOD = dump(entry(30, 1, ob=10), entry(30, 2, ob=11))


def changed(at: int, content: bytes, source: bytes = GOOD) -> bytes:
    """A dump with other bytes."""
    return source[:at] + content + source[at + len(content) :]


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "expected a ring of at least 20 bytes; found 0 bytes"),
        (bytes(100), "expected a ring that begins with 16#5337; found 16#0000"),
        (changed(2, word(2)), "expected a ring of layout 1; found layout 2"),
        (changed(6, word(40)), "expected slots of 44 bytes, one at least; found 20 slots of 40"),
        (changed(4, word(-1)), "expected slots of 44 bytes, one at least; found -1 slots of 44"),
        (GOOD[:-1], "expected 900 bytes, for 20 slots; found 899 bytes"),
        (dump(), "expected an entry; found none"),
        (changed(12, double(7)), "expected entry 7, the newest one; found none"),
        (changed(28, b"\x26\x13"), "entry 1: expected a DATE_AND_TIME in BCD; found 2613 2105 5901 0000"),
        (changed(36, word(77)), "entry 1: expected the number of an SFC or 200 to 202 as its code; found 77"),
        (changed(38, b"\x23", dump(entry(30, 1))), "expected an entry of OB 1 or a startup OB to begin with; found"),
        (dump(entry(28, 1, stamp=b"\xff" * 8)), "entry 1: expected a DATE_AND_TIME in BCD; found FFFF FFFF"),
    ],
)
def test_ring_that_cannot_be_read(content: bytes, message: str) -> None:
    """One message: the entry, what was expected."""
    with pytest.raises(SourceError) as error:
        read(content)
    assert str(error.value).startswith(message)


@pytest.mark.parametrize("form", [GOOD, GOOD.hex(" ", 2).encode(), GOOD + bytes(100)])
def test_command(tmp_path: Path, form: bytes, capsys: pytest.CaptureFixture[str]) -> None:
    """Binary or digits, longer than the ring or not; the user says what is complete."""
    (tmp_path / "db101.bin").write_bytes(form)
    log = tmp_path / "log.ndjson"
    arguments = ["import", "--from", "ring", str(tmp_path / "db101.bin"), "--cpu", "S7-300", "--obs", "1,10"]
    assert cli.main([*arguments, "--records", "call,ob", "-o", str(log)]) == 0
    header, *lines = [json.loads(line) for line in log.read_text().splitlines()]
    assert (header["clock"], header["records"], len(lines)) == ("2026-11-21T05:59:01.000", ["call", "ob"], 2)
    assert [line["up"] for line in lines] == [0, 1000]
    err = capsys.readouterr().err
    assert "2 entries read, 0 skipped; 2 events written" in err
    assert "recorded completely: call, ob" in err


@pytest.mark.parametrize(
    ("steps", "up"),
    [
        # The clock in milliseconds and TIME_TCK in steps of ten agree: the clock counts.
        ([(0, 0), (7, 0), (14, 10), (1000, 990)], [0, 7, 14, 1000]),
        # They drift apart over an hour.
        ([(0, 0), (3_600_000, 3_599_500)], [0, 3_600_000]),
        # The clock is set forward, back, back by a little.
        ([(0, 0), (86_400_000, 50), (86_400_010, 60)], [0, 50, 60]),
        ([(0, 0), (-3_600_000, 50), (-3_599_990, 60)], [0, 50, 60]),
        ([(0, 0), (-3, 0), (7, 10)], [0, 0, 10]),
        # TIME_TCK begins again.
        ([(0, 2**31 - 100), (200, 100)], [0, 200]),
        ([(0, 2**31 - 100), (5_000_000, 100)], [0, 200]),
    ],
)
def test_elapsed(steps: list[tuple[int, int]], up: list[int]) -> None:
    """Elapsed time is that of a clock that nobody sets."""
    assert ups(*(called(moment(clock), tick) for clock, tick in steps)) == up


def called(at: str, tick: int) -> dict[str, Any]:
    """A call at that reading of the clock and of TIME_TCK."""
    return entry(30, 0, ob=10) | {"clk": bcd(at), "tick": tick}


def restarted(at: str, tick: int) -> dict[str, Any]:
    """OB 100 begins then."""
    return begins(100, 1) | {"clk": bcd(at), "tick": tick}


def ups(*entries: dict[str, Any]) -> list[int]:
    """The elapsed times of entries."""
    return [event["up"] for event in read(dump(*entries)).log[1:] if event["event"] != "restart"]


def moment(milliseconds: int) -> str:
    """A time, that many milliseconds after 2026-11-21T05:59:30."""
    day, rest = divmod(milliseconds + 21_570_000, 86_400_000)
    seconds, ms = divmod(rest, 1000)
    return f"2026-11-{21 + day}T{seconds // 3600:02}:{seconds // 60 % 60:02}:{seconds % 60:02}.{ms:03}"


def test_elapsed_over_a_restart_of_a_set_clock() -> None:
    """The clock was set before the CPU stopped: the jump is no time that passes."""
    entries = [
        entry(0, 0, stamp=bcd("2026-11-21T07:00:00.000")) | {"tick": 1000},
        restarted("2026-11-21T07:00:04.000", 5),
        called("2026-11-21T09:00:00.000", 1005),
    ]
    assert ups(*entries) == [0, 4000, 5000]
    slots = slots_of(b"".join(packed(number, one) for number, one in enumerate(entries, 1)))
    first = events_of(slots[:2], {})
    assert (first.jumped, events_of(slots[2:], first.elapsed).jumped) == (False, True)


def test_elapsed_over_a_restart() -> None:
    """A restart sets TIME_TCK to 0; then the clock is all there is, as far as it goes on."""
    before = called(moment(0), 70_000)
    after = [restarted(moment(5000), 12), called(moment(5010), 22), restarted(moment(0), 10)]
    assert ups(before, *after) == [0, 5000, 5010, 5010]


@given(st.lists(st.binary(min_size=44, max_size=44), max_size=4), st.binary(max_size=60))
def test_any_bytes(slots: list[bytes], tail: bytes) -> None:
    """Any content gives a usable log or one message."""
    numbered = [double(number) + slot[4:] for number, slot in enumerate(slots, 1)]
    header = word(0x5337) + word(1) + word(max(1, len(slots))) + word(44) + bytes(4) + double(len(slots)) + bytes(4)
    with suppress(SourceError):
        read(header + b"".join(numbered) + tail)


# The source itself, as far as that can be checked without a compiler for it.


def members(block: str) -> list[tuple[str, str]]:
    """Names and types of the members of a STRUCT, comments left out."""
    inner = re.sub(r"//.*", "", block.partition("STRUCT")[2].partition("END_STRUCT")[0])
    return [(name, type_) for name, type_ in re.findall(r"(\w+)\s*:\s*([^;]+?)\s*(?::=[^;]*)?;", inner)]


def offsets(types: list[str]) -> Iterator[int]:
    """Where members lie by the rules of S7: bytes one after another, everything longer on even addresses."""
    at = 0
    for type_ in types:
        at += at % 2 if SIZES[type_] > 1 else 0
        yield at
        at += SIZES[type_]
    yield at + at % 2


UDT = members(SOURCE.partition("TYPE UDT100")[2])
DB = members(SOURCE.partition("DATA_BLOCK DB101")[2])


def test_layout_of_the_source() -> None:
    """The members of UDT 100 and DB 101 lie where the README has them, after which dumps are packed here."""
    assert DB[-1] == ("entry", "ARRAY[0..179] OF UDT100")
    *of_entry, size = offsets([type_ for _, type_ in UDT])
    *of_header, entries = offsets([type_ for _, type_ in DB[:-1]])
    assert (size, entries) == (44, 20)
    assert "size        : INT := 44;" in SOURCE
    assert entries + 180 * size <= 8192, "the longest DB of a small CPU"
    readme = (INSTRUMENTATION / "README.md").read_text()
    rows = re.findall(r"^\| (\d+) \| `(\w+)` \| (\w+) \|", readme, re.MULTILINE)
    table = [(at, *member) for at, member in zip(of_header, DB[:-1], strict=True)]
    table += [(at, *member) for at, member in zip(of_entry, UDT, strict=True)]
    assert [(int(at), name, type_) for at, name, type_ in rows] == table


BLOCKS = re.findall(r"^FUNCTION FC(\d+) : \w+$(.*?)^END_FUNCTION$", SOURCE, re.MULTILINE | re.DOTALL)


def test_wrappers_of_the_source() -> None:
    """FC 100 + n calls SFC n once, logs it under n, passes its result on; locks are taken back."""
    sfcs = {0, 28, 29, 30, 31, 32, 33, 34, 39, 40, 41, 42, 51}
    assert {int(number) - 100 for number, _ in BLOCKS} == sfcs | {10, 11, 12}
    for number, body in BLOCKS:
        sfc = int(number) - 100
        if sfc not in sfcs:
            continue
        assert re.findall(r"result := SFC(\d+)\(", body) == [str(sfc)]
        assert f"FB100.DB100(code := {sfc});" in body
        assert f"FC{number} := result;" in body
        assert body.count("lock := SFC41()") == body.count("lock := SFC42()") == (sfc != 41)


def test_entries_are_published_last() -> None:
    """Nothing of an entry is written once it is counted, but what SFC 42 answers."""
    bodies = dict(BLOCKS)
    assert SOURCE.count("DB101.written :=") == 1
    assert bodies.pop("112").rstrip().endswith("DB101.written := DB100.number;")
    for number, body in bodies.items():
        before, published, after = body.partition("FC112();")
        assert published, number
        assert "FC112();" not in after
        assert "FB100.DB100(" in before
        written = re.findall(r"DB101\.entry\[slot\]\.(\w+) :=", after)
        assert written == (["ret", "done"] if number == "142" else [])
        if number != "141":
            assert re.match(r"\s*lock := SFC42\(\);", after), "published inside the lock"


def test_names_of_the_source() -> None:
    """Names of blocks have eight characters at most, and no variable is called like a keyword."""
    assert all(len(name) <= 8 for name in re.findall(r"^(?:NAME|FAMILY) : (\w+)$", SOURCE, re.MULTILINE))
    keywords = {
        "at",
        "begin",
        "block",
        "by",
        "case",
        "date",
        "dt",
        "en",
        "eno",
        "label",
        "nil",
        "of",
        "ok",
        "time",
        "to",
    }
    keywords |= {"tod", "type", "version", "title", "name", "family", "author", "void"}
    declared = {name.lower() for name in re.findall(r"^\s+(\w+)\s*:\s", SOURCE, re.MULTILINE)}
    assert not declared & keywords
    assert SOURCE.count("(*") == SOURCE.count("*)")
