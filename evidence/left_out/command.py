"""``s7check left-out``: does an accepted log stay accepted when kinds of event are left out?

Exit codes: 0 each does, 1 some do not, 2 wrong arguments or files, 3 a tool is missing or failed, 130 interrupted.
"""

from __future__ import annotations

import json
import shutil
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from random import Random

import click

from evidence.common.checkout import SOFT_PLC_PROGRAM
from evidence.common.console import plain
from evidence.common.options import json_option, write_json
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.random_logs.damage import Log
from evidence.random_logs.drop import subsets, without
from evidence.random_logs.generate import Generator, SoftPlcError
from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.judging.check import check_log
from s7check.judging.verdict import Report
from s7check.judging.workers import Workers

WORSE = 1

LOOSE = "too many explanations"
"""The checker's words for a log of which it follows only certain facts."""


@dataclass
class Found:
    """How many complete logs were accepted, what became of them with kinds left out, and the logs that got worse.

    Of a worse one: its number, the kinds left out, the verdict and the line.
    """

    logs: int = 0
    verdicts: Counter[str] = field(default_factory=Counter)
    loose: int = 0
    worse: list[dict[str, object]] = field(default_factory=list)


@click.command(name="left-out", short_help="Do accepted logs stay accepted with kinds of event left out?")
@click.option("--logs", type=click.IntRange(1), default=10_000, show_default=True, help="How many accepted logs.")
@click.option("--seed", type=int, default=1, show_default=True, help="Other logs.")
@click.option(
    "--keep",
    type=click.Path(path_type=Path, file_okay=False),
    default=Path("build") / "left_out",
    show_default=True,
    help="Where the logs go that got worse.",
)
@json_option
def left_out_command(logs: int, seed: int, keep: Path, json_path: Path | None) -> None:
    """Draw random logs, and leave every subset of the kinds of event out of each that is accepted.

    None may be rejected then, and none may be without a verdict. Exit codes: 0 none is, 1 some are, 2 wrong arguments
    or files, 3 a tool is missing or failed.
    """
    began = time.monotonic()
    with session(Processes(), (OSError,), (EngineError, SoftPlcError)) as console:
        found = leave_out(logs, seed, keep)
        for one in found.worse:
            plain(console, f"{one['file']}: {one['verdict']} at line {one['line']}", style="red")
        total = found.verdicts.total()
        plain(console, f"{found.logs:,} accepted logs, {total:,} with kinds left out: {len(found.worse):,} got worse")
        plain(console, f"of {found.loose:,} only certain facts were followed from some line on")
        document = {
            "logs": found.logs, "left_out": total, "loose": found.loose, "worse": found.worse,
            "seconds": round(time.monotonic() - began),
        }  # fmt: skip
        write_json(json_path, document)
    sys.exit(WORSE if found.worse else 0)


def leave_out(logs: int, seed: int, keep: Path) -> Found:
    """Judge so many accepted logs with every subset of kinds left out. Raises `EngineError`, `SoftPlcError`."""
    found = Found()
    generator = Generator(seed, SOFT_PLC_PROGRAM, [])
    with Workers(Engine) as workers, tempfile.TemporaryDirectory(prefix="s7check-left-out-") as temporary:
        number = 0
        while found.logs < logs:
            number += 1
            log = generator.written(Random(f"left out/{seed}/{number}"))  # noqa: S311
            whole = _write(Path(temporary) / "whole.ndjson", log)
            if workers.submit(whole, _judge).result().verdict != "accepted":
                continue
            found.logs += 1
            parts = [
                _write(Path(temporary) / f"{seed}-{number}-{'-'.join(sorted(kinds))}.ndjson", without(log, kinds))
                for kinds in subsets()
            ]
            for file, judged in zip(parts, workers.in_order(parts, _judge), strict=True):
                report = judged.result()
                found.verdicts[report.verdict] += 1
                found.loose += LOOSE in report.message
                if report.verdict != "accepted":
                    keep.mkdir(parents=True, exist_ok=True)
                    kept = shutil.copy(file, keep)
                    found.worse.append({"file": str(kept), "verdict": report.verdict, "line": report.line})
                file.unlink()
    return found


def _write(file: Path, log: Log) -> Path:
    file.write_text("".join(json.dumps(entry) + "\n" for entry in (log.header, *log.events)), encoding="utf-8")
    return file


def _judge(file: Path, engine: Engine) -> Report:
    return check_log(str(file), engine, lambda _source, _events: None)
