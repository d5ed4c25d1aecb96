"""The engine and TLC on the same logs and the same specification."""

from __future__ import annotations

import json
import shutil
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from itertools import count
from pathlib import Path

from evidence.common.checkout import SOFT_PLC_PROGRAM
from evidence.common.processes import Processes
from evidence.logs import tlc_batch
from evidence.logs.random_logs import Generated, Generator
from evidence.logs.tlc_batch import Judged
from evidence.tla import tlc
from s7check.engine.client import Engine
from s7check.engine.command import jvm_command
from s7check.judging.check import check_log
from s7check.resources import SPECIFICATION

BATCH = 200
"""Logs of a run of TLC."""

TOO_MANY = ("states explain the log", "too many explanations")
"""The engine's words for a log with more explanations than it follows."""

FIRST = 2
"""The first line of an event."""


@dataclass(frozen=True)
class Compared:
    """A log, counted from 1, and its two verdicts. `event` is the event that the engine rejects, or empty."""

    number: int
    log: Generated
    event: str
    engine: Judged
    tlc: Judged

    @property
    def agree(self) -> bool:
        """Whether both say the same of the same line."""
        return self.engine == self.tlc


@dataclass(frozen=True)
class Comparison:
    """All logs with their verdicts, in order.

    Not among them are `unreadable` ones that the reader refuses, and `endless` ones that can be explained in more ways
    than the engine follows; others have taken their place. `seconds` are those of engine and generation, and those of
    TLC, summed over its runs.
    """

    logs: list[Compared]
    unreadable: int
    endless: int
    engine_seconds: float
    tlc_seconds: float
    tlc_version: str


@dataclass(frozen=True)
class _Drawn:
    """A log that the engine has judged."""

    number: int
    file: Path
    log: Generated
    event: str
    judged: Judged


def compare(
    logs: int, seed: int, jobs: int, spec: Path, tools: tlc.Toolchain, processes: Processes, tell: Callable[[str], None]
) -> Comparison:
    """Draw so many logs of a seed and have both judge them; TLC reads the folder `spec`, in so many runs at a time.

    `tell` hears how far it is.

    Raises `SoftPlcError`, `EngineError`, `BatchError`, and `InterruptedRunError` if `processes` are closed.
    """
    with tempfile.TemporaryDirectory(prefix="s7check-agree-", ignore_cleanup_errors=True) as temporary:
        folder = Path(temporary).resolve()
        # Nobody changes these copies meanwhile.
        ours, theirs = folder / "engine", folder / "tlc"
        shutil.copytree(SPECIFICATION, ours)
        shutil.copytree(spec, theirs)
        began = time.monotonic()
        drawn: list[_Drawn] = []
        refused: Counter[str] = Counter()
        with Engine(lambda: jvm_command(ours)) as engine:
            generator = Generator(seed, SOFT_PLC_PROGRAM, engine.alternatives())
            for number in range(1, logs + 1):
                drawn.append(_decided(generator, engine, number, folder / f"{number}.ndjson", refused))
                if number % BATCH == 0:
                    tell(f"engine: {number} of {logs} logs")
        engine_seconds = time.monotonic() - began
        batches = [drawn[first : first + BATCH] for first in range(0, len(drawn), BATCH)]
        judged: dict[int, Judged] = {}
        tlc_seconds = 0.0
        version = ""
        for batch, said in _by_tlc(batches, jobs, tools, processes, theirs):
            judged |= {one.number: verdict for one, verdict in zip(batch, said.verdicts, strict=True)}
            tlc_seconds += said.seconds
            version = said.version
            tell(f"TLC: {len(judged)} of {logs} logs")
        compared = [Compared(one.number, one.log, one.event, one.judged, judged[one.number]) for one in drawn]
    return Comparison(compared, refused["unreadable"], refused["endless"], engine_seconds, tlc_seconds, version)


def _decided(generator: Generator, engine: Engine, number: int, file: Path, refused: Counter[str]) -> _Drawn:
    """A log that the engine can judge, written to `file`; `refused` counts the unsuitable logs before it."""
    for attempt in count():
        log = generator.draw(number, attempt)
        file.write_bytes(log.content)
        if engine.read(log.content).unusable is not None:
            refused["unreadable"] += 1
            continue
        report = check_log(str(file), engine, lambda _source, _events: None)
        # From a later line on the engine follows definite facts alone; TLC would follow every explanation.
        gave_up = report.certain_from is not None and report.certain_from > FIRST
        if not gave_up and not any(words in report.message for words in TOO_MANY):
            break
        refused["endless"] += 1
    event = json.loads(report.event)["event"] if report.event is not None else ""
    return _Drawn(number, file, log, event, Judged(report.verdict, report.line))


def _by_tlc(
    batches: Sequence[list[_Drawn]], jobs: int, tools: tlc.Toolchain, processes: Processes, spec: Path
) -> Iterator[tuple[list[_Drawn], tlc_batch.Batch]]:
    """Yield TLC's verdicts about each batch as they come. When the iterator ends, for any reason, TLC ends too."""
    with ThreadPoolExecutor(jobs) as pool:
        runs = {
            pool.submit(tlc_batch.judge, tools, processes, spec, [one.file for one in batch]): batch
            for batch in batches
        }
        try:
            for run in as_completed(runs):
                yield runs[run], run.result()
        except BaseException:
            processes.close()
            pool.shutdown(cancel_futures=True)
            raise
