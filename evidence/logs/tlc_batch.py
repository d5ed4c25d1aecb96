"""Logs judged by TLC alone, many in one run: up to which line does the specification explain each of them?

The search is complete, so the furthest line that any state of a log has come to is the first line that cannot be
explained.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from evidence.common.processes import Processes
from evidence.models.manifest import HEAP_MB
from evidence.tla import log_as_tla, tlc
from evidence.tla.modules import module_folders
from s7check.log.source import open_log

MODULE = "Agreement"
TIMEOUT = 3600.0
"""Seconds for a batch."""

_REACHED = r"""
(* Says of each log how far it has come, whenever that is further than before. *)
Reached == IF index = 0 THEN Out!TLCSet(log, 0)
           ELSE \/ index <= Out!TLCGet(log)
                \/ Out!TLCSet(log, index) /\ Out!PrintT(<<"reached", log, index>>)
"""
_OPTIONS = tlc.Options(workers=1, deadlock=False, heap=HEAP_MB, timeout=TIMEOUT, brief=True)
_BEGUN = "@!@!@STARTMSG 2189"
"""TLC's message that the search begins; an earlier error is about no single log."""
_SAID = re.compile(r'<<"reached", (\d+), (\d+)>>')


class BatchError(RuntimeError):
    """TLC cannot read the specification or the logs; the text says why."""


@dataclass(frozen=True)
class Judged:
    """A verdict about a log. `line` is the physical line, counted from 1, that decides a log that is rejected."""

    verdict: str
    line: int | None = None

    def __str__(self) -> str:
        return self.verdict if self.line is None else f"{self.verdict} at line {self.line}"


@dataclass(frozen=True)
class Batch:
    """TLC's verdicts about a batch of logs, in their order; its version; the wall time in seconds."""

    verdicts: list[Judged]
    version: str
    seconds: float


def judge(tools: tlc.Toolchain, processes: Processes, spec: Path, files: Sequence[Path]) -> Batch:
    """Judge the logs by the specification in the folder `spec`. Raises `BatchError`, `InterruptedRunError`."""
    text = log_as_tla.module(MODULE, files, _REACHED)
    config = f"{log_as_tla.CONFIGURATION}INVARIANT Reached\n"
    with tlc.workspace(module_folders(spec), MODULE, text, config) as space:
        run = tlc.run(tools, space.as_one_module(), _OPTIONS, processes)
    if run.outcome.kind != "passed":
        if _BEGUN not in run.output:
            raise BatchError(f"TLC does not begin: {run.outcome.detail}")
        return _apart(tools, processes, spec, files, run)
    reached: dict[int, int] = {}
    for number, index in _SAID.findall(run.output):
        reached[int(number)] = max(int(index), reached.get(int(number), 0))
    verdicts = [_verdict(file, reached.get(number, 0)) for number, file in enumerate(files, 1)]
    return Batch(verdicts, run.outcome.version, run.seconds)


def _apart(tools: tlc.Toolchain, processes: Processes, spec: Path, files: Sequence[Path], failed: tlc.TlcRun) -> Batch:
    """Judge a failed batch in two halves, down to the single log without a verdict."""
    if len(files) == 1:
        return Batch([Judged(f"no verdict: {failed.outcome.detail}")], failed.outcome.version, failed.seconds)
    middle = len(files) // 2
    first, second = (judge(tools, processes, spec, half) for half in (files[:middle], files[middle:]))
    seconds = failed.seconds + first.seconds + second.seconds
    return Batch(first.verdicts + second.verdicts, failed.outcome.version, seconds)


def _verdict(file: Path, reached: int) -> Judged:
    """The verdict if TLC went as far as this event, counted from 1; the header is 0."""
    with open_log(str(file)) as source:
        content = b"".join(source.chunks())
    lines = [number for number, line in enumerate(content.split(b"\n"), 1) if line.strip()]
    return Judged("rejected", lines[reached]) if reached < len(lines) else Judged("accepted")
