"""The engine's protocol: logs go in, verdicts come out; messages are JSON objects, one a line either way."""

import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import TracebackType
from typing import Any, Literal, Self, TypeVar

import msgspec

from s7check.engine import limits
from s7check.engine.answer import Alternatives, Answer, Content, Decision, Part, Refusal, Unusable
from s7check.engine.class_archive import forget_archive
from s7check.engine.command import EngineError, engine_command
from s7check.engine.java import OPTIONS, JavaMissingError, check_java
from s7check.engine.process import EngineProcess
from s7check.log.errors import printable
from s7check.log.profile_file import HERE, header_line, profile_file
from s7check.log.source import wait_for_input
from s7check.readable import readable
from s7check.resources import REMEDY

_SHOWN = 300
_OPEN = b'{"verdict":"open"}'
_Shape = TypeVar("_Shape")


class _Ready(msgspec.Struct, frozen=True):
    engine: Literal["ready"]


class _Alternatives(msgspec.Struct, frozen=True):
    alternatives: Alternatives


class Checked(msgspec.Struct, frozen=True):
    """The object that was made of a text or of a source, or what is wrong with that, or with the specification."""

    object: dict[str, Any] = {}
    unusable: Unusable | None = None
    error: str = ""


class _Decisions(msgspec.Struct, frozen=True):
    decisions: list[Decision]


class _Parts(msgspec.Struct, frozen=True):
    parts: list[Part]


class _Rejected(msgspec.Struct, frozen=True):
    refusal: Refusal = Refusal()


class Engine:
    """An engine process for any number of logs, started when the first of them begins.

    For each log: ``begin``, ``send`` as often as needed, ``finish``. Every method may raise
    EngineError; the process has then ended, and the next ``begin`` starts a new one. As a context
    manager it ends the process.

    A single thread serves both directions. That cannot deadlock: the engine takes all that it is
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
        self._head: bytes | None = None
        self._beginning: dict[str, Any] = {}
        self._folder = HERE
        self._decisions: list[Decision] | None = None
        self._told: EngineProcess | None = None
        self._encoder = msgspec.json.Encoder()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, _: BaseException | None, __: TracebackType | None) -> None:
        for process in (self._idle, self._at_work):
            if process is not None:
                process.end(at_once=kind is not None or process is self._at_work)
        self._idle = self._at_work = None

    def begin(
        self,
        chosen: Mapping[str, Any] | None = None,
        follow: int = 0,
        until: float | None = None,
        folder: Path = HERE,
        outcomes: bool = False,
    ) -> None:
        """Begins a log in ``folder``; the answer will have the last ``follow`` steps, and its ``outcomes`` if asked.

        ``chosen`` takes the place of the header's own ``cpu``, ``profile`` and letters of ``readings``. The log must be
        decided at the time ``until`` of ``time.monotonic``: else ``send`` and ``finish`` raise EngineTooSlowError.
        """
        if self._at_work is not None:
            # The log before was given up after an error; unread answers may still be under way.
            self._drop(self._at_work)
        process = self._ready()
        self._at_work, self._idle = process, None
        self._answer = None
        self._until = until
        self._head, self._folder = b"", folder
        self._beginning = {"message": "begin"}
        if chosen:
            self._beginning["chosen"] = chosen
        if follow:
            self._beginning["follow"] = follow
        if outcomes:
            self._beginning["outcomes"] = True

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

    def read(
        self,
        data: bytes,
        folder: Path = HERE,
        chosen: Mapping[str, Any] | None = None,
        others: Mapping[str, Any] | None = None,
    ) -> Content:
        """The content of a log, in UTF-8; not while a log is at work. ``chosen`` and ``folder`` as in ``begin``.

        With ``others``, what the message has under that name, it has the headers beside the log's own.
        """
        file = profile_file(header_line(data) or data, folder)
        message: dict[str, Any] = {"message": "read", "count": len(data), **({"file": file} if file else {})}
        if chosen:
            message["chosen"] = chosen
        if others is not None:
            message["others"] = others
        return self.ask(message, Content, data)

    def checked(self, kind: Literal["program", "offer"], text: bytes) -> dict[str, Any]:
        """The object of a text, in one spelling; not while a log is at work. Raises UnusableLogError."""
        return self._object({"message": kind}, text)

    def program_of(self, log: bytes) -> dict[str, Any]:
        """Header, duration, events from outside and bodies of the program of a log; not while a log is at work.

        Raises UnusableLogError.
        """
        file = profile_file(header_line(log) or log, HERE)
        return self._object({"message": "program of", **({"file": file} if file else {})}, log)

    def simulated(self, program: bytes, header: Mapping[str, Any], latency: int, **how: Any) -> dict[str, Any]:
        """What comes of a program of the kit under this header; not while a log is at work.

        ``how`` and the answer are those of the message ``simulate``. Raises UnusableLogError.
        """
        return self._object({"message": "simulate", "header": header, "latency": latency, **how}, program)

    def tell(self, texts: Callable[[], Mapping[str, Any]]) -> None:
        """Tells the engine the ``texts`` of its message of that name, once; not while a log is at work."""
        if self._idle is None or self._idle is not self._told:
            self.ask({"message": "texts", **texts()}, _Rejected)
            self._told = self._idle

    def refusal(self, line: bytes) -> Refusal:
        """Why the last log was rejected at this line; not while a log is at work."""
        return self.ask({"message": "rejected", "line": line.decode(errors="replace")}, _Rejected).refusal

    def readings(self, **outcomes: Any) -> list[Part]:
        """What is said of verdicts under other headers, the fields of the message; not while a log is at work."""
        return self.ask({"message": "readings", **outcomes}, _Parts).parts

    def _object(self, message: dict[str, Any], text: bytes) -> dict[str, Any]:
        answer = self.ask({**message, "count": len(text)}, Checked, text)
        if answer.unusable is not None:
            raise answer.unusable.error()
        if answer.error:
            raise EngineError(answer.error)
        return answer.object

    def ask(self, message: dict[str, Any], shape: type[_Shape], data: bytes = b"") -> _Shape:
        """The answer to a message with one answer, which has this shape; not while a log is at work."""
        process = self._idle = self._ready()
        with self._dropped_on_error(process):
            process.write(self._encoder.encode(message) + b"\n" + data)
            return _decode(process.line(), shape)

    def _ready(self) -> EngineProcess:
        """The idle process, if it still runs, or else a new one."""
        if self._idle is not None:
            if self._idle.running:
                return self._idle
            self._drop(self._idle)
        command = self.command()
        try:
            return self._started(command)
        except EngineError:
            if not forget_archive(command):
                raise
        return self._started(self.command())

    def _started(self, command: list[str]) -> EngineProcess:
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
        if process.crashed:
            forget_archive(process.command)
        process.end(at_once=True)
        self._idle = None if self._idle is process else self._idle
        self._at_work = None if self._at_work is process else self._at_work

    def send(self, data: bytes) -> None:
        """Sends the next bytes of the log, in UTF-8 without a byte order mark; once it is decided they are dropped."""
        if self._head is not None:
            self._head += data
            if header_line(self._head) is not None:
                self._send_head()
        elif self._at_work is not None and self._answer is None and data:
            self._say({"message": "bytes", "count": len(data)}, data)

    def _send_head(self) -> None:
        """Sends the header, with what it needs from outside, and what came with it."""
        head = self._head
        if head is not None:
            self._head = None
            file = profile_file(header_line(head) or head, self._folder)
            self._say(self._beginning | ({"file": file} if file else {}))
            self.send(head)

    def _say(self, message: dict[str, Any], data: bytes = b"") -> None:
        process = self._at_work
        if process is not None:
            with self._dropped_on_error(process):
                process.write(self._encoder.encode(message) + b"\n" + data, self._until)

    def _hear(self, process: EngineProcess) -> None:
        """Waits for the verdict."""
        with self._dropped_on_error(process):
            self._answer = _decode(process.line(self._until), Answer)

    def wait(self, fd: int) -> bool:
        """Waits until ``fd`` can be read. False once the log is decided, with or without input."""
        process = self._at_work
        if process is None:
            return wait_for_input(fd)
        if self._answer is None and process.output in readable(fd, process.output):
            self._hear(process)
        return self._answer is None

    def decided(self) -> bool:
        """Whether what was sent so far decides the log, whatever follows."""
        process = self._at_work
        if process is not None and self._answer is None:
            self._send_head()
            self._say({"message": "verdict"})
            with self._dropped_on_error(process):
                line = process.line()
                self._answer = None if line == _OPEN else _decode(line, Answer)
        return self._answer is not None

    def finish(self, broken: bool = False) -> Answer:
        """Ends the log that was begun, ``broken`` off or not, and returns the answer to it."""
        process = self._at_work
        if process is None:
            raise EngineError("no log was begun")
        self._send_head()
        self._say({"message": "finish", **({"broken": True} if broken else {})})
        if self._answer is None:
            self._hear(process)
        assert self._answer is not None
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
        options = [name for name in OPTIONS if name in os.environ]
        if line.startswith(b"{") or not options:
            raise EngineError(f"the engine answered {said}, which does not fit: {REMEDY}") from error
        named = " and ".join(f"{name}={os.environ[name]}" for name in options)
        raise EngineError(f"Java printed {said} where the engine answers: change {named}") from error
