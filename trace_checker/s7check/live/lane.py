"""Programs of the kit on a CPU, through the interpreter that is loaded in it (instrumentation/awl/README.md).

An adapter of the kit: it stops the CPU, writes a program into DB 110, and restarts the CPU, whose clock the program
sets. What it reads then is what ``s7check watch`` reads.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from contextlib import closing, suppress
from datetime import datetime, timedelta
from time import monotonic, sleep
from typing import Any

from s7check.importing.errors import SourceError
from s7check.importing.sources import live
from s7check.kit.hardware import HEAD, encoded, happened, lacks, restarted
from s7check.kit.program import Program, outside_events, read_program
from s7check.live.connection import Connection
from s7check.live.tail import Cut, Event, Tail
from s7check.log.calls import LOG_FORMAT
from s7check.log.errors import UnusableLogError
from s7check.log.values import instant

_RING, _PROGRAM, _WORK = 101, 110, 111
_OUTPUT, _FRESH = 16, 272
"""The byte of DB 111 that has what was written to the output; the bytes from there on that are 0 at the begin."""

_POLL_S, _POLLS, _TRIES = 0.05, 3, 4
_SLACK_S = 30.0
"""Seconds for the restart, and until the end is told."""

_PATIENCE_S = 5.0
"""Seconds after which a restart that nobody has told of is asked for again: the connection may have broken."""

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
            client.db_write(_WORK, _OUTPUT, bytearray(_FRESH))

    def go_on(self, elapsed: int, events: int) -> None:
        """The next restart is in the program, which has gone on for ``elapsed`` ms; so many of its events are over."""
        client = self._connected()
        with live.answers():
            client.db_write(_WORK, _OUTPUT, bytearray(1))  # as the output will be
            for place, content in restarted(elapsed, events).items():
                client.db_write(_PROGRAM, place, bytearray(content))

    def restart(self) -> None:
        """A warm restart."""
        client = self._connected()
        with live.answers():
            client.plc_hot_start()

    def happened(self) -> int:
        """How many events of the program are over."""
        client = self._connected()
        with live.answers():
            return happened(bytes(client.db_read(_PROGRAM, 0, HEAD)))


class Run:
    """A program on the CPU. Its log begins where the program sets the clock, or with the CPU in STOP."""

    def __init__(self, cpu: Cpu, program: Program) -> None:
        self._cpu = cpu
        self._program = program
        self._clock: str = program.plain["header"]["clock"]
        self._stopped = program.header.get("mode", "STOP") == "STOP"
        # The program sets the clock exactly, and forward: what comes before is then told apart.
        before = timedelta(0) if self._stopped else _BEFORE
        cpu.load(encoded(program), max(_FIRST, datetime.fromisoformat(self._clock) - before))
        self._tail = Tail(cpu, None)  # nobody else sets the clock
        if self._tail.mode != "STOP":
            raise SkippedError(f"expected the CPU in STOP; found {self._tail.mode}")
        self._base: int | None = 0 if self._stopped else None
        self._events: list[dict[str, Any]] = []
        self._restarts = 0  # that were asked for and not told
        self._asked = 0.0
        self._over = 0  # events up to the last such restart in the program

    def log(self, latency: int) -> list[dict[str, Any]]:
        """Its lines. Raises SkippedError, SourceError."""
        if not self._stopped:
            with suppress(live.NoAnswerError):
                self._restart()
        until = monotonic() + self._program.duration / 1000 + _SLACK_S
        settled = 0
        while settled < _POLLS:
            try:
                for one in self._tail.poll():
                    self._take(one)
                settled = settled + 1 if self._is_over() else 0
            except live.NoAnswerError:
                self._cpu.close()  # and connect again
            if monotonic() > until:
                raise SkippedError("the program is not over in time: is the interpreter called in OB 1 and OB 100?")
            sleep(_POLL_S)
        header = {"format": LOG_FORMAT, **self._program.header, "latency_ms": latency, "records": _RECORDS}
        return [header, *self._events, self._done()]

    def _take(self, one: Event | Cut) -> None:
        """What the CPU has told. Raises SkippedError at a gap."""
        if isinstance(one, Cut):
            raise SkippedError(f"the log is not whole: {one.reason}")
        event = dict(one.fields)
        self._restarts -= event["event"] == "restart"
        if self._base is None:
            if event["event"] == "clock":
                self._base = event["up"]
                self._clock = event["to"]
            return
        if "up" in event:
            if self._stopped:
                self._base = event["up"] - instant(event["at"]) + instant(self._clock)
                self._stopped = False
            event["up"] -= self._base
        self._events.append(event)

    def _elapsed(self, clock: str) -> int:
        """The milliseconds of the program when the CPU clock shows this."""
        begin: dict[str, Any] = {"at": self._clock, "up": 0}
        last = next((event for event in reversed(self._events) if "up" in event), begin)
        return int(last["up"]) + instant(clock) - instant(last.get("to", last["at"]))

    def _is_over(self) -> bool:
        """Whether the program is; in STOP it goes on with the next restart, when that is due."""
        if self._restarts and monotonic() > self._asked + _PATIENCE_S:
            self._restart()
        if self._base is None or self._restarts:
            return False
        elapsed = self._elapsed(_spelled(self._cpu.clock()))
        if self._tail.mode != "STOP" or elapsed >= self._program.duration:
            return elapsed >= self._program.duration
        known = self._cpu.happened()
        for place, (after, event) in enumerate(outside_events(self._program), 1):
            if place >= known and place > self._over and event["event"] == "restart":
                if elapsed >= after:
                    self._cpu.go_on(elapsed, place)
                    self._over = place
                    self._restart()
                return False
            if place > known and event["event"] == "clock":
                raise SkippedError("the clock is to be set in STOP")
        return True

    def _restart(self) -> None:
        self._restarts, self._asked = 1, monotonic()
        self._cpu.restart()

    def _done(self) -> dict[str, Any]:
        """The line of the end: up to then all is told."""
        end = "" if self._tail.told_until is None else _spelled(self._tail.told_until)
        last = self._events[-1]["at"] if self._events else self._clock
        if end < last:
            return {"event": "done"}
        return {"event": "done", "at": end, "up": self._elapsed(end)}


def lines_of(cpu: Cpu, program: Program, latency: int) -> list[dict[str, Any]]:
    """The log of the program on the CPU. Raises SkippedError where there is no whole one, SourceError."""
    if lack := lacks(program):
        raise SkippedError(lack)
    return _loaded(cpu, program).log(latency)


def _loaded(cpu: Cpu, program: Program) -> Run:
    for _ in range(_TRIES):
        try:
            return Run(cpu, program)
        except live.NoAnswerError:
            cpu.close()  # and connect again
    return Run(cpu, program)


def _spelled(clock: datetime) -> str:
    return clock.isoformat(timespec="milliseconds")


def serve(lines: Callable[[Program], list[dict[str, Any]]]) -> None:
    """Answers each program, a line on standard input, with its log on standard output."""
    for text in sys.stdin.buffer:
        try:
            log = lines(read_program(text))
        except (SkippedError, UnusableLogError) as error:  # the CPU's family may know no such header
            log = [{"event": "skip", "reason": str(error)}]
        except SourceError as error:
            sys.exit(str(error))
        sys.stdout.write("".join(json.dumps(line) + "\n" for line in log))
        sys.stdout.flush()


def main(address: str, port: str, latency: str) -> None:
    """The adapter for a CPU that speaks the S7 protocol."""
    with closing(Cpu(live.parse(address, int(port)), _RING)) as cpu:
        serve(lambda program: lines_of(cpu, program, int(latency)))


if __name__ == "__main__":
    main(*sys.argv[1:])
