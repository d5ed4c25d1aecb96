"""The engine's protocol: logs go in, verdicts come out, a JSON object a line either way."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any, Literal, Self, TypeVar

import msgspec

from s7check.engine import limits
from s7check.engine.answer import Alternatives, Answer, Decision
from s7check.engine.command import EngineError, engine_command
from s7check.engine.java import JavaMissingError, check_java
from s7check.engine.process import EngineProcess
from s7check.log.elapsed import Clocks, Readings
from s7check.log.errors import printable
from s7check.log.events import VARYING
from s7check.log.fields import OWN
from s7check.log.lines import Lines
from s7check.log.reader import LogReader
from s7check.log.source import wait_for_input
from s7check.readable import readable
from s7check.resources import REMEDY

_SHOWN = 300
_OPEN = b'{"verdict":"open"}'
_ABOUT_LINES = (b'{"unread"', b'{"clocks"')
_Shape = TypeVar("_Shape")


class _Ready(msgspec.Struct, frozen=True):
    engine: Literal["ready"]


class _Alternatives(msgspec.Struct, frozen=True):
    alternatives: Alternatives


class _Decisions(msgspec.Struct, frozen=True):
    decisions: list[Decision]


class _Lines(msgspec.Struct, frozen=True):
    """The clocks before the line ``unread``, which the engine has no example for, or after all lines."""

    clocks: Readings
    unread: int = 0


Read = Callable[[int], dict[str, Any] | None]
"""The event of the line with a number; none if it cannot be read, and then the log ends before it."""


@dataclass
class _Unread:
    """The reading of lines that the engine has got as they are; ``ended`` before a line that cannot be read."""

    clocks: Clocks
    read: Read
    ended: bool = False


class Engine:
    """An engine process for any number of logs, started when the first of them begins.

    For each log: ``begin``, ``send`` as often as needed, ``finish``. Every method may raise
    EngineError; the process has then ended, and the next ``begin`` starts a new one. As a context
    manager it ends the process.

    A single thread serves both directions. That cannot deadlock: the engine takes every line it is
    sent, decided or not, and its one line of answer fits into the pipe. With ``follow`` it may not:
    such a log must end with the line that decides it.
    """

    def __init__(self, command: Callable[[], list[str]] = engine_command) -> None:
        self.command = command
        self._idle: EngineProcess | None = None
        self._at_work: EngineProcess | None = None
        self._answer: Answer | None = None
        self._until: float | None = None
        self._alternatives: Alternatives | None = None
        self._unread: _Unread | None = None
        self._decisions: list[Decision] | None = None
        self._encoder = msgspec.json.Encoder()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, _: BaseException | None, __: TracebackType | None) -> None:
        for process in (self._idle, self._at_work):
            if process is not None:
                process.end(at_once=kind is not None or process is self._at_work)
        self._idle = self._at_work = None

    def begin(self, header: dict[str, Any], follow: int = 0, until: float | None = None) -> None:
        """Begins a log with its normalised header; the answer will have the last ``follow`` steps.

        The log must be decided at the time ``until`` of ``time.monotonic``: else ``send`` and ``finish`` raise
        EngineTooSlowError.
        """
        if self._at_work is not None:
            # The log before was given up after an error; unread answers may still be under way.
            self._drop(self._at_work)
        process = self._ready()
        self._at_work, self._idle = process, None
        self._answer = None
        self._unread = None
        self._until = until
        message: dict[str, Any] = {"message": "begin", "header": header}
        if follow:
            message["follow"] = follow
        with self._dropped_on_error(process):
            process.write(self._encoder.encode(message) + b"\n")

    def alternatives(self) -> Alternatives:
        """The choices that a header has; not while a log is at work."""
        if self._alternatives is None:
            self._alternatives = self.ask({"message": "alternatives"}, _Alternatives).alternatives
        return self._alternatives

    def decisions(self) -> list[Decision]:
        """The decisions that the ``outcomes`` of an answer speak of; not while a log is at work."""
        if self._decisions is None:
            self._decisions = self.ask({"message": "decisions"}, _Decisions).decisions
        return self._decisions

    def ask(self, message: dict[str, Any], shape: type[_Shape]) -> _Shape:
        """The answer to a message with one answer, which has this shape; not while a log is at work."""
        process = self._idle = self._ready()
        with self._dropped_on_error(process):
            process.write(self._encoder.encode(message) + b"\n")
            return _decode(process.line(), shape)

    def _ready(self) -> EngineProcess:
        """The idle process, if it still runs, or else a new one."""
        if self._idle is not None:
            if self._idle.running:
                return self._idle
            self._drop(self._idle)
        command = self.command()
        process = EngineProcess(command)
        with self._dropped_on_error(process):
            try:
                _decode(process.line(), _Ready)
            except EngineError as error:
                raise _explained(error, process, command[0]) from error
        return process

    @contextmanager
    def _dropped_on_error(self, process: EngineProcess) -> Iterator[None]:
        try:
            yield
        except BaseException:
            self._drop(process)
            raise

    def _drop(self, process: EngineProcess) -> None:
        process.end(at_once=True)
        self._idle = None if self._idle is process else self._idle
        self._at_work = None if self._at_work is process else self._at_work

    def send(self, events: list[dict[str, Any]]) -> None:
        """Sends normalised events; once the log is decided they are dropped."""
        process = self._at_work
        if process is not None and self._answer is None and events:
            with self._dropped_on_error(process):
                process.write(self._encoder.encode_lines(events), self._until)

    def send_lines(self, lines: Lines, reader: LogReader, read: Read) -> None:
        """Sends lines that are not read yet: the engine itself reads lines that differ from others only in their times.

        The others it gets from ``read``, which is called in ``wait``, ``end_lines`` and ``finish``; ``reader`` has
        read the lines before, the header among them, and its clocks go on with the lines.
        """
        process = self._at_work
        if process is None or self._answer is not None or not lines.texts:
            return
        if self._unread is None:
            assert reader.clocks is not None
            self._unread = _Unread(reader.clocks, read)
            its = {**reader.clocks.readings, "jumps_logged": reader.clocks.jumps_logged}
            self._say(process, {"message": "raw", "clocks": its, "varying": VARYING, "own": OWN})
        begin = self._encoder.encode({"message": "lines", "first": lines.first, "count": len(lines.texts)})
        with self._dropped_on_error(process):
            process.write(b"\n".join([begin, *lines.texts, b""]), self._until)

    def end_lines(self) -> None:
        """The next lines come by ``send``: the reader's clocks are those after the lines before them."""
        process = self._at_work
        if process is None or self._unread is None:
            return
        self._say(process, {"message": "clocks"})
        heard = None
        while heard is None or heard.unread:
            heard = self._hear(process)
        self._unread = None

    def _say(self, process: EngineProcess, *messages: dict[str, Any]) -> None:
        with self._dropped_on_error(process):
            process.write(self._encoder.encode_lines(messages), self._until)

    def _hear(self, process: EngineProcess) -> _Lines | None:
        """The engine's next line: a verdict, which is kept, or a question for a line, which is answered."""
        with self._dropped_on_error(process):
            line = process.line(self._until)
            if self._unread is None or not line.startswith(_ABOUT_LINES):
                self._answer = _decode(line, Answer)
                return None
            heard = _decode(line, _Lines)
        clocks = self._unread.clocks
        clocks.set(heard.clocks)
        if heard.unread:
            event = self._unread.read(heard.unread)
            if event is None:
                self._unread.ended = True
                self._say(process, {"message": "unreadable"})
            else:
                self._say(process, {"message": "read", "clocks": clocks.readings}, event)
        return heard

    def wait(self, fd: int) -> bool:
        """Waits until ``fd`` can be read. False once the log is decided or ends, with or without input."""
        process = self._at_work
        if process is None:
            return wait_for_input(fd)
        while self._answer is None and not (self._unread and self._unread.ended):
            if process.output not in readable(fd, process.output):
                return True
            self._hear(process)
        return False

    def decided(self) -> bool:
        """Whether the events sent so far decide the log, whatever follows."""
        process = self._at_work
        if process is not None and self._answer is None:
            with self._dropped_on_error(process):
                process.write(self._encoder.encode({"message": "verdict"}) + b"\n")
                line = process.line()
                self._answer = None if line == _OPEN else _decode(line, Answer)
        return self._answer is not None

    def finish(self) -> Answer:
        """Ends the log that was begun and returns the answer to it."""
        process = self._at_work
        if process is None:
            raise EngineError("no log was begun")
        self._say(process, {"message": "finish"})
        while self._answer is None:
            self._hear(process)
        self._idle, self._at_work = process, None
        return self._answer


def _explained(error: EngineError, process: EngineProcess, program: str) -> EngineError:
    """Why the engine did not get ready: its Java may be unfit, which costs too much to ask before, or a limit."""
    if process.ended_by_itself and Path(program).stem == "java":
        try:
            check_java(program)
        except JavaMissingError as reason:
            return EngineError(str(reason))
    too_small = limits.advice()
    return EngineError(f"the engine did not start: {too_small}") if too_small else error


def _decode(line: bytes, shape: type[_Shape]) -> _Shape:
    try:
        return msgspec.json.decode(line, type=shape)
    except (msgspec.MsgspecError, UnicodeDecodeError) as error:
        said = printable(line.decode(errors="replace"), _SHOWN)
        raise EngineError(f"the engine answered {said}, which does not fit: {REMEDY}") from error
