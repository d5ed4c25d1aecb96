"""The process that runs programs on an implementation: a program a line in, log lines and ``done`` out."""

from __future__ import annotations

import os
import signal
import subprocess
import tempfile
import time
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Self

from s7check.kit.program import Program
from s7check.log.errors import UnusableLogError, printable
from s7check.log.objects import decoded
from s7check.readable import readable

_READ = 64 * 1024
_LONGEST_LOG = 64 * 1024 * 1024
"""Bytes; an implementation that goes on forever does not fill the memory."""

_PATIENCE = 2.0
"""Seconds that the process gets to end once its input has."""

_LAST_WORDS = 400

NO_END = "no end within"
"""How the reason of a time-out begins."""


class AdapterError(Exception):
    """The command cannot be started; the text says why."""


@dataclass(frozen=True)
class Ran:
    """The log of a run, or why there is none: ``failed`` for a crash, a hang, an endless log or a line that is no
    JSON object, ``skipped`` for a program that the implementation says it cannot run. ``done`` is the line that ends
    the log, empty if it has no time.
    """

    log: tuple[bytes, ...]
    done: bytes = b""
    failed: str = ""
    skipped: str = ""


class Adapter:
    """The process of ``command``, started when a program is to run and again after it has failed.

    ``timeout`` is in seconds, for each program. As a context manager it ends the process.
    """

    def __init__(self, command: Sequence[str], timeout: float) -> None:
        self._command = list(command)
        self._timeout = timeout
        self._process: subprocess.Popen[bytes] | None = None
        self._errors = tempfile.TemporaryFile()  # noqa: SIM115 - closed with the adapter

    def __enter__(self) -> Self:
        return self

    def __exit__(self, _: type[BaseException] | None, __: BaseException | None, ___: TracebackType | None) -> None:
        self.end(at_once=False)
        self._errors.close()

    def run(self, program: Program) -> Ran:
        """Runs a program. Raises AdapterError."""
        process = self._running()
        assert process.stdin is not None
        until = time.monotonic() + self._timeout
        try:
            process.stdin.write(program.plain_line() + b"\n")
            process.stdin.flush()
        except OSError:
            return self._failed([], self._end_of(process))
        return self._taken(process, until)

    def _taken(self, process: subprocess.Popen[bytes], until: float) -> Ran:
        assert process.stdout is not None
        lines: list[bytes] = []
        rest, size = b"", 0
        while True:
            left = until - time.monotonic()
            if left <= 0 or not readable(process.stdout.fileno(), seconds=left):
                return self._failed(lines, f"{NO_END} {self._timeout:g} s")
            chunk = os.read(process.stdout.fileno(), _READ)
            if not chunk:
                return self._failed(lines, self._end_of(process))
            size += len(chunk)
            *complete, rest = (rest + chunk).split(b"\n")
            for place, line in enumerate(complete):
                if line.strip() and not line.lstrip().startswith(b"{"):
                    found = printable(line.decode(errors="replace"), _LAST_WORDS)
                    return self._failed(lines, f"line {len(lines) + 1}: expected a JSON object; found {found}")
                said = _protocol(line)
                if said is None:
                    lines.append(line)
                    continue
                if rest or place + 1 < len(complete):
                    return self._failed(lines, 'lines behind {"event": "done"}')
                if said.get("event") == "skip":
                    return Ran((), skipped=str(said.get("reason") or "the adapter gives no reason"))
                return Ran(tuple(lines), done=line if said.keys() - {"event"} else b"")
            if size > _LONGEST_LOG:
                return self._failed(lines, f"a log of more than {_LONGEST_LOG >> 20} MB")

    def _running(self) -> subprocess.Popen[bytes]:
        if self._process is None or self._process.poll() is not None:
            self._errors.seek(0)
            self._errors.truncate()
            try:
                self._process = subprocess.Popen(
                    self._command,
                    stdin=subprocess.PIPE,
                    stdout=subprocess.PIPE,
                    stderr=self._errors,
                    start_new_session=True,
                )
            except OSError as error:
                raise AdapterError(f"{printable(self._command[0])}: cannot be started: {error.strerror}") from error
        return self._process

    def _failed(self, lines: list[bytes], reason: str) -> Ran:
        self.end(at_once=True)
        return Ran(tuple(lines), failed=reason)

    def _end_of(self, process: subprocess.Popen[bytes]) -> str:
        """How the process ended, with the last it said on standard error."""
        try:
            code = process.wait(_PATIENCE)
        except subprocess.TimeoutExpired:
            return "standard output closed before the end of the program"
        ended = (
            f"ended by signal {-code} ({signal.Signals(-code).name})" if code < 0 else f"ended with exit code {code}"
        )
        size = self._errors.seek(0, os.SEEK_END)
        self._errors.seek(max(0, size - _LAST_WORDS))
        said = self._errors.read().decode(errors="replace").strip().splitlines()
        return f"the adapter {ended}" + (f": {printable(said[-1], _LAST_WORDS)}" if said else "")

    def end(self, at_once: bool = True) -> None:
        """Ends the process and all that it started; the next program starts another."""
        process, self._process = self._process, None
        if process is None:
            return
        for pipe in (process.stdin, process.stdout):
            assert pipe is not None
            with suppress(OSError):  # unwritten bytes for a process that is gone
                pipe.close()
        try:
            process.wait(0 if at_once else _PATIENCE)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()


def _protocol(line: bytes) -> dict[str, Any] | None:
    """The object of ``done`` or ``skip``, with which a program is over; None for a line of the log."""
    if b'"done"' not in line and b'"skip"' not in line:
        return None
    try:
        raw = decoded(line.strip())
    except UnusableLogError:
        return None
    return raw if raw.get("event") in ("done", "skip") else None
