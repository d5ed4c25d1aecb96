"""``s7spec witnesses``: is anything in the specification checked in vain?"""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass
from pathlib import Path

import click
import msgspec
from rich.console import Console

from evidence.common import reasons
from evidence.common.options import json_option, manifest_option, tlc_option, write_json
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.models.entries import LANES, ManifestError
from evidence.models.manifest import load
from evidence.models.models_report import Progress
from evidence.models.runner import Harness
from evidence.mutants import logs_model as logs
from evidence.mutants import witnesses_report as report
from evidence.mutants.conditions import conditions
from evidence.mutants.witnesses import CollectingError, collect
from evidence.tla import log_as_tla, tlc
from evidence.tla.modules import closure, read_modules
from evidence.tla.syntax import SyntaxTreeError

UNEXPLAINED = 1

KINDS = ("model", "refinement", "calendar")
"""The kinds of models that look for witnesses; a liveness model takes the same steps and longer."""


@dataclass(frozen=True)
class Request:
    """The command's arguments."""

    against: str
    lane: str
    manifest: Path
    jar: Path | None
    jobs: int
    json: Path | None
    names: tuple[str, ...]


@click.command(name="witnesses", short_help="Is any rule or property of the specification checked in vain?")
@click.option(
    "--against",
    type=click.Choice(["models", "logs", "all"]),
    default="all",
    show_default=True,
    help="What has to bear witness.",
)
@click.option("--lane", type=click.Choice(LANES), default="ci", show_default=True, help="Which models.")
@manifest_option
@tlc_option
@click.option("--jobs", type=click.IntRange(1), default=2, show_default=True, help="Cores to use.")
@json_option
@click.argument("names", nargs=-1, metavar="[MODEL]...")
def witnesses_command(
    against: str,
    lane: str,
    manifest: Path,
    jar: Path | None,
    jobs: int,
    json_path: Path | None,
    names: tuple[str, ...],
) -> None:
    """Run the models that pass, and the shipped logs, and see which rules and antecedents they never meet.

    MODEL picks models (globs work) whatever their lane. Every action, both sides of every guard and every antecedent
    need a witness, or a reason in witnesses.json beside the manifest.
    """
    processes = Processes()
    usage = (ManifestError, SyntaxTreeError, reasons.ReasonsError, OSError, msgspec.MsgspecError)
    with session(processes, usage, (tlc.ToolMissingError, CollectingError)) as console:
        request = Request(against, lane, manifest, jar, jobs, json_path, names)
        sys.exit(run_request(request, processes, console))


def run_request(request: Request, processes: Processes, console: Console) -> int:
    """Do the work and return the exit code."""
    manifest = load(request.manifest)
    why = reasons.read(manifest.directory / "witnesses.json", reasons.Excuse)
    harness = Harness(manifest, tlc.find_toolchain(request.jar), processes)
    spec = read_modules(manifest.spec)
    found = conditions(spec)
    models = []
    roots = []
    if request.against != "logs":
        models = [m for m in manifest.select(request.lane, request.names) if m.kind in KINDS]
        roots += [m.module.stem for m in models]
    traces = None
    if request.against != "models":
        traces = manifest.directory.parent / "traces"
        roots.append(log_as_tla.ROOT)
    known = read_modules(manifest.directory) | spec
    scope = {name for root in roots for name in closure(root, known)}
    began = time.monotonic()
    with Progress(console, len(roots)) as progress:
        seen = collect(harness, spec, found, models, traces, request.jobs, progress)
    judged = [s for s in seen if s.condition.module in scope]
    explained = report.explain(judged, why, (c.id for c in found))
    report.show(console, explained)
    ran = [m.name for m in models] + ([logs.NAME] if traces else [])
    document = report.as_json(explained, ran, time.monotonic() - began)
    write_json(request.json, document)
    return 0 if explained.ok else UNEXPLAINED
