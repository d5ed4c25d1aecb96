"""``s7check agree``: do the trace checker's engine and TLC give the same verdict at the same line?

Exit codes: 0 they agree about all logs, 1 they differ about some, 2 wrong arguments or files, 3 a tool is missing or
failed, 130 interrupted.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import click

from evidence.agreement import report
from evidence.agreement.compare import Request, compare
from evidence.agreement.generate import SoftPlcError
from evidence.agreement.tlc_batch import BatchError
from evidence.models import tlc
from evidence.session import session
from s7check.engine_command import EngineError
from s7check.resources import SPECIFICATION

DIFFER = 1

SOFT_PLC = Path(__file__).resolve().parents[2] / "examples" / "soft_plc" / "build" / "soft_plc"


@click.command(name="agree", short_help="Do the engine and TLC judge random logs alike?")
@click.option("--logs", type=click.IntRange(1), default=10_000, show_default=True, help="How many logs.")
@click.option("--seed", type=int, default=1, show_default=True, help="Other logs.")
@click.option(
    "--tlc", "jar", type=click.Path(path_type=Path), help="TLC's jar. Default: $TLA2TOOLS_JAR, or the built one."
)
@click.option("--jobs", type=click.IntRange(1), default=2, show_default=True, help="Runs of TLC at a time.")
@click.option(
    "--spec",
    type=click.Path(path_type=Path, exists=True, file_okay=False),
    default=SPECIFICATION,
    help="The specification that TLC reads. Default: the engine's own.",
)
@click.option(
    "--keep",
    type=click.Path(path_type=Path, file_okay=False),
    default=Path("build") / "agreement" / "differences",
    show_default=True,
    help="Where the logs go about which the two differ.",
)
@click.option("--json", "json_path", type=click.Path(path_type=Path, dir_okay=False), help="Write the results there.")
def agree_command(
    logs: int, seed: int, jar: Path | None, jobs: int, spec: Path, keep: Path, json_path: Path | None
) -> None:
    """Draw random logs, have the engine and TLC judge each, and compare verdict and line.

    The logs come from random programs on the soft PLC, as they are or damaged; the same seed gives the same logs. Exit
    codes: 0 the verdicts are the same, 1 some differ, 2 wrong arguments or files, 3 a tool is missing or failed.
    """
    processes = tlc.Processes()
    with session(processes, (OSError,), (tlc.ToolMissingError, EngineError, SoftPlcError, BatchError)) as console:
        request = Request(logs, seed, jobs, spec, SOFT_PLC)
        found = compare(request, tlc.find_toolchain(jar), processes, click.echo)
        report.keep(found, keep)
        report.show(console, found, keep)
        if json_path is not None:
            json_path.parent.mkdir(parents=True, exist_ok=True)
            json_path.write_text(json.dumps(report.as_json(found), indent=1) + "\n", encoding="utf-8")
    sys.exit(DIFFER if report.differences(found) else 0)
