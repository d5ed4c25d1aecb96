"""``s7spec kit paths``: the programs of the kit that need TLC."""

from __future__ import annotations

import click

from evidence.common.console import plain
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.kit import kept_paths
from evidence.kit.paths import NoGraphError
from evidence.tla.tlc import ToolMissingError

STALE = 1


@click.command("paths", short_help="Paths through the graphs of models, as programs of the kit.")
@click.option("--write", is_flag=True, help="Have TLC find the paths anew, in minutes, and keep them.")
def paths_command(*, write: bool) -> int:
    """Say whether kit/paths.ndjson.gz is as new as the specification and the models that the paths go through."""
    processes = Processes()
    with session(processes, (OSError, ValueError), (ToolMissingError, NoGraphError)) as console:
        if write:
            kept_paths.renew(processes)
        for problem in (problems := kept_paths.problems()):
            plain(console, problem)
    return STALE if problems else 0
