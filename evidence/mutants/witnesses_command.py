"""``s7spec witnesses``: is anything in the specification checked in vain?"""

from __future__ import annotations

import sys
import time
from pathlib import Path

import click
import msgspec

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
        listed = load(manifest)
        why = reasons.read(listed.directory / "witnesses.json", reasons.Excuse)
        harness = Harness(listed, tlc.find_toolchain(jar), processes)
        spec = read_modules(listed.spec)
        found = conditions(spec)
        chosen = listed.select(lane, names) if against != "logs" else []
        models = [model for model in chosen if model.kind in KINDS]
        traces = listed.directory.parent / "traces" if against != "models" else None
        roots = [model.module.stem for model in models] + ([log_as_tla.ROOT] if traces else [])
        known = read_modules(listed.directory) | spec
        scope = {name for root in roots for name in closure(root, known)}
        began = time.monotonic()
        with Progress(console, len(roots)) as progress:
            seen = collect(harness, spec, found, models, traces, jobs, progress)
        explained = report.explain([s for s in seen if s.condition.module in scope], why, (c.id for c in found))
        report.show(console, explained)
        ran = [model.name for model in models] + ([logs.NAME] if traces else [])
        write_json(json_path, report.as_json(explained, ran, time.monotonic() - began))
        sys.exit(0 if explained.ok else UNEXPLAINED)
