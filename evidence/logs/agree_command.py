"""``s7spec logs agree``: do the trace checker's engine and TLC give the same verdict at the same line?"""

from __future__ import annotations

import sys
from pathlib import Path

import click

from evidence.common.options import folder_option, json_option, tlc_option, write_json
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.logs import agree_report as report
from evidence.logs.agree import compare
from evidence.logs.random_logs import SoftPlcError
from evidence.logs.tlc_batch import BatchError
from evidence.tla import tlc
from s7check.engine.command import EngineError
from s7check.resources import SPECIFICATION

DIFFER = 1


@click.command(name="agree", short_help="Do the engine and TLC judge random logs alike?")
@click.option("--logs", type=click.IntRange(1), default=10_000, show_default=True, help="How many logs.")
@click.option("--seed", type=int, default=1, show_default=True, help="Other logs.")
@tlc_option
@click.option("--jobs", type=click.IntRange(1), default=2, show_default=True, help="Runs of TLC at a time.")
@click.option(
    "--spec",
    type=click.Path(path_type=Path, exists=True, file_okay=False),
    default=SPECIFICATION,
    help="The specification that TLC reads. Default: the engine's own.",
)
@folder_option("--keep", Path("build") / "agreement" / "differences", "Where the logs go about which the two differ.")
@json_option
def agree_command(
    logs: int, seed: int, jar: Path | None, jobs: int, spec: Path, keep: Path, json_path: Path | None
) -> None:
    """Draw random logs, have the engine and TLC judge each, and compare verdict and line.

    The logs come from random programs on the soft PLC, as they are or damaged; the same seed gives the same logs. Exit
    codes: 0 the verdicts are the same, 1 some differ, 2 wrong arguments or files, 3 a tool is missing or failed.
    """
    processes = Processes()
    with session(processes, (OSError,), (tlc.ToolMissingError, EngineError, SoftPlcError, BatchError)) as console:
        found = compare(logs, seed, jobs, spec, tlc.find_toolchain(jar), processes, click.echo)
        report.keep(found, keep)
        report.show(console, found, keep)
        write_json(json_path, report.as_json(found))
    sys.exit(DIFFER if report.differences(found) else 0)
