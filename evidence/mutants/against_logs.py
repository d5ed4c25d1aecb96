"""Logs judged by a mutated specification: ``python -m evidence.mutants.against_logs SPEC CASES``.

CASES is what `keep` has written. A process of its own, so that an engine that no longer ends can be killed with it. It
prints the `Finding`, without its time.
"""

from __future__ import annotations

import hashlib
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

import msgspec

from evidence.common.cases import Case, difference
from evidence.mutants.findings import Finding
from s7check.engine.client import Engine
from s7check.engine.command import EngineError, jvm_command
from s7check.judging.check import check_log

UNREADABLE = "arsing or semantic analysis failed"
"""TLC's words for a specification that does not parse or has no meaning."""

KILLED = "the engine ended (killed by SIGKILL"
"""The message about an engine that something else has ended, for want of memory for instance."""


def keep(cases: Sequence[Case], file: Path) -> Path:
    """Write the cases for `judge`. Raises OSError."""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(msgspec.json.encode(cases))
    return file


def judge(spec: Path, file: Path) -> Finding:
    """Judge the logs of the cases, up to the first difference, which `detail` names.

    Raises `EngineError` where the engine fails for a reason outside of the specification.
    """
    java, *arguments = jvm_command(spec)
    command = [java, "-XX:TieredStopAtLevel=1", *arguments]
    cases = msgspec.json.decode(file.read_bytes(), type=list[Case])
    with Engine(lambda: command) as engine, TemporaryDirectory(prefix="s7check-") as folder:
        for case in cases:
            report = check_log(str(case.put(Path(folder))), engine, lambda _source, _events: None)
            if (differs := difference(case, report)) is None:
                continue
            if report.verdict != "no verdict":
                return Finding("log", differs)
            if KILLED in report.message:
                raise EngineError(differs)
            return Finding("invalid" if UNREADABLE in report.message else "error", differs)
    return Finding("survived")


def fingerprint(cases: Path) -> str:
    """A hash of the engine and the cases. Raises `EngineError` if there is no engine."""
    command = jvm_command()
    classpath = command[command.index("-cp") + 1].split(os.pathsep)
    digest = hashlib.sha256()
    for file in (*map(Path, classpath), cases):
        digest.update(hashlib.sha256(file.read_bytes()).digest())
    return digest.hexdigest()


if __name__ == "__main__":
    print(msgspec.json.encode(judge(Path(sys.argv[1]), Path(sys.argv[2]))).decode())  # noqa: T201
