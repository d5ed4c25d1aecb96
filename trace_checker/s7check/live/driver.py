"""The lane of a real CPU over another link than the S7 protocol: an adapter of the kit from three calls.

A program of yours has a class with the calls of ``Driver`` and ends with ``main(YourDriver())``; then
``s7check kit run --offer cpu.json --jobs 1 -- python your_program.py``, with the OBs of the CPU as ``obs`` and as
``loaded`` in the offer. Without the diagnostic buffer nobody tells STOP and restarts, so programs with these are
skipped.
"""

from __future__ import annotations

from time import sleep
from typing import Any, Protocol

from s7check.importing.asking import Slot, events_of, ring_of, slots_of
from s7check.importing.sources.live import RING_HEADER
from s7check.kit.hardware import encoded, lacks
from s7check.kit.program import Program
from s7check.live.lane import SkippedError, serve
from s7check.log.calls import LOG_FORMAT

_RECORDS = ["call", "ob", "clock", "load"]


class Driver(Protocol):
    """A CPU with the interpreter in it."""

    def load(self, program: bytes) -> None:
        """Stops the CPU, writes ``program`` to the beginning of DB 110, and 0 to DB 111 from byte 16 on."""

    def restart(self) -> None:
        """A warm restart."""

    def ring(self) -> bytes:
        """All of DB 101."""


def lines_of(driver: Driver, program: Program, latency: int, slack: float) -> list[dict[str, Any]]:
    """The log of the program on the CPU, read ``slack`` seconds after it should be over.

    Raises SkippedError where there is no whole one, SourceError for what is no ring.
    """
    unseen = program.header.get("mode") != "RUN" or any(one["event"] in ("stop", "restart") for one in program.outside)
    if lack := "no STOP and no restart over this link" if unseen else lacks(program):
        raise SkippedError(lack)
    driver.load(encoded(program))
    before = ring_of(driver.ring()).written
    driver.restart()
    sleep(program.duration / 1000 + slack)
    begun, *events = events_of(_behind_the_clock(driver.ring(), before), {}).events
    header = {"format": LOG_FORMAT, **program.header, "latency_ms": latency, "records": _RECORDS}
    return [header, *({**event, "up": event["up"] - begun["up"]} for event in events), {"event": "done"}]


def _behind_the_clock(raw: bytes, before: int) -> list[Slot]:
    """The entry with which the program has set the clock, and those behind it."""
    header = ring_of(raw)
    slots = {entry.number: entry for entry in slots_of(raw[RING_HEADER : header.length])}
    numbers = range(before + 1, header.written + 1)
    if not slots.keys() >= {*numbers}:
        raise SkippedError(f"{len(numbers)} records, more than the ring has slots")
    entries = [slots[number] for number in numbers]
    begins = next((place for place, entry in enumerate(entries) if entry.sets), None)
    if begins is None:
        raise SkippedError("the program has not begun: is the interpreter called in OB 1?")
    return entries[begins:]


def main(driver: Driver, latency: int = 100, slack: float = 10.0) -> None:
    """The adapter: a program a line on standard input, its log on standard output."""
    serve(lambda program: lines_of(driver, program, latency, slack))
