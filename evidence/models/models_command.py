"""``s7spec models``: run TLC on the listed models and fail on any drift."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from pathlib import Path

import click
from rich.console import Console

from evidence.common.checkout import MANIFEST, ROOT
from evidence.common.console import plain
from evidence.common.options import json_option, manifest_option, shard_option, tlc_option, write_json
from evidence.common.processes import Processes
from evidence.common.session import session
from evidence.models import canaries, distributed, judge, unchanged
from evidence.models import models_report as report
from evidence.models.entries import LANES, ManifestError
from evidence.models.manifest import Model, load
from evidence.models.manifest import shard as part_of
from evidence.models.runner import Event, Harness, run_all
from evidence.tla import tlc

DRIFT = 1


@click.command(name="models", short_help="Model-check the specification.")
@click.option(
    "--lane", type=click.Choice(LANES), default="smoke", show_default=True, help="Which models: smoke, also ci, or all."
)
@manifest_option
@tlc_option
@click.option("--workers", type=click.IntRange(1), help="TLC workers for models that may have several.")
@click.option("--jobs", type=click.IntRange(1), default=2, show_default=True, help="Cores to use.")
@click.option(
    "--changed", is_flag=True, help="Only models that changed, or whose formulas did, since they came as pinned."
)
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
@shard_option
@click.argument("names", nargs=-1, metavar="[NAME]...")
def models_command(
    lane: str,
    manifest: Path,
    jar: Path | None,
    workers: int | None,
    jobs: int,
    changed: bool,
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
    cluster = _cluster(spread, host, update=update)
    processes = Processes()
    with session(processes, (ManifestError,), (tlc.ToolMissingError,)) as console:
        harness = Harness(load(manifest), _toolchain(jar, cluster), processes, workers)
        asked = part_of(harness.manifest.select(lane, names), *shard)
        before = unchanged.kept(asked, harness.manifest, harness.tools) if changed else {}
        models = [model for model in asked if model.name not in before]
        if changed:
            plain(console, f"{len(before)} of {len(asked)} models are as they were when they came as pinned")
        part = lane if shard[1] == 1 else f"{lane}, shard {shard[0]}/{shard[1]}"
        began, text = time.monotonic(), unchanged.written(harness.manifest)
        answers = canaries.run_canaries(harness.tools, harness.manifest.directory.parent / "build", processes)
        report.show_canaries(console, harness.tools, answers)

        def take(result: judge.Result) -> judge.Result:
            """Pin and remember what came, at once: the full lane takes hours, and may be stopped."""
            if update:
                changes, result = judge.update(manifest, result)
                for change in changes:
                    plain(console, f"updated {change}")
            if result.ok and unchanged.written(harness.manifest) == text:  # no module has changed while TLC ran
                unchanged.keep(result.model, report.came(result), harness.manifest, harness.tools)
            return result

        results, drift = _run(harness, models, cluster, jobs, names, console, take)
        if not asked:
            drift.insert(0, f"{manifest}: no model is in {part}: nothing was checked")
        if logs is not None:
            report.write_logs(logs, results)
        came = (results, [*harness.manifest.drift, *drift], time.monotonic() - began)
        earlier = [report.described(model) | before[model.name] for model in asked if model.name in before]
        done = report.Report(harness.tools, answers, None if names else part, *came, earlier)
        report.show(console, done, _command(manifest, jar), verbose=verbose)
        write_json(json_path, report.as_json(done))
        sys.exit(0 if done.ok else DRIFT)


def _cluster(spread: int | None, host: str | None, *, update: bool) -> distributed.Cluster | None:
    if spread is None and host is not None:
        raise click.UsageError("--host goes with --distributed")
    if spread == 0 and host is None:
        raise click.UsageError("--distributed 0 needs workers elsewhere: say --host")
    if spread is not None and update:
        raise click.UsageError("--distributed pins nothing: its counts but the distinct states differ")
    return None if spread is None else distributed.Cluster(spread, host)


def _toolchain(jar: Path | None, cluster: distributed.Cluster | None) -> tlc.Toolchain:
    tools = tlc.find_toolchain(jar)
    if cluster is not None and not distributed.works(tools):
        raise tlc.ToolMissingError(
            f"the distributed mode of {tools.jar} does not work: see docs/project/distributed.md"
        )
    return tools


def _run(
    harness: Harness,
    models: list[Model],
    cluster: distributed.Cluster | None,
    jobs: int,
    names: tuple[str, ...],
    console: Console,
    take: Callable[[judge.Result], judge.Result],
) -> tuple[list[judge.Result], list[str]]:
    """Return the results, and a line for each thing that was asked for and not run."""
    if cluster is None:
        taken = {}
        with report.Progress(console, len(models)) as progress:

            def tell(event: Event) -> None:
                progress(event)
                if event.result is not None:
                    taken[event.model.name] = take(event.result)

            run_all(harness, models, jobs, tell)
        return [taken[model.name] for model in models], []
    against = {model.name: reason for model in models if (reason := distributed.reason_against(model))}
    for name, reason in against.items():
        plain(console, f"not run: {name}: {reason}")
    drift = [f"{name} was named and not run" for name in against if name in names]
    possible = [model for model in models if model.name not in against]
    if not possible:
        drift.append("no model that was asked for can be run in distributed mode: nothing was checked")
    with report.Progress(console, len(possible)) as progress:
        return distributed.run_all(harness, possible, cluster, progress), drift


def _command(manifest: Path, jar: Path | None) -> str:
    """Return the command that runs a model of this manifest, without the model's name."""
    options = "" if manifest == ROOT / MANIFEST else f" --manifest {manifest}"
    return f"s7spec models{options}" + (f" --tlc {jar}" if jar else "")
