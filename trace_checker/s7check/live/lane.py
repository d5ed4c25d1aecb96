"""Programs of the kit on a CPU, through the interpreter that is loaded in it (instrumentation/awl/README.md).

An adapter of the kit: it stops the CPU, writes a program into DB 110, and restarts the CPU, whose clock the program
sets. What it reads then is what ``s7check watch`` reads.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from contextlib import closing
from datetime import datetime, timedelta
from time import monotonic, sleep
from typing import Any

from s7check.importing.errors import SourceError
from s7check.importing.sources import live
from s7check.kit.hardware import DONE, STATE, encoded, lacks
from s7check.kit.program import Program, read_program
from s7check.live.connection import Connection
from s7check.live.tail import Cut, Event, Tail
from s7check.log.calls import LOG_FORMAT
from s7check.log.errors import UnusableLogError
from s7check.log.values import instant

_RING, _PROGRAM, _WORK = 101, 110, 111
_RUNS = 32, 256
"""Where DB 111 counts the runs of the OBs, and in how many bytes."""

_POLL_S = 0.05
_SLACK_S = 30.0
"""Seconds for the restart, and until the end is told."""

_BEFORE = timedelta(minutes=10)
_FIRST = datetime(1990, 1, 1)
_RECORDS = ["call", "ob", "clock", "mode", "load"]


class SkippedError(Exception):
    """The log of the program would not be whole."""


class Cpu(Connection):
    """A CPU that is also stopped, written to and started."""

    def load(self, content: bytes, clock: datetime) -> None:
        """Stops the CPU, sets its clock, and writes a program for the interpreter."""
        client = self._connected()
        with live.answers():
            client.plc_stop()
            client.set_plc_datetime(clock)
            client.db_write(_PROGRAM, 0, bytearray(content))
            client.db_write(_WORK, _RUNS[0], bytearray(_RUNS[1]))

    def restart(self) -> None:
        """A warm restart."""
        client = self._connected()
        with live.answers():
            client.plc_hot_start()

    def done(self) -> bool:
        """Whether the program is over."""
        client = self._connected()
        with live.answers():
            return bytes(client.db_read(_PROGRAM, STATE, 2)) == DONE.to_bytes(2)


def lines_of(cpu: Cpu, program: Program, latency: int) -> list[dict[str, Any]]:
    """The log of the program on the CPU. Raises SkippedError where there is no whole one, SourceError."""
    if lack := lacks(program):
        raise SkippedError(lack)
    # The program sets the clock exactly, and forward: what comes before is then told apart.
    cpu.load(encoded(program), max(_FIRST, datetime.fromisoformat(program.plain["header"]["clock"]) - _BEFORE))
    tail = Tail(cpu, None)  # nobody else sets the clock
    if tail.mode != "STOP":
        raise SkippedError(f"expected the CPU in STOP; found {tail.mode}")
    cpu.restart()
    events = list(_behind_the_clock(_told(cpu, tail, monotonic() + program.duration / 1000 + _SLACK_S)))
    header = {"format": LOG_FORMAT, **program.header, "latency_ms": latency, "records": _RECORDS}
    base = events[0]["up"]
    rebased = [{**event, "up": event["up"] - base} if "up" in event else event for event in events[1:]]
    return [header, *rebased, _done([{**events[0], "up": 0}, *rebased], tail)]


def _done(events: list[dict[str, Any]], tail: Tail) -> dict[str, Any]:
    """The line of the end: up to then all is told."""
    end = tail.told_until
    last = next(event for event in reversed(events) if "up" in event)
    passed = 0 if end is None else instant(end.isoformat(timespec="milliseconds")) - instant(last.get("to", last["at"]))
    if end is None or passed < 0 or events[-1]["at"] > end.isoformat(timespec="milliseconds"):
        return {"event": "done"}
    return {"event": "done", "at": end.isoformat(timespec="milliseconds"), "up": last["up"] + passed}


def _told(cpu: Cpu, tail: Tail, until: float) -> Iterator[Event | Cut]:
    """What the CPU tells until the program is over, and all of that is told."""
    over = 0
    while over < 3:
        yield from tail.poll()
        over = over + 1 if cpu.done() or tail.mode == "STOP" else 0
        if monotonic() > until:
            raise SkippedError("the program is not over in time: is the interpreter called in OB 1?")
        sleep(_POLL_S)


def _behind_the_clock(told: Iterator[Event | Cut]) -> Iterator[dict[str, Any]]:
    """The clock line with which the program begins, and the events after it. Raises SkippedError at a gap."""
    begun = False
    for one in told:
        if isinstance(one, Cut):
            raise SkippedError(f"the log is not whole: {one.reason}")
        begun = begun or one.fields["event"] == "clock"
        if begun:
            yield one.fields
    if not begun:
        raise SkippedError("the CPU did not come to RUN")


def main(address: str, port: str, latency: str) -> None:
    """The adapter: a program a line on standard input, its log on standard output."""
    with closing(Cpu(live.parse(address, int(port)), _RING)) as cpu:
        for text in sys.stdin.buffer:
            try:
                lines = lines_of(cpu, read_program(text), int(latency))
            except (SkippedError, UnusableLogError) as error:  # the CPU's family may know no such header
                lines = [{"event": "skip", "reason": str(error)}]
            except SourceError as error:
                sys.exit(str(error))
            sys.stdout.write("".join(json.dumps(line) + "\n" for line in lines))
            sys.stdout.flush()


if __name__ == "__main__":
    main(*sys.argv[1:])
