"""``s7spec mutants``: change the specification in many small ways and see whether its checks notice."""

from __future__ import annotations

import fnmatch
import hashlib
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import click
from rich.console import Console

from evidence.common.cases import Case, all_cases
from evidence.common.console import plain
from evidence.common.options import json_option, manifest_option, tlc_option, write_json
from evidence.common.processes import Processes
from evidence.common.reasons import ReasonsError, read
from evidence.common.session import session
from evidence.models.entries import LANES, ManifestError
from evidence.models.manifest import Manifest, load
from evidence.models.runner import Harness
from evidence.mutants import against_kit as kit
from evidence.mutants import against_logs as logs
from evidence.mutants import mutants_report as report
from evidence.mutants import survivors as reasons
from evidence.mutants.bench import Bench, UnsoundBaselineError, Verdict
from evidence.mutants.checks import Check, CheckFailedError, LogsCheck, ModelCheck
from evidence.mutants.findings import Findings
from evidence.mutants.listing import Mutant, mutants
from evidence.tla import tlc
from evidence.tla.modules import WORDING, read_modules
from evidence.tla.syntax import Module, SyntaxTreeError
from s7check.engine.command import EngineError
from s7check.kit.adapter import AdapterError

UNEXPLAINED = 1

NOT_MUTATED = ("Properties*", *WORDING)
"""Modules without rules: properties, and the words of a rejection, which decide no verdict."""


@dataclass(frozen=True)
class Request:
    """The command's arguments."""

    against: str
    lane: str
    manifest: Path
    jar: Path | None
    sample: int | None
    seed: int
    jobs: int
    thorough: bool
    fresh: bool
    explained: bool
    listing: bool
    difference: bool
    json_path: Path | None
    names: tuple[str, ...]


@click.command(name="mutants", short_help="Mutate the specification: do its checks notice?")
@click.option(
    "--against",
    type=click.Choice(["models", "properties", "logs", "kit", "all"]),
    default="models",
    show_default=True,
    help="What has to notice; properties: those of the models alone, no counts, timeouts or errors; kit: the logs of "
    "the soft PLC running the kit.",
)
@click.option(
    "--lane", type=click.Choice(LANES), default="smoke", show_default=True, help="Which models, with --against models."
)
@manifest_option
@tlc_option
@click.option("--sample", type=click.IntRange(1), help="Only so many mutants, drawn by --seed.")
@click.option("--seed", type=int, default=1, show_default=True, help="The seed of the sample.")
@click.option("--jobs", type=click.IntRange(1), default=2, show_default=True, help="Mutants at a time, a core each.")
@click.option("--thorough", is_flag=True, help="After a kill by counts or time, look for a kill by a property.")
@click.option("--fresh", is_flag=True, help="Use nothing that an earlier run found.")
@click.option("--explained", is_flag=True, help="Past the logs, try no mutant whose survival has a reason already.")
@click.option("--list", "listing", is_flag=True, help="Show the mutants, run nothing.")
@click.option("--diff", "difference", is_flag=True, help="Show the mutants as differences, run nothing.")
@json_option
@click.argument("names", nargs=-1, metavar="[ID]...")
def mutants_command(**arguments: Any) -> None:
    """Make mutants of the specification and run the checks on each until one notices.

    ID picks mutants (globs work). What a check came to is kept in build/mutants, so that a run goes on where the last
    one was ended. Each survivor needs a reason in survivors.json beside the manifest, and no reason may be stale; not
    with --against properties. With --against kit 95 % of those that an accepted log shows have to be noticed.
    """
    processes = Processes()
    usage = (ManifestError, SyntaxTreeError, ReasonsError)
    missing = (tlc.ToolMissingError, EngineError, AdapterError, CheckFailedError, UnsoundBaselineError)
    with session(processes, usage, missing, "interrupted; the same command goes on from here") as console:
        sys.exit(run_request(Request(**arguments), processes, console))


def run_request(request: Request, processes: Processes, console: Console) -> int:
    """Do the work and return the exit code."""
    manifest = load(request.manifest)
    modules = read_modules(manifest.spec)
    stages = _stages(request, manifest, modules, processes)
    existing = mutants(modules, _mutated(modules))
    checks = [check for stage in stages for check in stage]
    everything = _concerning(existing, checks)
    chosen = _choose(everything, request)
    if request.listing:
        report.show_list(console, chosen)
        return 0
    if request.difference:
        for mutant in chosen:
            report.show_difference(console, mutant, modules[mutant.module])
        return 0
    findings = Findings(manifest.directory.parent / "build" / "mutants" / "findings.ndjson", fresh=request.fresh)
    if request.against == "kit":
        return _before_the_kit(request, checks, chosen, lambda: Bench(manifest.spec, modules, findings), console)
    why = read(manifest.directory / "survivors.json", reasons.Reason)
    began = time.monotonic()
    stated = request.against == "properties"
    bench = Bench(manifest.spec, modules, findings, request.thorough, stated)
    verdicts: dict[str, Verdict] = {}
    left = chosen
    for stage in stages:
        # All mutants, so that later runs find the same marks; those of a sample change anyway.
        marked = everything if request.sample is None else left
        bench.calibrate(stage, marked, lambda line: plain(console, line))
        for verdict in bench.judge_all(left, request.jobs, report.Progress(console, len(left))):
            verdicts[verdict.mutant.id] = verdict
        left = [mutant for mutant in left if not bench.decided(verdicts[mutant.id])]
        if request.explained:
            left = [mutant for mutant in left if not any(reason.fits(mutant.id) for reason in why)]
        if not left:
            break
    explained = reasons.explain([verdicts[m.id] for m in chosen], why, (m.id for m in existing), stated=stated)
    report.show(console, explained)
    asked = {"against": request.against, "lane": request.lane, "sample": request.sample, "seed": request.seed}
    write_json(request.json_path, asked | report.as_json(explained, time.monotonic() - began))
    return 0 if explained.ok else UNEXPLAINED


def _before_the_kit(
    request: Request, checks: list[Check], chosen: list[Mutant], bench: Callable[[], Bench], console: Console
) -> int:
    """Score the kit's logs, each check on a bench of its own, and return the exit code."""
    began = time.monotonic()

    def judge(check: Check, left: list[Mutant]) -> list[Verdict]:
        trial = bench()
        trial.calibrate([check], left, lambda line: plain(console, line))
        return trial.judge_all(left, request.jobs, report.Progress(console, len(left)))

    found = kit.before_the_kit(checks, chosen, judge)
    report.show_kit(console, found)
    ok = found["share"] is not None and found["share"] >= kit.LEAST
    write_json(request.json_path, {"kit": "mutants", "ok": ok, "seconds": time.monotonic() - began, **found})
    return 0 if ok else UNEXPLAINED


def _stages(request: Request, manifest: Manifest, spec: dict[str, Module], processes: Processes) -> list[list[Check]]:
    """The checks: first the logs, which take seconds, then the models, for mutants that the logs do not notice."""
    stages: list[list[Check]] = []
    project = manifest.directory.parent
    traces, build = project / "traces", project / "build" / "mutants"
    if request.against == "kit":
        first, rest = kit.kit_logs()
        parts = {kit.KIT: first, kit.SHIPPED: kit.accepted_logs(all_cases(traces)), kit.REST: rest}
        return [[_logs_check(cases, build, spec, processes, name)] for name, cases in parts.items()]
    if request.against in {"logs", "all"}:
        stages.append([_logs_check(all_cases(traces), build, spec, processes)])
    if request.against != "logs":
        harness = Harness(manifest, tlc.find_toolchain(request.jar), processes, workers=1)
        models = read_modules(manifest.directory)
        passing = [m for m in manifest.select(request.lane, ()) if m.expect.exit == 0]
        # A run lives for seconds: the second compiler would cost more than it saves.
        stages.append([ModelCheck(harness, replace(model, brief=True), spec, models) for model in passing])
    return stages


def _logs_check(
    cases: Sequence[Case], build: Path, spec: dict[str, Module], processes: Processes, name: str = "logs"
) -> LogsCheck:
    file = logs.keep(cases, build / f"{name}.json")
    return LogsCheck(file, logs.fingerprint(file), spec, processes, name)


def _mutated(modules: dict[str, Module]) -> list[str]:
    return [name for name in modules if not any(fnmatch.fnmatchcase(name, p) for p in NOT_MUTATED)]


def _concerning(existing: list[Mutant], checks: list[Check]) -> list[Mutant]:
    """The mutants of modules that the checks use, without definitions that all checks replace by their own."""
    return [
        mutant
        for mutant in existing
        if any(mutant.module in check.modules and mutant.definition not in check.parameters for check in checks)
    ]


def _choose(everything: list[Mutant], request: Request) -> list[Mutant]:
    """The mutants of the names, and of them a sample, which other mutants that come and go leave as it is."""
    named = everything
    if request.names:
        named = [m for m in everything if any(fnmatch.fnmatchcase(m.id, name) for name in request.names)]
    if request.sample is None:
        return named
    drawn = sorted(named, key=lambda m: hashlib.sha256(f"{request.seed} {m.id}".encode()).digest())
    sample = {m.id for m in drawn[: request.sample]}
    return [m for m in named if m.id in sample]
