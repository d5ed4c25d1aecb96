"""What a log costs: CPU seconds and memory of the whole check, and the states that it leads to."""

from __future__ import annotations

import json
import os
import resource
import signal
import time
from dataclasses import asdict, dataclass
from multiprocessing import get_context
from pathlib import Path
from tempfile import TemporaryDirectory

from evidence.logs.damage import Log
from evidence.logs.growth_logs import Kind, text
from s7check.engine.answer import Answer
from s7check.engine.client import Engine
from s7check.engine.command import EngineError


@dataclass(frozen=True)
class Cost:
    """The verdict, its line, whether the check was loosened, and its cost.

    ``cpu``: seconds of the engine with its start; ``memory``: MB; ``largest``, ``followed``: as in the engine's answer.
    """

    kind: str
    lines: int
    verdict: str
    line: int | None
    loose: int | None
    largest: int
    followed: int
    cpu: float
    memory: int
    message: str = ""


def answer_of(engine: Engine, log: Log, until: float | None = None) -> Answer:
    """The engine's answer to a log. Raises `EngineError`."""
    engine.begin(until=until)
    engine.send(text(log).encode())
    return engine.finish()


def cost_of(kind: Kind, size: int, limit: float) -> Cost:
    """What a log of this size costs in an engine of its own, which gets so many seconds."""
    log = kind.log(size)
    with TemporaryDirectory() as folder:
        report = Path(folder) / "cost"
        process = get_context("fork").Process(target=_measured, args=(kind, log, limit, report))
        process.start()
        process.join(limit + 10)
        if process.is_alive():
            os.kill(process.pid or 0, signal.SIGKILL)
            process.join()
        if not report.exists():
            return Cost(kind.name, len(log.events) + 1, "none in time", None, None, 0, 0, limit, 0)
        return Cost(**json.loads(report.read_text()))


def _measured(kind: Kind, log: Log, limit: float, report: Path) -> None:
    answer = Answer("error")
    try:
        with Engine() as engine:
            answer = answer_of(engine, log, time.monotonic() + limit)
    except EngineError as error:
        answer = Answer("error", message=str(error) or "too slow")
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    cost = Cost(
        kind.name, len(log.events) + 1, answer.verdict, answer.line, answer.loose, answer.largest, answer.followed,
        round(used.ru_utime + used.ru_stime, 2), used.ru_maxrss // 1024, answer.message[:90],
    )  # fmt: skip
    report.write_text(json.dumps(asdict(cost)))
