"""``s7spec views cases``: the cases of traces/ as NDJSON files, for users and for other tools."""

from __future__ import annotations

import shutil
from pathlib import Path

import click

from evidence.common.cases import TRACES, CasesError, all_cases
from evidence.common.checkout import ROOT
from evidence.common.console import plain
from evidence.common.options import folder_option
from evidence.common.processes import Processes
from evidence.common.session import session


@click.command(name="cases", short_help="Write the cases of traces/ out as logs.")
@folder_option("--output", ROOT / "build" / "traces", "Folder of the logs; its old content is removed.")
@click.argument("folder", type=click.Path(path_type=Path, file_okay=False, exists=True), default=TRACES)
def cases_command(folder: Path, output: Path) -> None:
    """Write the log of each case of FOLDER, traces/ by default, to AREA/accept, AREA/reject or AREA/unusable."""
    with session(Processes(), (CasesError, OSError), ()) as console:
        cases = all_cases(folder)
        shutil.rmtree(output, ignore_errors=True)
        for case in cases:
            case.put(output)
        plain(console, f"{output}: {len(cases)} logs")
