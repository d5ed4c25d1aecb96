"""``s7spec verify``: the project's main job, and a table of checks done and not done."""

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import click
from rich.table import Table

from evidence.common.cases import all_cases, difference
from evidence.common.checkout import ROOT, SOFT_PLC, SOFT_PLC_PROGRAM
from evidence.common.console import console
from s7check.engine.client import Engine
from s7check.judging.check import check_log
from s7check.judging.workers import Workers
from s7check.report.report import Report

BUILD = ROOT / "build" / "verify"


@dataclass(frozen=True)
class Row:
    """A line of the table: ``failures`` name each failure and the remedy; ``run`` is False if nothing was run."""

    what: str
    tool: str
    size: str
    seconds: float
    failures: list[str]
    run: bool = True

    @property
    def result(self) -> str:
        """The word in the table."""
        if not self.run:
            return "not run"
        return "FAILED" if self.failures else "ok"


@click.command("verify", short_help="Do the main job of the project: models, soft PLC, shipped logs.")
@click.option("--without-models", is_flag=True, help="Leave out the models of the CI lane: they run elsewhere.")
def verify_command(*, without_models: bool) -> int:
    """Model-check the CI lane, run the soft PLC and check its logs, check the shipped logs, random ones and mutants."""
    BUILD.mkdir(parents=True, exist_ok=True)
    click.echo("== models of the CI lane")
    # The models take all cores, and say how far they are.
    left_out = Row("models of the CI lane", "TLC", "make models", 0, [], run=False)
    rows = [left_out] if without_models else _models()
    # Most of the others take one core at a time.
    click.echo("".join(f"== {title}\n" for title in STEPS), nl=False)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for found in pool.map(lambda step: step(), STEPS.values()):
            rows += found
    _print(rows)
    return 1 if any(row.failures for row in rows) else 0


def _models() -> list[Row]:
    code, seconds, report = _s7spec("models", "--lane", "ci", at_once=True)
    if report is None:
        return [Row("models", "TLC", "", seconds, [f"the models were not run (exit code {code}); see above"])]
    rows = []
    for kind in dict.fromkeys(model["kind"] for model in report["models"]):
        models = [model for model in report["models"] if model["kind"] == kind]
        failures = [f"model {m['name']}: {'; '.join(m['problems'])}" for m in models if m["problems"]]
        states = sum(m["distinct"] or 0 for m in models)
        size = f"{len(models)} models, {states:,} distinct states"
        rows.append(Row(f"models: {kind}", _tlc(report), size, sum(m["seconds"] for m in models), failures))
    if code and not any(row.failures for row in rows):
        rows.append(Row("models", _tlc(report), "", seconds, [f"s7spec models ended with exit code {code}; see above"]))
    return rows


def _s7spec(name: str, *arguments: str, at_once: bool = False) -> tuple[int, float, dict[str, Any] | None]:
    """Run a command of s7spec: its exit code, its seconds, and the report that it wrote to BUILD, if it did.

    What it prints comes when it is over, since others run beside it, or `at_once`.
    """
    results = BUILD / f"{name.replace(' ', '-')}.json"
    results.unlink(missing_ok=True)
    begun = time.monotonic()
    command = [sys.executable, "-m", "evidence", *name.split(), *arguments, "--json", str(results)]
    streams: dict[str, Any] = {} if at_once else {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
    run = subprocess.run(command, cwd=ROOT, check=False, text=True, **streams)
    if not at_once:
        click.echo(f"-- s7spec {name}\n{run.stdout}", nl=False)
    code = run.returncode
    return code, time.monotonic() - begun, json.loads(results.read_bytes()) if results.exists() else None


def _tlc(report: dict[str, dict[str, str]]) -> str:
    return f"TLC {report['tlc']['version']}"


def _soft_plc() -> list[Row]:
    scenarios = sorted((SOFT_PLC / "scenarios").glob("*.json"))
    rows = []
    for name, chosen, options in (
        ("soft PLC, simulated clock", [s for s in scenarios if s.stem != "real_time"], []),
        ("soft PLC, real clock", [s for s in scenarios if s.stem == "real_time"], ["--real-time"]),
    ):
        begun = time.monotonic()
        failures, logs = [], []
        for scenario in chosen:
            log = BUILD / f"{scenario.stem}.ndjson"
            log.unlink(missing_ok=True)
            run = subprocess.run(
                [str(SOFT_PLC_PROGRAM), *options, "-o", str(log), str(scenario)],
                capture_output=True, text=True, check=False,
            )  # fmt: skip
            if run.returncode:
                failures.append(f"soft_plc {scenario.name}: {run.stderr.strip()}")
            else:
                logs.append(log)
        if not chosen:
            failures.append(f"{(SOFT_PLC / 'scenarios').relative_to(ROOT)} has no scenario for it")
        events, rejected = _check_all(logs)
        size = f"{len(chosen)} scenarios, {events:,} events"
        rows.append(Row(name, "trace checker", size, time.monotonic() - begun, failures + rejected))
    return rows


def _judged(logs: Iterable[Path]) -> Iterator[Report]:
    """The verdicts on logs, in their order, found on all cores."""
    with Workers(Engine) as workers:
        for judged in workers.in_order(logs, lambda log, engine: check_log(str(log), engine, lambda _, __: None)):
            yield judged.result()


def _check_all(logs: list[Path]) -> tuple[int, list[str]]:
    events, failures = 0, []
    for log, report in zip(logs, _judged(logs), strict=True):
        events += report.events
        if report.verdict != "accepted":
            shown = log.relative_to(ROOT)
            failures.append(f"{shown}:{report.line or ''}: {report.verdict} (see s7check trace {shown})")
    return events, failures


def _shipped_logs() -> list[Row]:
    begun = time.monotonic()
    events, failures = 0, []
    cases = all_cases()
    with TemporaryDirectory(prefix="s7check-") as folder:
        logs = [case.put(Path(folder)) for case in cases]
        for case, report in zip(cases, _judged(logs), strict=True):
            events += report.events
            if failure := difference(case, report):
                failures.append(failure)
    size = f"{len(cases)} logs, {events:,} events"
    return [Row("cases of traces/", "trace checker", size, time.monotonic() - begun, failures)]


def _by_report(
    what: str,
    name: str,
    arguments: Iterable[str],
    size: Callable[[dict[str, Any]], str],
    tool: Callable[[dict[str, Any]], str],
) -> list[Row]:
    """Run a command of s7spec, `arguments` without ``--json``; its report, where it wrote one, has the row's words."""
    code, seconds, found = _s7spec(name, *arguments)
    failures = [f"s7spec {name} ended with exit code {code}; see above"] if code or found is None else []
    return [Row(what, tool(found) if found else "", size(found) if found else "", seconds, failures)]


def _agreement() -> list[Row]:
    return _by_report(
        "random logs, judged alike by the engine and TLC",
        "logs agree",
        ("--logs", str(SAMPLE)),
        lambda found: f"{found['logs']} logs, {found['accepted']} accepted, {found['lines']:,} lines",
        lambda found: f"TLC {found['tlc']}",
    )


def _left_out() -> list[Row]:
    return _by_report(
        "accepted logs, still accepted",
        "logs left-out",
        ("--logs", str(LEFT_OUT), "--keep", str(BUILD / "left_out")),
        lambda found: f"{found['logs']} logs, {found['left_out']:,} with kinds of event left out",
        lambda _: "trace checker",
    )


def _mutants() -> list[Row]:
    options = "--against all --lane smoke --fresh --explained"
    return _by_report(
        "mutants of the specification, noticed",
        "mutants",
        [*options.split(), "--sample", str(MUTANTS), "--seed", str(SEED)],
        lambda found: f"{found['all']['mutants']} mutants, {found['all']['killed']} killed",
        lambda _: "logs, then TLC",
    )


def _requirements() -> list[Row]:
    begun = time.monotonic()
    command = [sys.executable, "-m", "evidence", "views", "requirements"]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    failures = [f"s7spec views requirements: {run.stdout[-2000:]}{run.stderr}"] if run.returncode else []
    size = run.stdout.partition("  ")[0]
    return [Row("every requirement traced, or a reason", "s7spec", size, time.monotonic() - begun, failures)]


def _views() -> list[Row]:
    begun = time.monotonic()
    # Tests may read those in build/views meanwhile.
    command = [sys.executable, "-m", "evidence", "views", "make", "--output", str(BUILD / "views")]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    said, *problems = run.stdout.splitlines() or [""]
    failures = [*problems, *run.stderr.splitlines()] if run.returncode else []
    title = "views, from data as new as their origin"
    return [Row(title, "s7spec", said.partition(": ")[2], time.monotonic() - begun, failures)]


def _apalache() -> list[Row]:
    begun = time.monotonic()
    run = subprocess.run(
        [str(ROOT / "models" / "apalache.sh"), "typecheck"], capture_output=True, text=True, check=False
    )
    seconds = time.monotonic() - begun
    found = run.returncode != NOT_FOUND
    failures = [f"apalache-mc typecheck: {run.stdout[-2000:]}{run.stderr}"] if found and run.returncode else []
    size = f"{run.stdout.count('typecheck ')} modules, what they extend" if found else run.stderr.strip()
    bounded = "make apalache" if found else NO_APALACHE
    return [
        Row("types of spec/", "Apalache", size, seconds, failures, run=found),
        _proofs(found=found),
        Row("bounded checks of two invariants", "Apalache", bounded, 0, [], run=False),
    ]


def _proofs(*, found: bool) -> Row:
    title = "proofs, a sample of the actions"
    if not found:
        return Row(title, "Apalache", NO_APALACHE, 0, [], run=False)
    code, seconds, report = _s7spec("prove", *PROOFS)
    failures = [f"s7spec prove: exit code {code}; see above"] if code else []
    queries = report["queries"] if report else []
    size = f"{len(queries)} queries, {sum(q['conditions'] for q in queries)} conditions; all: make prove"
    return Row(title, "Apalache", size, seconds, failures)


def _not_in_this_lane() -> list[Row]:
    return [Row("models of the full lane", "TLC", "make models-full", 0, [], run=False)]


NOT_FOUND = 3
"""Exit code of models/apalache.sh where Apalache is not there."""

NO_APALACHE = "apalache-mc was not found"

PROOFS = ("first", "invariants", "lock", "control-Call*Airt")
"""The queries of the sample: the lock's actions, and what all proofs rest on."""

SAMPLE = 100
"""Random logs that both the engine and TLC judge."""

LEFT_OUT = 8
"""Accepted logs of which every subset of the kinds of event is left out."""

MUTANTS, SEED = 4, 54
"""A sample in which the shipped logs notice every mutant, in seconds; models run only for mutants left."""

STEPS: dict[str, Callable[[], list[Row]]] = {
    "the soft PLC, run and checked": _soft_plc,
    "the shipped logs": _shipped_logs,
    "random logs, judged by the engine and by TLC": _agreement,
    "accepted logs with kinds of event left out": _left_out,
    "a few mutants of the specification": _mutants,
    "the requirements, traced": _requirements,
    "the views, made": _views,
    "types and proofs, where Apalache is there": _apalache,
    "not run here": _not_in_this_lane,
}


def _print(rows: list[Row]) -> None:
    terminal = console()
    table = Table("checked", "by", "result", "size", "seconds")
    for row in rows:
        table.add_row(row.what, row.tool, row.result, row.size, f"{row.seconds:.1f}" if row.run else "")
    terminal.print(table)
    for row in rows:
        for failure in row.failures:
            terminal.print(f"FAILED {row.what}: {failure}", markup=False, highlight=False)
