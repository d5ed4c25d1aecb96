"""``s7spec logs left-out``: is a faultless log accepted, and does it stay so when kinds of event are left out?"""

from __future__ import annotations

import json
import shutil
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass, field
from functools import partial
from itertools import count
from pathlib import Path
from random import Random

import click

from evidence.common.checkout import SOFT_PLC_PROGRAM
from evidence.common.console import plain
from evidence.common.options import folder_option, json_option, write_json
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.logs.damage import Log
from evidence.logs.drop import subsets, without
from evidence.logs.random_logs import Generator, SoftPlcError
from s7check.engine import pool
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.judging.check import check_log
from s7check.judging.workers import Workers
from s7check.report.report import Report

WORSE = 1

SUBSETS = list(subsets())


@dataclass
class Found:
    """How many complete logs were accepted, what became of them with kinds left out, and the logs that were not.

    Those are `worse`. Of each: its file, the verdict and the line.
    """

    logs: int = 0
    verdicts: Counter[str] = field(default_factory=Counter)
    loose: int = 0
    worse: list[dict[str, object]] = field(default_factory=list)

    def add(self, one: Found) -> None:
        """Count what was found of another log."""
        self.logs += one.logs
        self.verdicts += one.verdicts
        self.loose += one.loose
        self.worse += one.worse

    def add_worse(self, file: Path, report: Report, keep: Path) -> None:
        """Keep a log that should have been accepted."""
        keep.mkdir(parents=True, exist_ok=True)
        place = shutil.copy(file, keep)
        self.worse.append({"file": str(place), "verdict": report.verdict, "line": report.line})


@click.command(name="left-out", short_help="Do accepted logs stay accepted with kinds of event left out?")
@click.option("--logs", type=click.IntRange(1), default=10_000, show_default=True, help="How many accepted logs.")
@click.option("--seed", type=int, default=1, show_default=True, help="Other logs.")
@click.option(
    "--subsets",
    type=click.IntRange(1, len(SUBSETS)),
    default=len(SUBSETS),
    show_default=True,
    help="How many subsets of the kinds for each log; fewer than all are drawn by the seed.",
)
@click.option("--events", type=click.IntRange(1), help="How many events the soft PLC makes for a log; 9 to 59 if not.")
@folder_option("--keep", Path("build") / "left_out", "Where the logs go that are not accepted.")
@json_option
def left_out_command(
    logs: int, seed: int, subsets: int, events: int | None, keep: Path, json_path: Path | None
) -> None:
    """Draw random logs without a mistake, and leave subsets of the kinds of event out of each.

    None may be rejected, with or without them, and none may be without a verdict.
    """
    began = time.monotonic()
    with session(Processes(), (OSError,), (EngineError, SoftPlcError)) as console:
        found = leave_out(logs, Drawing(seed, subsets, events, keep))
        for one in found.worse:
            plain(console, f"{one['file']}: {one['verdict']} at line {one['line']}", style="red")
        total = found.verdicts.total()
        judged = f"{found.logs:,} accepted logs, {total:,} with kinds left out"
        plain(console, f"{judged}: {len(found.worse):,} not accepted")
        plain(console, f"of {found.loose:,} only definite facts were followed from some line on")
        document = {
            "logs": found.logs, "subsets": subsets, "events": events, "seed": seed, "left_out": total,
            "loose": found.loose, "worse": found.worse, "seconds": round(time.monotonic() - began),
        }  # fmt: skip
        write_json(json_path, document)
    sys.exit(WORSE if found.worse else 0)


@dataclass(frozen=True)
class Drawing:
    """Which logs are drawn, how many subsets of kinds of each, and where the logs go that are not accepted."""

    seed: int
    subsets: int
    events: int | None
    keep: Path


def leave_out(logs: int, drawing: Drawing) -> Found:
    """Judge so many accepted logs with kinds left out. Raises `EngineError`, `SoftPlcError`."""
    found = Found()
    generator = Generator(drawing.seed, SOFT_PLC_PROGRAM, pool.alternatives())
    work = partial(_of_a_log, drawing, generator)
    with Workers(Engine) as workers:
        for judged in workers.in_order(count(1), work):
            found.add(judged.result())
            if found.logs == logs:
                return found
    return found


def _of_a_log(drawing: Drawing, generator: Generator, number: int, engine: Engine) -> Found:
    """What was found of the log with this number."""
    name = f"left out/{drawing.seed}/{number}"
    log = generator.written(Random(name), drawing.events)  # noqa: S311
    with tempfile.TemporaryDirectory(prefix="s7check-left-out-") as temporary:
        found = Found()
        whole = _write(Path(temporary) / f"{drawing.seed}-{number}.ndjson", log)
        report = _judge(whole, engine)
        if report.verdict != "accepted":
            found.add_worse(whole, report, drawing.keep)
            return found
        found.logs = 1
        for kinds in Random(f"{name}/subsets").sample(SUBSETS, drawing.subsets):  # noqa: S311
            kept = f"{drawing.seed}-{number}-{'-'.join(sorted(kinds))}.ndjson"
            file = _write(Path(temporary) / kept, without(log, kinds))
            report = _judge(file, engine)
            found.verdicts[report.verdict] += 1
            found.loose += report.certain_from is not None
            if report.verdict != "accepted":
                found.add_worse(file, report, drawing.keep)
    return found


def _write(file: Path, log: Log) -> Path:
    file.write_text("".join(json.dumps(entry) + "\n" for entry in (log.header, *log.events)), encoding="utf-8")
    return file


def _judge(file: Path, engine: Engine) -> Report:
    return check_log(str(file), engine, lambda _source, _events: None)
