"""The runs of which the documentation has numbers: their commands, and the summary that is kept of their reports."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from msgspec.structs import replace

from evidence.common.checkout import ROOT
from evidence.tla.tlc import find_toolchain
from evidence.views.results import records, summaries, texts
from evidence.views.results.records import Record, Table
from s7check import __version__

SECOND = "-second-tlc"
"""End of the name of a run on another TLC than the project's own."""

_REPORT = "REPORT"


class RunError(Exception):
    """A run that gave no report; the text says how it ended."""


@dataclass(frozen=True)
class Run:
    """A run: its heading on the page, its command as it is typed, and the arguments of the process.

    A command of s7spec needs no `arguments`. ``REPORT`` among them stands for the file that the command writes; without
    it the output is the report. With one of `codes` as its exit code the command gives a report. `tlc`: it runs TLC,
    and takes another by ``--tlc``. `told`: fields by which a report tells that it is one of this run; without them no
    report is taken over. `totals` are the columns of its first table that the short page adds up, `parts` those of the
    checkout (``texts``) that its numbers depend on. `first` is a process that makes what the command reads.
    """

    title: str
    about: str
    typed: str
    summary: Callable[[str], list[Table]]
    arguments: tuple[str, ...] = ()
    codes: tuple[int, ...] = (0, 1)
    tlc: bool = False
    told: Mapping[str, Any] = field(default_factory=dict)
    totals: tuple[str, ...] = ()
    parts: tuple[str, ...] = ()
    first: tuple[str, ...] = ()

    @property
    def process(self) -> tuple[str, ...]:
        """The arguments of the process."""
        _, *words = self.typed.split()
        return self.arguments or (sys.executable, "-m", "evidence", *words, "--json", _REPORT)


RUNS = {
    "models": Run(
        "Models",
        "The models of the CI lane and their negative controls, with the pinned results ([checks](checks.md)).",
        "s7spec models --lane ci",
        summaries.models,
        tlc=True,
        told={"lane": "ci"},
        totals=("models", "not as pinned", "distinct states"),
        parts=("spec", "models"),
    ),
    "models-full": Run(
        "Models of the full lane",
        "The CI lane, the large models and all controls. A result of an earlier run counts while its texts stand.",
        "s7spec models --lane full --changed",
        summaries.models,
        tlc=True,
        told={"lane": "full"},
        totals=("models", "not as pinned", "distinct states"),
        parts=("spec", "models"),
    ),
    "logs": Run(
        "Logs",
        "The logs of `traces/`, written out by `s7spec views cases`. A test compares verdict and line.",
        "s7check trace --readings none --format json build/traces",
        summaries.logs,
        (sys.executable, "-m", "s7check", "trace", "--readings", "none", "--format", "json", "build/traces"),
        codes=(0, 1, 2),
        totals=("logs", "accepted", "rejected", "unusable"),
        parts=("judging", "cases", "engine", "checker"),
        first=(sys.executable, "-m", "evidence", "views", "cases"),
    ),
    "agreement": Run(
        "Agreement",
        "Random logs, judged by the engine and by TLC ([agreement](agreement.md)).",
        "s7spec logs agree --logs 10000",
        summaries.agreement,
        tlc=True,
        totals=("logs", "lines", "differ"),
        parts=("judging", "engine"),
    ),
    "left-out": Run(
        "Kinds left out",
        "Random accepted logs, each with every subset of the kinds of event left out: each has to be accepted.",
        "s7spec logs left-out --logs 100",
        summaries.left_out,
        told={"logs": 100, "subsets": 63, "events": None, "seed": 1},
        totals=("accepted logs", "with kinds left out", "not accepted"),
        parts=("judging", "engine"),
    ),
    "left-out-sample": Run(
        "Kinds left out, more logs",
        "Other logs, each with some of these subsets, drawn by the seed.",
        "s7spec logs left-out --logs 10000 --subsets 6 --seed 2",
        summaries.left_out,
        told={"logs": 10000, "subsets": 6, "events": None, "seed": 2},
        totals=("accepted logs", "with kinds left out", "not accepted"),
        parts=("judging", "engine"),
    ),
    "growth": Run(
        "Logs that leave much open",
        "Many start events at once, few kinds recorded, years between two lines: what each costs "
        "([growth](commands.md#s7spec-logs-growth-name)).",
        "s7spec logs growth",
        summaries.growth,
        totals=("lines", "steps"),
        parts=("judging", "engine"),
    ),
    "mutation": Run(
        "Mutation",
        "Mutants of the specification before the logs and the models of the smoke lane ([mutation](mutation.md)).",
        "s7spec mutants --against all --lane smoke --sample 600 --seed 1",
        summaries.mutants,
        tlc=True,
        told={"against": "all", "lane": "smoke", "sample": 600, "seed": 1},
        totals=("mutants", "equivalent", "killed", "survived"),
        parts=("spec", "models", "cases"),
    ),
    "mutation-properties": Run(
        "Mutation, properties alone",
        "Mutants before the properties of the models of the smoke lane: no counts, timeouts, errors or logs. Those "
        "that no model of the lane evaluates do not count ([mutation](mutation.md)).",
        "s7spec mutants --against properties --lane smoke --sample 100 --seed 1",
        summaries.mutants,
        tlc=True,
        told={"against": "properties", "lane": "smoke", "sample": 100, "seed": 1},
        totals=("mutants", "equivalent", "killed", "survived"),
        parts=("spec", "models"),
    ),
    "witnesses": Run(
        "Witnesses",
        "Conditions of the specification, and the models or logs that meet them ([witnesses](witnesses.md)).",
        "s7spec witnesses",
        summaries.witnesses,
        tlc=True,
        totals=("conditions", "by models", "by logs alone", "with reason", "without"),
        parts=("spec", "models", "cases"),
    ),
    "kit": Run(
        "Kit",
        "The kit on the soft PLC in all its ways: outcomes of guards of spec/, and requirements "
        "([kit](../checking/kit.md#what-the-programs-reach)).",
        "s7spec kit reached",
        summaries.kit,
        told={"kit": "reached"},
        totals=("programs", "logs", "guard outcomes reached", "that can be observed"),
        parts=("judging", "kit", "soft PLC"),
    ),
    "kit-faults": Run(
        "Kit, faults",
        "Deliberate faults of the soft PLC that the kit alone finds ([faults](commands.md#s7spec-kit-faults-fault)).",
        "s7spec kit faults",
        summaries.kit_faults,
        totals=("number", "found"),
        parts=("kit", "soft PLC", "judging"),
    ),
    "kit-mutants": Run(
        "Kit, mutants",
        "Mutants of the specification before the logs of the soft PLC running the kit; of those that an accepted log "
        "shows, the part that the kit shows ([mutation](mutation.md#the-checks)).",
        "s7spec mutants --against kit --sample 60 --seed 1",
        summaries.kit_mutants,
        told={"kit": "mutants"},
        totals=("mutants", "shown by one", "by the kit"),
        parts=("spec", "kit"),
    ),
    "fuzz": Run(
        "Damaged logs and sources",
        "Each gets its verdict or its refusal in one sentence; anything else is a fault ([checks](checks.md#by-hand)).",
        "make fuzz",
        summaries.fuzz,
        (sys.executable, "-m", "tests.fuzz", "--json", _REPORT),
        totals=("accepted", "rejected", "unusable", "written", "refused", "faults"),
        parts=("judging", "engine", "checker"),
    ),
    "bench": Run(
        "Speed",
        "The trace checker and TLC on the same logs ([benchmark](../../bench/README.md)).",
        "bench/run.py",
        summaries.bench,
        (sys.executable, "bench/run.py", "--json", _REPORT),
        totals=("events", "seconds"),
        parts=("judging", "engine", "checker"),
    ),
    "compare": Run(
        "Beside an earlier revision",
        "CPU seconds of this checkout and of the revision before the work on the cost of logs began, on the same logs; "
        "none where there was no verdict in time ([benchmark](../../bench/README.md#beside-another-revision)).",
        "bench/compare.py",
        summaries.bench,
        (sys.executable, "bench/compare.py", "--json", _REPORT),
        parts=("judging", "engine", "checker"),
    ),
    "edges": Run(
        "The explorer's steps and TLC's edges",
        "What may come after each log of three exported graphs ([commands](commands.md#s7spec-logs-edges-world)).",
        "s7spec logs edges",
        summaries.edges,
        tlc=True,
        totals=("edges", "compared", "not offered"),
        parts=("spec", "engine"),
    ),
    "engines": Run(
        "The executable and Java",
        "The whole answers of both engines to the same logs ([commands](commands.md#s7spec-logs-engines)).",
        "s7spec logs engines",
        summaries.engines,
        totals=("logs", "different"),
        parts=("judging", "cases", "engine"),
    ),
    "proofs": Run(
        "Proofs",
        "Properties of System and of the abstract specifications, proved by Apalache ([proofs](proofs.md)).",
        "s7spec prove --kept",
        summaries.proofs,
        totals=("queries", "not as claimed", "not asked", "conditions"),
        parts=("spec", "models", "proofs"),
    ),
}


def old(kept: Mapping[str, Record]) -> list[str]:
    """The names of kept runs whose numbers depend on texts that have changed since. Raises OSError."""
    return [name for name, one in kept.items() if one.texts != texts.origin(RUNS[name.removesuffix(SECOND)].parts)]


def take(name: str, jar: Path | None, tell: Callable[[str], None]) -> Record:
    """Run the command of this name and summarise its report.

    Raises `RunError`, `evidence.tla.tlc.ToolMissingError`, `s7check.java.JavaMissingError`, OSError.
    """
    run = RUNS[name]
    options = [] if jar is None else ["--tlc", str(jar)]
    begun = replace(_circumstances(run, jar), load=round(os.getloadavg()[0], 1))
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="s7check-results-") as folder:
        report = Path(folder) / "report.json"
        arguments = [str(report) if argument == _REPORT else argument for argument in run.process]
        tell(f"running {run.typed}")
        if run.first:
            subprocess.run(run.first, cwd=ROOT, stdout=subprocess.DEVNULL, check=True)
        ended = subprocess.run([*arguments, *options], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=False)
        text = report.read_text(encoding="utf-8") if report.exists() else ended.stdout
    if ended.returncode not in run.codes or not text:
        raise RunError(f"{run.typed} ended with exit code {ended.returncode}: {_end(ended.stdout.splitlines())}")
    seconds = round(time.monotonic() - began, 1)
    return replace(begun, seconds=seconds, exit=ended.returncode, tables=run.summary(text))


def take_over(name: str, jar: Path | None, report: Path) -> Record:
    """Summarise a report that the command of this name wrote before, such as build/verify/models.json.

    Raises `RunError` if it is of another run or the checkout has changed since,
    `evidence.tla.tlc.ToolMissingError`, `s7check.java.JavaMissingError`, OSError.
    """
    run = RUNS[name]
    text = report.read_text(encoding="utf-8")
    try:
        document: dict[str, Any] = json.loads(text)
    except ValueError as error:
        raise RunError(f"{report}: no report: {error}") from error
    if any(document.get(key) != value for key, value in run.told.items()):
        raise RunError(f"{report}: expected a report of {run.typed}")
    written = report.stat().st_mtime
    if records.changed_at() > written:
        raise RunError(f"{report}: the checkout has changed since; run {run.typed} again")
    found = replace(_circumstances(run, jar), date=records.day(written), seconds=document.get("seconds"))
    return replace(found, tables=run.summary(text))


def _circumstances(run: Run, jar: Path | None) -> Record:
    """The record of a run that begins now, without what it gives."""
    toolchain = [f"TLC of {find_toolchain(jar).jar.name}"] if run.tlc else []
    return Record(
        command=" ".join([run.typed, *(["--tlc", jar.name] if jar else [])]),
        date=records.day(time.time()),
        revision=records.revision(),
        release=__version__,
        texts=texts.origin(run.parts),
        tools=[*records.tools(), *toolchain],
        machine=records.machine(),
        load=None,
        seconds=None,
        exit=None,
        tables=[],
    )


def _end(lines: Iterable[str]) -> str:
    return " / ".join([line for line in lines if line.strip()][-3:])
