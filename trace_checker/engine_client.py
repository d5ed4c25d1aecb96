"""The engine process: logs go in, verdicts come out, a JSON object a line either way."""

import os
import select
import signal
import subprocess
import tempfile
from collections.abc import Callable
from types import TracebackType
from typing import IO, Any, Literal

import msgspec

from trace_checker.engine_command import EngineError, engine_command
from trace_checker.log.errors import printable

_PATIENCE = 5
"""Seconds that the engine gets to end once its input has."""

_READ = 64 * 1024
_SHOWN = 300


class Allowed(msgspec.Struct, frozen=True):
    """Something that the specification allows instead of the rejected line.

    ``ob`` is 0 where none belongs to it, ``field`` the field that must have ``value`` or empty.
    """

    event: str
    ob: int = 0
    field: str = ""
    value: int | str | dict[str, int] = 0


class Answer(msgspec.Struct, frozen=True):
    """The engine's answer to one log; ``events`` were explained before it was decided."""

    verdict: Literal["accepted", "rejected", "error"]
    line: int | None = None
    events: int = 0
    expected: list[Allowed] = []
    requirements: list[str] = []
    message: str = ""


class _Ready(msgspec.Struct, frozen=True):
    engine: Literal["ready"]


class Engine:
    """One engine process for any number of logs, started by the first of them.

    For each log: ``begin``, ``send`` as often as needed, ``finish``. As a context manager it ends
    the process. Every method may raise EngineError; the next ``begin`` then starts a new process.

    A single thread serves both directions. That cannot deadlock: the engine takes every line it is
    sent, decided or not, and its one line of answer always fits into the pipe.
    """

    def __init__(self, command: Callable[[], list[str]] = engine_command) -> None:
        self._command = command
        self._process: subprocess.Popen[bytes] | None = None
        self._errors: IO[bytes] | None = None
        self._received = b""
        self._answer: Answer | None = None
        self._encoder = msgspec.json.Encoder()

    def __enter__(self) -> "Engine":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, _: BaseException | None, __: TracebackType | None
    ) -> None:
        self._end(at_once=kind is not None)

    def begin(self, header: dict[str, Any]) -> None:
        """Begins a log with its normalised header."""
        if self._process is None:
            self._start()
        self._answer = None
        self._write(self._encoder.encode({"begin": header}) + b"\n")

    def send(self, events: list[dict[str, Any]]) -> None:
        """Sends normalised events; once the log is decided they are dropped."""
        if events and self._answer is None:
            self._write(self._encoder.encode_lines(events))

    def wait(self, fd: int) -> bool:
        """Waits until ``fd`` can be read. False once the log is decided, whatever ``fd`` does."""
        if self._process is None:
            select.select([fd], [], [])
            return True
        output = self._output()
        while self._answer is None:
            readable, _, _ = select.select([fd, output], [], [])
            if output in readable:
                self._receive()
            elif fd in readable:
                return True
        return False

    def finish(self) -> Answer:
        """Ends the log and returns the answer to it."""
        self._write(self._encoder.encode({"finish": True}) + b"\n")
        while self._answer is None:
            self._receive()
        return self._answer

    def _start(self) -> None:
        command = self._command()
        self._received = b""
        self._errors = tempfile.TemporaryFile()  # a pipe that nobody empties would block the engine
        try:
            self._process = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self._errors
            )
        except OSError as error:
            raise EngineError(f"the engine could not be started: {error}") from error
        line = self._line()
        try:
            msgspec.json.decode(line, type=_Ready)
        except (msgspec.MsgspecError, UnicodeDecodeError) as error:
            raise self._nonsense(line) from error

    def _output(self) -> int:
        assert self._process is not None and self._process.stdout is not None
        return self._process.stdout.fileno()

    def _write(self, data: bytes) -> None:
        assert self._process is not None and self._process.stdin is not None
        try:
            self._process.stdin.write(data)
            self._process.stdin.flush()
        except BrokenPipeError as error:
            raise self._died() from error

    def _receive(self) -> None:
        line = self._line()
        try:
            self._answer = msgspec.json.decode(line, type=Answer)
        except (msgspec.MsgspecError, UnicodeDecodeError) as error:
            raise self._nonsense(line) from error

    def _line(self) -> bytes:
        while b"\n" not in self._received:
            piece = os.read(self._output(), _READ)
            if not piece:
                raise self._died()
            self._received += piece
        line, self._received = self._received.split(b"\n", 1)
        return line

    def _nonsense(self, line: bytes) -> EngineError:
        self._end(at_once=True)
        said = printable(line.decode(errors="replace"), _SHOWN)
        return EngineError(f"the engine answered {said}: it does not fit, run `make engine`")

    def _died(self) -> EngineError:
        process, errors = self._process, self._errors
        assert process is not None and errors is not None
        process.stdout and process.stdout.close()
        code = process.wait()
        errors.seek(0)
        said = errors.read().decode(errors="replace").strip()
        self._end(at_once=True)
        if "OutOfMemoryError" in said:
            return EngineError(
                "the engine ran out of memory: give it more, JDK_JAVA_OPTIONS=-Xmx4g for instance"
            )
        how = f"exit code {code}" if code >= 0 else f"killed by {signal.Signals(-code).name}"
        words = f", {printable(_gist(said), _SHOWN)}" if said else ""
        return EngineError(f"the engine ended ({how}{words}): try again, then run `make engine`")

    def _end(self, at_once: bool) -> None:
        process, self._process = self._process, None
        errors, self._errors = self._errors, None
        if process is not None:
            if at_once:
                process.kill()
            try:
                process.communicate(timeout=_PATIENCE)
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
            except (OSError, ValueError):
                process.wait()
        if errors is not None:
            errors.close()


def _gist(said: str) -> str:
    """The line that names the exception in what a JVM printed, else the last line."""
    lines = said.splitlines()
    return next((line for line in lines if line.startswith("Exception in")), lines[-1])
