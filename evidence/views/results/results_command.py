"""``s7spec views results``: the numbers of the documentation."""

from __future__ import annotations

import re
import sys
from collections.abc import Mapping
from pathlib import Path

import click

from evidence.common.checkout import ROOT
from evidence.common.options import tlc_option
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.tla.tlc import ToolMissingError
from evidence.views.results import records
from evidence.views.results.page import totals
from evidence.views.results.runs import RUNS, SECOND, RunError, old, take, take_over
from s7check import __version__
from s7check.engine.java import JavaMissingError

PAGE = Path("docs/project/results.md")
KEPT = Path("docs/project/results")

STALE = 1


@click.command(name="results", short_help="The numbers of the documentation, from runs.")
@click.option("--write", is_flag=True, help="Write the page from the kept summaries.")
@tlc_option
@click.option(
    "--report",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Run nothing: take the report that the command of the one RUN wrote there, such as build/verify/models.json.",
)
@click.argument("names", nargs=-1, metavar="[RUN]...", type=click.Choice(list(RUNS)))
def results_command(*, write: bool, jar: Path | None, report: Path | None, names: tuple[str, ...]) -> None:
    """Check that docs/project/results.md agrees with the kept summaries of runs.

    With RUN: run these commands, keep a summary of each in docs/project/results and write the page. With --tlc: keep it
    as a run on a second TLC.
    """
    with session(Processes(), (records.RecordError, OSError), (RunError, ToolMissingError, JavaMissingError)):
        if jar and not all(RUNS[name].tlc for name in names):
            raise click.UsageError("--tlc: only for runs of TLC")
        if report and (len(names) != 1 or not RUNS[names[0]].told):
            told = ", ".join(name for name, run in RUNS.items() if run.told)
            raise click.UsageError(f"--report: expected one of these runs: {told}")
        for name in names:
            record = take_over(name, jar, report) if report else take(name, jar, click.echo)
            records.write(ROOT / KEPT, name + (SECOND if jar else ""), record)
        kept = records.read(ROOT / KEPT)
        text = totals(kept)
        if write or names:
            (ROOT / PAGE).write_text(text, encoding="utf-8")
        problems = _problems(kept)
        if (ROOT / PAGE).read_text(encoding="utf-8") != text:
            problems.append(f"{PAGE}: not up to date: s7spec views results --write")
    for problem in problems:
        click.echo(problem)
    sys.exit(STALE if problems else 0)


def _problems(kept: Mapping[str, records.Record]) -> list[str]:
    """Say which runs are of an older text; those that are so since before the last release are a problem."""
    releases = re.findall(r"^## (\d[^\s]*)", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
    recent = {__version__, *[release for release in releases if release != __version__][:1]}
    found = old(kept)
    for name in found:
        click.echo(f"{name}: of an older text ({kept[name].date}, revision {kept[name].revision})")
    return [
        f"{KEPT / name}.json: its text is older than the last release: s7spec views results {name}"
        for name in found
        if kept[name].release not in recent
    ]
