"""The ring of the SCL instrumentation to events of a log."""

from collections.abc import Iterator, Sequence
from typing import Any

from s7check.importing.asking import start_info
from s7check.importing.elapsed import Elapsed
from s7check.importing.errors import SourceError
from s7check.importing.recording import Placed, Recording, select
from s7check.importing.sources import bcd
from s7check.importing.sources.ring_layout import RingEntry, RingHeader, read_header, read_slots

_SET_CLK, _STATE, _OB_BEGINS, _OB_ENDS, _INTERRUPT = 0, 51, 200, 201, 202

_CALLS = {
    28: "SET_TINT",
    29: "CAN_TINT",
    30: "ACT_TINT",
    31: "QRY_TINT",
    32: "SRT_DINT",
    33: "CAN_DINT",
    34: "QRY_DINT",
    39: "DIS_IRT",
    40: "EN_IRT",
    41: "DIS_AIRT",
    42: "EN_AIRT",
}
"""Code of an entry, the number of the SFC -> the event."""

MODES_AT_BEGIN = {1: "RUN", 100: "STARTUP", 102: "STARTUP"}
"""OB that makes the first entry -> the mode; another OB interrupts an unknown mode."""

_DELAYS = range(20, 24)
_WITH_SOURCE = frozenset({*range(10, 18), *_DELAYS})
"""OBs of which SZL 16#0222 shows whether the source of their start events is active."""

_RESTARTS = {100: "warm", 101: "hot", 102: "cold"}
STARTUP_OBS = frozenset({100, 101, 102})
_FIRST_CYCLES = frozenset({0x01, 0x02, 0x04})
"""Event numbers with which OB 1 begins after a warm, a hot and a cold restart."""


def convert(raw: bytes, chosen: range | None = None) -> Recording:
    """The events of a dump of the ring's data block."""
    header = read_header(raw)
    recording = Recording()
    kept = select(_in_order(header, read_slots(raw, header), recording), chosen, recording)
    entries = _from_known_mode(kept, recording)
    elapsed = Elapsed()
    for entry in entries:
        recording.events += events_of(entry, elapsed, recording)
    recording.header |= {"clock": clock_of(entries[0]), "records": []}
    recording.remarks.append(
        "only you know whether each SFC call and each OB goes through the instrumentation: if so, --records call,ob"
    )
    return recording


def events_of(entry: RingEntry, elapsed: Elapsed, recording: Recording) -> list[Placed]:
    """The events of an entry, whose time ``elapsed`` takes. An entry that gives none is counted in ``recording``."""
    at = clock_of(entry)
    stamp = {"at": at, "up": elapsed.up(at, entry.tick, begins_restart(entry))}
    events = _events(entry, recording)
    placed = [Placed({"event": event.pop("event"), **stamp, **event}, entry.place) for event in events]
    if sets_clock(entry):
        elapsed.set_clock(set_to(entry))
    return placed


def begins_restart(entry: RingEntry) -> bool:
    """Whether a startup OB begins."""
    return entry.code == _OB_BEGINS and entry.ob_nr in _RESTARTS


def restart_of(entry: RingEntry) -> dict[str, Any]:
    """The restart that the begin of a startup OB proves."""
    return {"event": "restart", "type": _RESTARTS[entry.ob_nr]}


def sets_clock(entry: RingEntry) -> bool:
    """Whether the program has set the clock."""
    return entry.code == _SET_CLK and bool(entry.done) and not entry.ret


def set_to(entry: RingEntry) -> str:
    """The time to which a program has set the clock. Raises SourceError for one that there is not."""
    try:
        return bcd.instant(entry.stamp)
    except ValueError as error:
        raise SourceError(entry.place, "a clock that is set to a DATE_AND_TIME", bcd.spaced(entry.stamp)) from error


def _in_order(header: RingHeader, slots: Sequence[RingEntry], recording: Recording) -> list[RingEntry]:
    """The entries without a gap, up to the last entry that was counted when the header was read."""
    present = {entry.number: entry for entry in slots}
    first = header.written + 1
    while first - 1 in present:
        first -= 1
    if first > header.written:
        raise SourceError("", f"entry {header.written}, the newest one" if header.written else "an entry", "none")
    if first > 1:
        recording.remarks.append(f"{first - 1} older entries were overwritten in the ring")
    return [present[number] for number in range(first, header.written + 1)]


def _from_known_mode(entries: Sequence[RingEntry], recording: Recording) -> Sequence[RingEntry]:
    """The entries from the first one on at which a log can begin."""
    for index, entry in enumerate(entries):
        if begins_restart(entry):
            recording.header["mode"] = "STOP"
        elif entry.caller in MODES_AT_BEGIN:
            recording.header["mode"] = "STARTUP" if _begins_run(entry) else MODES_AT_BEGIN[entry.caller]
            recording.remarks.append("the log begins while the program runs: what it called before is unknown")
        else:
            continue
        recording.skip("before the first entry of OB 1 or a startup OB", index)
        return entries[index:]
    raise SourceError("", "an entry of OB 1 or a startup OB to begin with", "entries of other OBs only")


def clock_of(entry: RingEntry) -> str:
    """The CPU clock of an entry. Raises SourceError for one that there is not."""
    try:
        return bcd.instant(entry.clk)
    except ValueError as error:
        raise SourceError(entry.place, "a DATE_AND_TIME in BCD", bcd.spaced(entry.clk)) from error


def _events(entry: RingEntry, recording: Recording) -> Iterator[dict[str, Any]]:
    """The events that the entry tells of, without their times."""
    own = {"x_ob": entry.caller}
    if entry.code in _CALLS:
        yield {"event": _CALLS[entry.code], **_parameters(entry), **_result(entry), **own}
    elif entry.code == _OB_BEGINS:
        yield from _mode_before(entry)
        yield {"event": "start", "ob": entry.ob_nr, "info": _info(entry)}
    elif entry.code == _OB_ENDS:
        yield {"event": "end", "ob": entry.ob_nr}
    elif entry.code == _INTERRUPT:
        yield {"event": "interrupt", "ob": entry.ob_nr}
    elif entry.code == _STATE:
        if entry.done and not entry.ret:
            yield {"event": "state", "ob": entry.ob_nr, **state_of(entry.ob_nr, entry.status, entry.info_2), **own}
        else:
            recording.skip("RDSYSST that did not answer")
    elif entry.code == _SET_CLK:
        if sets_clock(entry):
            yield {"event": "clock", "to": _date(entry), **own}
        else:
            recording.skip("SET_CLK that did not set the clock")
    else:
        raise SourceError(entry.place, "the number of an SFC or 200 to 202 as its code", str(entry.code))


def _mode_before(entry: RingEntry) -> Iterator[dict[str, Any]]:
    """The change of the mode that an OB's begin proves."""
    if entry.ob_nr in _RESTARTS:
        yield restart_of(entry)
    elif _begins_run(entry):
        yield {"event": "run"}


def _begins_run(entry: RingEntry) -> bool:
    return (entry.code, entry.ob_nr) == (_OB_BEGINS, 1) and entry.ev_num in _FIRST_CYCLES


def _parameters(entry: RingEntry) -> dict[str, Any]:
    match entry.code:
        case 28:
            return {"ob": entry.ob_nr, "sdt": _date(entry), "period": word(entry.info_1)}
        case 32:
            return {"ob": entry.ob_nr, "dtime": duration(entry.info_2), "sign": word(entry.info_1)}
        case 39 | 40:
            return {"mode": byte(entry.mode), "ob": entry.ob_nr}
        case 41 | 42:
            return {}
        case _:
            return {"ob": entry.ob_nr}


def _result(entry: RingEntry) -> dict[str, Any]:
    """RET_VAL and STATUS; neither is there while the call has not come back."""
    if not entry.done:
        return {"ret": None}
    result: dict[str, Any] = {"ret": word(entry.ret)}
    if entry.code in (31, 34):
        result["status"] = word(entry.status)
    return result


def state_of(ob: int, al1: int, left: int | None) -> dict[str, Any]:
    """What SZL 16#0222 shows of an OB: bits of its word al1, and the milliseconds left of a delay, if known."""
    bits = {"blocked": 1, "loaded": 4, "entries_off": 6}
    state: dict[str, Any] = {name: bool(al1 >> bit & 1) for name, bit in bits.items()}
    if ob in _WITH_SOURCE:
        state["active"] = bool(al1 >> 2 & 1)
    if ob in _DELAYS and state["active"] and left is not None:
        state["left"] = duration(left)
    return state


def _info(entry: RingEntry) -> dict[str, Any]:
    info: dict[str, Any] = {"priority": entry.priority}
    info |= start_info(entry.ob_nr, entry.ev_num, entry.info_1, duration(entry.info_2))
    return info | {"time": _date(entry)}


def byte(value: int) -> str:
    """A byte as a log spells it."""
    return f"B#16#{value:02X}"


def word(value: int) -> str:
    """A word as a log spells it."""
    return f"W#16#{value & 0xFFFF:04X}"


def duration(value: int) -> int:
    """The milliseconds of a TIME, whose 32 bits are signed."""
    return value - (1 << 32) if value >> 31 else value


def _date(entry: RingEntry) -> str:
    try:
        return bcd.digits(entry.stamp)
    except ValueError as error:
        raise SourceError(entry.place, "a DATE_AND_TIME in BCD", bcd.spaced(entry.stamp)) from error
