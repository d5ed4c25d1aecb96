"""``s7spec models``: run TLC on the listed models and fail on any drift."""

from __future__ import annotations

import contextlib
import re
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import click
from rich.console import Console

from evidence.common.checkout import MANIFEST, ROOT
from evidence.common.options import json_option, manifest_option, tlc_option, write_json
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.models import canaries, distributed
from evidence.models import models_report as report
from evidence.models.judge import Result, judge
from evidence.models.manifest import LANES, Manifest, ManifestError, Model, load
from evidence.models.manifest import shard as part_of
from evidence.models.progress import Progress
from evidence.models.runner import Event, Harness, run_all
from evidence.models.update import update
from evidence.tla import tlc
from evidence.tla.resident import Residents

DRIFT = 1


@dataclass(frozen=True)
class Request:
    """The command's arguments."""

    lane: str
    manifest: Path
    jar: Path | None
    workers: int | None
    jobs: int
    update: bool
    json: Path | None
    verbose: bool
    names: tuple[str, ...]
    cluster: distributed.Cluster | None = None
    shard: tuple[int, int] = (1, 1)
    logs: Path | None = None


def _part(_context: click.Context, _option: click.Parameter, value: str) -> tuple[int, int]:
    """Read the part and the number of parts."""
    found = re.fullmatch(r"(\d+)/(\d+)", value)
    if not found or not 1 <= int(found[1]) <= int(found[2]):
        raise click.BadParameter(f"{value!r}: expected I/N with I from 1 to N, such as 2/4")
    return int(found[1]), int(found[2])


@click.command(name="models", short_help="Model-check the specification.")
@click.option(
    "--lane", type=click.Choice(LANES), default="smoke", show_default=True, help="Which models: smoke, also ci, or all."
)
@manifest_option
@tlc_option
@click.option("--workers", type=click.IntRange(1), help="TLC workers for models that may have several.")
@click.option("--jobs", type=click.IntRange(1), default=2, show_default=True, help="Cores to use.")
@click.option("--update", is_flag=True, help="Pin the new counts (nothing else), and name the changes.")
@json_option
@click.option(
    "--logs",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="FILE",
    help="Write the behaviour of each violation as a case of this file.",
)
@click.option("-v", "--verbose", is_flag=True, help="Show TLC's whole output and whole traces.")
@click.option(
    "--distributed",
    "spread",
    type=click.IntRange(0),
    metavar="N",
    help="TLC's distributed mode with N workers here: models that must pass, without liveness.",
)
@click.option("--host", help="With --distributed: this machine's name for workers on other machines.")
@click.option(
    "--shard",
    metavar="I/N",
    default="1/1",
    callback=_part,
    help="Only the I-th of N parts of these models, for several machines.",
)
@click.argument("names", nargs=-1, metavar="[NAME]...")
def models_command(
    lane: str,
    manifest: Path,
    jar: Path | None,
    workers: int | None,
    jobs: int,
    update: bool,
    json_path: Path | None,
    logs: Path | None,
    verbose: bool,
    spread: int | None,
    host: str | None,
    shard: tuple[int, int],
    names: tuple[str, ...],
) -> None:
    """Run TLC on the models of the manifest and compare each result with its pins.

    NAME picks models (globs work) whatever their lane.
    """
    if spread is None and host is not None:
        raise click.UsageError("--host goes with --distributed")
    if spread == 0 and host is None:
        raise click.UsageError("--distributed 0 needs workers elsewhere: say --host")
    if spread is not None and update:
        raise click.UsageError("--distributed pins nothing: its counts but the distinct states differ")
    cluster = None if spread is None else distributed.Cluster(spread, host)
    processes = Processes()
    with session(processes, (ManifestError,), (tlc.ToolMissingError,)) as console:
        request = Request(lane, manifest, jar, workers, jobs, update, json_path, verbose, names, cluster, shard, logs)
        sys.exit(run_request(request, processes, console))


def run_request(request: Request, processes: Processes, console: Console) -> int:
    """Do the work and return the exit code."""
    manifest = load(request.manifest)
    selected = part_of(manifest.select(request.lane, request.names), *request.shard)
    tools = tlc.find_toolchain(request.jar)
    if request.cluster is not None and not distributed.works(tools):
        raise tlc.ToolMissingError(
            f"the distributed mode of {tools.jar} does not work: see docs/project/distributed.md"
        )
    began = time.monotonic()
    answers = canaries.run_canaries(tools, manifest.directory.parent / "build", processes)
    report.show_canaries(console, tools, answers)
    drift = list(manifest.drift)
    if not selected:
        drift.append(f"{manifest.path}: no model is in {_lane(request)}: nothing was checked")
    harness = Harness(manifest, tools, processes, request.workers)
    if request.cluster is not None:
        possible = _distributable(selected, console)
        drift += [f"{m.name} was named and not run" for m in selected if m not in possible and m.name in request.names]
        selected = possible
        if not selected:
            drift.append("no model that was asked for can be run in distributed mode: nothing was checked")
    with Progress(console, len(selected)) as progress:
        if request.cluster is None:
            with contextlib.closing(Residents(processes, request.jobs)) as residents:
                results = run_all(replace(harness, residents=residents), selected, request.jobs, progress)
        else:
            results = _run_distributed(harness, selected, request.cluster, progress)
    if request.update:
        results = _update(manifest, results, request, console)
    seconds = time.monotonic() - began
    if request.logs is not None:
        report.write_logs(request.logs, results)
    _show(results, drift, request, console)
    lane = None if request.names else _lane(request)
    report.show_tables(console, results, answers.version, lane, seconds)
    document = report.as_json(tools, answers, lane, results, drift, seconds)
    write_json(request.json, document)
    return DRIFT if drift or not all(r.ok for r in results) else 0


def _lane(request: Request) -> str:
    number, of = request.shard
    return request.lane if of == 1 else f"{request.lane}, shard {number}/{of}"


def _distributable(selected: list[Model], console: Console) -> list[Model]:
    for model in selected:
        if against := distributed.reason_against(model):
            console.print(f"not run: {model.name}: {against}", markup=False, soft_wrap=True)
    return [m for m in selected if distributed.reason_against(m) is None]


def _run_distributed(
    harness: Harness, models: list[Model], cluster: distributed.Cluster, tell: Callable[[Event], None]
) -> list[Result]:
    """Run one model after the other: each takes all workers."""
    return [_distribute(harness, model, cluster, tell) for model in models]


def _distribute(harness: Harness, model: Model, cluster: distributed.Cluster, tell: Callable[[Event], None]) -> Result:
    tell(Event(model))
    result = distributed.check(harness, model, cluster, lambda text: tell(Event(model, text)))
    tell(Event(model, result=result))
    return result


def _update(manifest: Manifest, results: list[Result], request: Request, console: Console) -> list[Result]:
    """Pin the counts that came, and judge by the new pins."""
    changes = update(manifest.path, results)
    for change in changes or ["nothing"]:
        console.print(f"updated {change}", markup=False, soft_wrap=True)
    if not changes:
        return results
    pinned = {m.name: m for m in load(request.manifest).models}
    return [
        judge(pinned[r.model.name], r.outcome, r.exit, r.seconds, r.workers, r.output)
        if r.exit is not None and not r.problems
        else r
        for r in results
    ]


def _show(results: list[Result], drift: list[str], request: Request, console: Console) -> None:
    for result in results:
        if request.verbose and result.output:
            console.print(result.output, markup=False, soft_wrap=True)
        if not result.ok:
            report.show_failure(console, result, _alone(result.model, request), verbose=request.verbose)
    for line in drift:
        console.print(f"drift: {line}", markup=False, style="red", soft_wrap=True)


def _alone(model: Model, request: Request) -> str:
    options = "" if request.manifest == ROOT / MANIFEST else f" --manifest {request.manifest}"
    options += f" --tlc {request.jar}" if request.jar else ""
    return f"s7spec models{options} {model.name} -v"
