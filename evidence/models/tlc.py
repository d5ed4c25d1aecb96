"""Finding TLC and running it."""

from __future__ import annotations

import contextlib
import hashlib
import os
import signal
import subprocess
import threading
import time
import zipfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from evidence.models.messages import Message, Outcome, Parser, interpret
from evidence.models.mutate import Workspace
from s7check import resources
from s7check.java import JavaMissingError, find_java

JAR_VARIABLE = "TLA2TOOLS_JAR"
PROGRESS_SECONDS = 10


class ToolMissingError(RuntimeError):
    """Java or TLC's jar is not there or too old; the text says what to do."""


class InterruptedRunError(RuntimeError):
    """The run was not started or was killed because the harness is ending."""


@dataclass(frozen=True)
class Toolchain:
    """A Java and a TLC. `sha256` is that of the jar; `flags` are arguments that only this TLC knows and needs."""

    java: str
    jar: Path
    sha256: str
    flags: tuple[str, ...]


def find_toolchain(jar: Path | None) -> Toolchain:
    """Find Java and TLC's jar: `jar`, else $TLA2TOOLS_JAR, else the one that the build puts beside the engine.

    Raises `ToolMissingError`.
    """
    if jar is None:
        named = os.environ.get(JAR_VARIABLE)
        jar = Path(named) if named else resources.TLC
    if not jar.is_file():
        raise ToolMissingError(
            f"TLC's jar is not at {jar}: {resources.REMEDY} (it puts the jar there), or name one by --tlc or "
            f"the environment variable {JAR_VARIABLE}"
        )
    try:
        with zipfile.ZipFile(jar) as archive:
            main = archive.read("tlc2/TLC.class")
    except (zipfile.BadZipFile, KeyError) as error:
        raise ToolMissingError(f"{jar} is not TLC's jar: it holds no tlc2.TLC") from error
    # Newer versions write a trace specification into the working directory after each violation unless told not to;
    # older ones refuse the argument. The class's string constants say which one this is.
    flags = ("-noGenerateSpecTE",) if b"-noGenerateSpecTE" in main else ()
    try:
        java = find_java()
    except JavaMissingError as error:
        raise ToolMissingError(str(error)) from error
    return Toolchain(java, jar.resolve(), hashlib.sha256(jar.read_bytes()).hexdigest(), flags)


class Processes:
    """The running Java processes, so that the end of the harness is theirs too. Safe to use from several threads."""

    def __init__(self) -> None:
        """Start with none."""
        self._lock = threading.Lock()
        self._running: set[subprocess.Popen[str]] = set()
        self._closed = False

    def start(self, command: list[str], directory: Path) -> subprocess.Popen[str]:
        """Start a process in a group of its own. Raises `InterruptedRunError` after `close`."""
        with self._lock:
            if self._closed:
                raise InterruptedRunError
            process = subprocess.Popen(
                command,
                cwd=directory,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                encoding="utf-8",
                errors="replace",
                start_new_session=True,
            )
            self._running.add(process)
            return process

    def end(self, process: subprocess.Popen[str]) -> None:
        """Kill what is left of the process's group, close its output, and forget it."""
        kill(process)
        with process:
            pass
        with self._lock:
            self._running.discard(process)

    def close(self) -> None:
        """Kill all and start no more."""
        with self._lock:
            self._closed = True
            for process in self._running:
                kill(process)

    @property
    def closed(self) -> bool:
        """Whether `close` was called."""
        return self._closed


def kill(process: subprocess.Popen[str]) -> None:
    """Kill the process with its whole group, which may be gone."""
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(process.pid, signal.SIGKILL)


@dataclass(frozen=True)
class TlcRun:
    """A finished run: TLC's exit code (negative: the signal that killed it), outcome, wall time, whole output."""

    exit: int
    outcome: Outcome
    seconds: float
    output: str


@dataclass(frozen=True)
class Options:
    """How a run is made: TLC workers, deadlock check, heap in MB, timeout in seconds, further arguments of TLC.

    `brief`: it is over before code that is compiled well would pay.
    """

    workers: int
    deadlock: bool
    heap: int
    timeout: float
    brief: bool = False
    args: tuple[str, ...] = ()


def command_line(tools: Toolchain, space: Workspace, options: Options) -> list[str]:
    """Return the command. Fingerprint function and seed are fixed, so that a run does the same each time."""
    liveness = () if "-lncheck" in options.args else ("-lncheck", "final")
    return [
        tools.java,
        "-XX:+UseSerialGC" if options.workers == 1 else "-XX:+UseParallelGC",
        *(("-XX:TieredStopAtLevel=1",) if options.brief else ()),
        f"-Xmx{options.heap}m",
        # TLC unpacks its standard modules here; two runs at a time must not share it.
        f"-Djava.io.tmpdir={space.scratch}",
        f"-DTLA-Library={os.pathsep.join(str(path) for path in space.library)}",
        f"-Dtlc2.TLC.progressInterval={PROGRESS_SECONDS}",
        "-cp",
        str(tools.jar),
        "tlc2.TLC",
        "-tool",
        *tools.flags,
        *("-fp", "0", "-seed", "1"),
        *("-metadir", str(space.scratch / "meta")),
        *("-workers", str(options.workers)),
        *(() if options.deadlock else ("-deadlock",)),
        *liveness,
        *options.args,
        *("-config", space.config.name),
        space.module,
    ]


def run(
    tools: Toolchain,
    space: Workspace,
    options: Options,
    processes: Processes,
    listen: Callable[[Message], None] = lambda _: None,
) -> TlcRun:
    """Run TLC once. `listen` has each message as it comes. Raises `InterruptedRunError` if the harness is ending."""
    began = time.monotonic()
    process = processes.start(command_line(tools, space, options), space.directory)
    timed_out = threading.Event()

    def expire() -> None:
        timed_out.set()
        kill(process)

    watchdog = threading.Timer(options.timeout, expire)
    watchdog.daemon = True
    watchdog.start()
    parser = Parser()
    lines: list[str] = []
    try:
        assert process.stdout is not None
        for line in process.stdout:
            lines.append(line)
            for message in parser.feed(line):
                listen(message)
        code = process.wait()
    finally:
        watchdog.cancel()
        processes.end(process)
    if processes.closed:
        raise InterruptedRunError
    seconds = time.monotonic() - began
    parser.finish()
    outcome = interpret(parser, code)
    if timed_out.is_set():
        outcome = replace(outcome, kind="timeout", detail=f"killed after {options.timeout:.0f} s")
    return TlcRun(code, outcome, seconds, "".join(lines))
