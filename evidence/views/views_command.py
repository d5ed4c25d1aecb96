"""``s7spec views make``: all that is made from data and not kept, and whether the data are as new as their origin."""

from __future__ import annotations

import shutil
from pathlib import Path

import click

from evidence.common import gallery
from evidence.common.checkout import ROOT
from evidence.common.console import plain
from evidence.common.options import folder_option
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.kit import kept_paths, measured, programs
from evidence.views import vectors
from evidence.views.made import views
from evidence.views.traceability.project import read_project
from s7check.engine.client import Engine
from s7check.engine.command import EngineError

STALE = 1


@click.command("make", short_help="Pages, experiments' sources and the kit's programs, from the kept data.")
@folder_option("--output", ROOT / "build" / "views", "The folder; its old content is removed.")
def make_command(output: Path) -> int:
    """Write the views, and name kept data that are older than what they were made from."""
    with session(Processes(), (OSError, ValueError), (EngineError,)) as console:
        with Engine() as engine:
            made = views(read_project(ROOT), engine)
        problems = [*kept_paths.problems(), *measured.problems()]
        shutil.rmtree(output, ignore_errors=True)
        for place, text in made.items():
            (output / place).parent.mkdir(parents=True, exist_ok=True)
            (output / place).write_text(text, encoding="utf-8")
        gallery.write(output / "gallery")
        count = programs.write(output / "kit" / "programs")
        logs = vectors.write(output / "vectors")
        plain(console, f"{output}: {len(made)} pages and sources, {count} programs of the kit, {logs} vectors")
        for problem in problems:
            plain(console, problem)
    return STALE if problems else 0
