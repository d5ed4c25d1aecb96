"""The shipped logs judged by a mutated specification: ``python -m evidence.mutants.against_logs SPEC TRACES``.

A process of its own, so that an engine that no longer ends can be killed with it. It prints one `Judged`.
"""

from __future__ import annotations

import hashlib
import os
import sys
from pathlib import Path

import msgspec

from evidence.common.shipped import difference, index_files, shipped_logs
from evidence.mutants.findings import How
from s7check.engine.client import Engine
from s7check.engine.command import EngineError, engine_command
from s7check.judging.check import check_log

UNREADABLE = "arsing or semantic analysis failed"
"""TLC's words for a specification that does not parse or has no meaning."""

KILLED = "the engine ended (killed by SIGKILL"
"""The message about an engine that something else has ended, for want of memory for instance."""


class Judged(msgspec.Struct, frozen=True):
    """The finding of the logs; `detail` names the log with another verdict than its index says."""

    how: How
    detail: str = ""


def judge(spec: Path, traces: Path) -> Judged:
    """Judge the shipped logs, up to the first difference.

    Raises `EngineError` where the engine fails for a reason outside of the specification.
    """
    java, *arguments = engine_command(spec)
    command = [java, "-XX:TieredStopAtLevel=1", *arguments]
    with Engine(lambda: command) as engine:
        for expected in shipped_logs(traces):
            report = check_log(str(traces / expected.file), engine, lambda _source, _events: None)
            if (differs := difference(expected, report)) is None:
                continue
            if report.verdict != "no verdict":
                return Judged("log", differs)
            if KILLED in report.message:
                raise EngineError(differs)
            return Judged("invalid" if UNREADABLE in report.message else "error", differs)
    return Judged("survived")


def fingerprint(traces: Path) -> str:
    """A hash of the engine and the shipped logs. Raises `EngineError` if there is no engine."""
    command = engine_command()
    classpath = command[command.index("-cp") + 1].split(os.pathsep)
    files = [Path(jar) for jar in classpath] + sorted(traces.rglob("*.ndjson")) + index_files(traces)
    digest = hashlib.sha256()
    for file in files:
        digest.update(hashlib.sha256(file.read_bytes()).digest())
    return digest.hexdigest()


if __name__ == "__main__":
    print(msgspec.json.encode(judge(Path(sys.argv[1]), Path(sys.argv[2]))).decode())  # noqa: T201
