"""The engine as an operating system process: lines in, lines out, and why it ended."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

from s7check.engine import limits
from s7check.engine.command import EngineError
from s7check.log.errors import printable
from s7check.readable import AT_ONCE, readable, writable
from s7check.resources import NATIVE, REMEDY

_PATIENCE = 5
"""Seconds that the engine gets to end once its input has."""

FOLDER = "s7check-engine-"
"""How the name of its folder begins. The engine knows it too: it removes the folder if its parent was killed."""

_NO_MEMORY = "lack of free memory"
"""What the executable says last."""

_CRASH = b"#"
"""How the lines begin that a JVM prints when it crashes, wherever its output goes."""

_CRASHES = tuple(-number for number in (signal.SIGABRT, signal.SIGSEGV, getattr(signal, "SIGBUS", signal.SIGSEGV)))

_READ = 64 * 1024
_SHOWN = 300


class EngineTooSlowError(EngineError):
    """The engine has not done its work in the time that it was given."""


class EngineProcess:
    """A running engine; ``output`` is the file descriptor on which its lines come.

    In Java its current folder is a new one, for temporary files; it goes with the process, however that ends.
    Raises EngineError if it cannot be started, and from then on if it has ended.
    """

    def __init__(self, command: list[str]) -> None:
        self.command = command
        self._received = b""
        self._fds: list[int] = []
        self._folder = ""
        try:
            if command[0] != str(NATIVE):
                from tempfile import mkdtemp

                self._folder = mkdtemp(prefix=FOLDER)
            self._errors = _nameless_file()
            self._fds.append(self._errors)
            input_end, self._input = os.pipe()
            self._fds += [input_end, self._input]
            self.output, output_end = os.pipe()
            self._fds += [self.output, output_end]
            self._process = subprocess.Popen(
                command, stdin=input_end, stdout=output_end, stderr=self._errors, cwd=self._folder or None
            )
        except OSError as error:
            self._close()
            self._clear()
            remedy = f": {raised}" if (raised := limits.advice()) else ""
            raise EngineError(f"the engine could not be started ({error}){remedy}") from error
        for fd in (input_end, output_end):
            os.close(fd)
            self._fds.remove(fd)

    @property
    def running(self) -> bool:
        """Whether the process has not ended yet."""
        return self._process.poll() is None

    @property
    def ended_by_itself(self) -> bool:
        """Whether the process has ended, and not by a signal."""
        code = self._process.poll()
        return code is not None and code >= 0

    @property
    def crashed(self) -> bool:
        """Whether the JVM itself has failed, as with a damaged archive of classes."""
        return self._process.poll() in _CRASHES

    def write(self, data: bytes, until: float | None = None) -> None:
        """Sends ``data``; blocks while the engine is busy with earlier data.

        Raises EngineTooSlowError if it has not taken the data at the time ``until`` of ``time.monotonic``.
        """
        rest = memoryview(data)
        try:
            while rest:
                if until is not None and not writable(self._input, until - time.monotonic()):
                    raise EngineTooSlowError
                rest = rest[os.write(self._input, rest if until is None else rest[:AT_ONCE]) :]
        except OSError as error:  # a broken pipe, for which Windows has another number
            raise self._ended() from error

    def line(self, until: float | None = None) -> bytes:
        """The next line from the engine, without its end; blocks until it has come.

        Raises EngineTooSlowError if it has not come at the time ``until`` of ``time.monotonic``.
        """
        while b"\n" not in self._received:
            if until is not None and not readable(self.output, seconds=until - time.monotonic()):
                raise EngineTooSlowError
            piece = os.read(self.output, _READ)
            if not piece:
                raise self._ended()
            self._received += piece
        line, self._received = self._received.split(b"\n", 1)
        if line.startswith(_CRASH):
            raise self._ended()
        return line

    def end(self, at_once: bool = False) -> None:
        """Ends the process by the end of its input, or kills it."""
        if at_once:
            self._process.kill()
        self._close()
        try:
            self._process.wait(_PATIENCE)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._clear()

    def _clear(self) -> None:
        if self._folder:
            import shutil

            shutil.rmtree(self._folder, ignore_errors=True)

    def _close(self) -> None:
        while self._fds:
            os.close(self._fds.pop())

    def _ended(self) -> EngineError:
        """Why a process that has closed its pipes is gone."""
        try:
            code = self._process.wait(_PATIENCE)
        except subprocess.TimeoutExpired:
            return EngineError(f"the engine broke off: try again, then {REMEDY}")
        os.lseek(self._errors, 0, os.SEEK_SET)
        said = os.read(self._errors, _READ).decode(errors="replace").strip()
        if "OutOfMemoryError" in said:
            return EngineError("the engine ran out of memory: give it more, JDK_JAVA_OPTIONS=-Xmx4g for instance")
        if _NO_MEMORY in said:
            return EngineError("the engine ran out of memory: s7check --engine jvm can have more")
        if code in _CRASHES:
            return EngineError(
                f"{Path(self.command[0]).stem} crashed ({signal.Signals(-code).name}): try again, then {REMEDY}"
            )
        how = f"exit code {code}" if code >= 0 else f"killed by {signal.Signals(-code).name}"
        words = f", {printable(_gist(said), _SHOWN)}" if said else ""
        return EngineError(f"the engine ended ({how}{words}): try again, then {REMEDY}")


def _nameless_file() -> int:
    """A file for standard error: a pipe that nobody empties would block the process."""
    if sys.platform == "linux":
        return os.memfd_create("errors")
    import tempfile

    with tempfile.TemporaryFile() as errors:
        return os.dup(errors.fileno())


def _gist(said: str) -> str:
    """The line of a JVM's output that names the exception, else the last line."""
    lines = said.splitlines()
    return next((line for line in lines if line.startswith(("Exception in", "Error:"))), lines[-1])
