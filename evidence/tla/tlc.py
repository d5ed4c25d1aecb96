"""Finding TLC, the folder that it runs in, and a run of it."""

from __future__ import annotations

import contextlib
import hashlib
import os
import subprocess
import tempfile
import threading
import time
import zipfile
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from evidence.common.checkout import ROOT
from evidence.common.processes import Processes
from evidence.tla.flatten import Flat, flatten, split
from evidence.tla.messages import Message, Outcome, Parser, interpret
from evidence.tla.syntax import SyntaxTreeError
from s7check import resources
from s7check.engine.class_archive import archive_options
from s7check.engine.java import JavaMissingError, find_java

JAR_VARIABLE = "TLA2TOOLS_JAR"
PROGRESS_SECONDS = 10
MAIN_CLASS = "tlc2.TLC"
CONFIG_NAME = "harness.cfg"

_CANARY = ROOT / "models" / "canaries" / "CanaryLazyExcept"
_SAMPLE = ("-tool", "-metadir", ".", "-config", f"{_CANARY}.cfg", f"{_CANARY}.tla")
"""The arguments of a small run, which uses the classes that every run uses."""


class ToolMissingError(RuntimeError):
    """Java or TLC's jar is not there or too old; the text gives the remedy."""


@dataclass(frozen=True)
class Toolchain:
    """A Java and a TLC.

    `sha256` is that of the jar; `flags` are arguments that only this TLC knows and needs; `sharing` are options by
    which Java takes TLC's classes from an archive.
    """

    java: str
    jar: Path
    sha256: str
    flags: tuple[str, ...]
    sharing: tuple[str, ...] = ()


def find_toolchain(jar: Path | None) -> Toolchain:
    """Find Java and TLC's jar: `jar`, else $TLA2TOOLS_JAR, else the jar that the build puts beside the engine.

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
    jar = jar.resolve()
    sharing = archive_options([java, "-XX:+UseSerialGC"], [jar], [MAIN_CLASS, *_SAMPLE], b"", at_once=True)
    return Toolchain(java, jar, hashlib.sha256(jar.read_bytes()).hexdigest(), flags, tuple(sharing))


@dataclass(frozen=True)
class Workspace:
    """Where a run takes place: TLC's directory, its module's file name there, where to look for other modules.

    `scratch` is an empty directory for TLC's own files and Java's temporary ones. `flat` are the modules that stand
    there with all that the module extends.
    """

    directory: Path
    module: str
    library: tuple[Path, ...]
    scratch: Path
    flat: tuple[Flat, ...] = ()

    @property
    def config(self) -> Path:
        """The configuration file, next to the module."""
        return self.directory / CONFIG_NAME

    def located(self, line: str) -> str:
        """A line of TLC's output with the places of the modules as their authors see them."""
        for flat in self.flat:
            line = flat.located(line)
        return line

    def as_one_module(self, *, apart: bool = False) -> Workspace:
        """Put the module's text and that of all that it extends into its file, with which TLC starts faster.

        `apart`: what depends on variables and what does not stand beside it, with which TLC starts faster still. A
        module that the grammar cannot read stays as it is: TLC says where it is wrong.
        """
        top, folders = self.module.removesuffix(".tla"), [self.directory, *self.library]
        try:
            flat = split(top, folders) if apart else ()
            flat = flat or (flatten(top, folders),)
        except SyntaxTreeError:
            return self
        for one in flat:
            (self.directory / f"{one.name}.tla").write_text(one.text, encoding="utf-8")
        return replace(self, flat=flat)


@contextlib.contextmanager
def workspace(library: Iterable[Path], module: str, text: str, config: str) -> Iterator[Workspace]:
    """A temporary folder with a module's text and its configuration; other modules are looked for in `library`."""
    with temporary_folder() as folder:
        (folder / "scratch").mkdir()
        space = Workspace(folder, f"{module}.tla", tuple(library), folder / "scratch")
        (folder / space.module).write_text(text, encoding="utf-8")
        space.config.write_text(config, encoding="utf-8")
        yield space


@contextlib.contextmanager
def temporary_folder() -> Iterator[Path]:
    """A folder of a run, to which killed processes may write for another moment."""
    with tempfile.TemporaryDirectory(prefix="s7check-", ignore_cleanup_errors=True) as temporary:
        yield Path(temporary).resolve()


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
    """Return the command of a run by itself."""
    return [
        *java(tools, options, space.scratch),
        f"-DTLA-Library={os.pathsep.join(str(path) for path in space.library)}",
        *("-cp", str(tools.jar), MAIN_CLASS),
        *arguments(tools, space, options),
        space.module,
    ]


def java(tools: Toolchain, options: Options, scratch: Path) -> list[str]:
    """Return Java and its options. TLC unpacks its standard modules in `scratch`, which two JVMs must not share."""
    return [
        tools.java,
        *tools.sharing,
        "-XX:+UseSerialGC" if options.workers == 1 else "-XX:+UseParallelGC",
        *(("-XX:TieredStopAtLevel=1",) if options.brief else ()),
        f"-Xmx{options.heap}m",
        f"-Djava.io.tmpdir={scratch}",
        f"-Dtlc2.TLC.progressInterval={PROGRESS_SECONDS}",
    ]


def arguments(tools: Toolchain, space: Workspace, options: Options) -> list[str]:
    """Return TLC's arguments but the module. Fingerprint function and seed are fixed: a run does the same each time."""
    liveness = () if "-lncheck" in options.args else ("-lncheck", "final")
    return [
        "-tool",
        *tools.flags,
        *("-fp", "0", "-seed", "1"),
        *("-metadir", str(space.scratch / "meta")),
        *("-workers", str(options.workers)),
        *(() if options.deadlock else ("-deadlock",)),
        *liveness,
        *options.args,
        *("-config", space.config.name),
    ]


def run(
    tools: Toolchain,
    space: Workspace,
    options: Options,
    processes: Processes,
    listen: Callable[[Message], None] = lambda _: None,
) -> TlcRun:
    """Run TLC once. `listen` has each message as it comes. Raises `InterruptedRunError` if the harness is ending."""
    process = processes.start(command_line(tools, space, options), space.directory)
    with processes.limited(process, options.timeout) as expired:
        done = follow(process, space, expired, options, listen)
    assert done is not None
    return done


def follow(
    process: subprocess.Popen[str],
    space: Workspace,
    expired: threading.Event,
    options: Options,
    listen: Callable[[Message], None],
    until: str | None = None,
) -> TlcRun | None:
    """Read the output of a run to the end of the process, or to the line that begins with `until` and the exit code.

    None: the process ended before that line, within its time.
    """
    began = time.monotonic()
    parser = Parser()
    lines: list[str] = []
    code: int | None = None
    assert process.stdout is not None
    for said in process.stdout:
        if until is not None and said.startswith(until):
            code = int(said.removeprefix(until))
            break
        line = space.located(said)
        lines.append(line)
        for message in parser.feed(line):
            listen(message)
    if code is None:
        code = process.wait()
        if until is not None and not expired.is_set():
            return None
    seconds = time.monotonic() - began
    parser.finish()
    outcome = interpret(parser, code)
    if expired.is_set():
        outcome = replace(outcome, kind="timeout", detail=f"killed after {options.timeout:.0f} s")
    return TlcRun(code, outcome, seconds, "".join(lines))
