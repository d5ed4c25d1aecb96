"""The output: progress, failures, the table at the end, the results as JSON, the violations as cases."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.live import Live
from rich.table import Table
from rich.text import Text

from evidence.common.console import columns, plain
from evidence.common.shorthand import shorthand
from evidence.models.canaries import CANARIES, Answers
from evidence.models.entries import Mutation
from evidence.models.judge import Result, exit_codes, expectation
from evidence.models.manifest import Model
from evidence.models.runner import Event
from evidence.tla.behaviour import as_log, behaviour, of_system
from evidence.tla.tlc import Toolchain

HEAD_STATES = 3
TAIL_STATES = 12
STATE_LINES = 40
ERROR_LINES = 40
QUIET_SECONDS = 20
"""Least time between two progress lines of one model where there is no terminal."""


class Progress:
    """Shows running models: a live table on a terminal, lines elsewhere. A context manager; call it with each event."""

    def __init__(self, console: Console, total: int) -> None:
        """Show the progress of `total` models on `console`."""
        self._console = console
        self._total = total
        self._done = 0
        self._running: dict[str, str] = {}
        self._told: dict[str, float] = {}
        self._live = Live(console=console, refresh_per_second=4, transient=True) if console.is_terminal else None

    def __enter__(self) -> Progress:
        """Start showing."""
        if self._live:
            self._live.start()
        return self

    def __exit__(self, *_: object) -> None:
        """Stop showing."""
        if self._live:
            self._live.stop()

    def __call__(self, event: Event) -> None:
        """Show one event."""
        name = event.model.name
        line = None
        if event.result is not None:
            self._done += 1
            self._running.pop(name, None)
            line = f"[{self._done}/{self._total}] {name}: {brief(event.result)}, {event.result.seconds:.1f} s"
        else:
            self._running[name] = event.text or "started"
            now = time.monotonic()
            if not self._live and (not event.text or now - self._told[name] >= QUIET_SECONDS):
                self._told[name] = now
                line = f"        {name}: {self._running[name]}"
        if self._live:
            self._live.update(Text("\n".join(f"        {n}: {text}" for n, text in self._running.items())))
        if line:
            plain(self._console, line)


def brief(result: Result) -> str:
    """Return "as pinned: ..." or "DRIFT: ..." with what came."""
    if result.ok:
        names = result.model.expect.property if result.outcome.kind != "passed" else None
        return f"as pinned: {result.outcome.kind}{f' {names}' if names else ''}"
    return f"DRIFT: {(result.problems + result.count_problems)[0]}"


@dataclass(frozen=True)
class Report:
    """All that came of a run. `lane` is None where models were named; `drift` concerns no model.

    `before` is what came of models as pinned that were not run, since nothing changed.
    """

    tools: Toolchain
    answers: Answers
    lane: str | None
    results: list[Result]
    drift: list[str]
    seconds: float
    before: list[dict[str, Any]]

    @property
    def ok(self) -> bool:
        """Whether all is as pinned."""
        return not self.drift and all(result.ok for result in self.results)


def show_canaries(console: Console, tools: Toolchain, answers: Answers) -> None:
    """Show the version of TLC and its known defects."""
    plain(console, f"TLC {answers.version or '(version unknown)'}, {tools.jar.name} sha256 {tools.sha256[:16]}")
    for canary in CANARIES:
        plain(console, f"  known defect #{canary.issue} {answers.answers[canary.module]}: {canary.defect}")


def show(console: Console, report: Report, command: str, *, verbose: bool) -> None:
    """Show the failures, the table of the models, that of the negative controls, and the sum.

    `command` runs a model of the manifest if its name follows.
    """
    results = report.results
    for result in results:
        if verbose and result.output:
            plain(console, result.output)
        if not result.ok:
            _show_failure(console, result, f"{command} {result.model.name} -v", verbose=verbose)
    for line in report.drift:
        plain(console, f"drift: {line}", style="red")
    controls = [r for r in results if r.model.kind == "negative"]
    if len(controls) < len(results):
        console.print(_models([r for r in results if r not in controls]))
    if controls:
        console.print(_controls(controls))
    good, version = sum(r.ok for r in results), report.answers.version or "of unknown version"
    said = f"{good} of {len(results)} models as pinned, TLC {version}, {report.seconds:.0f} s"
    plain(console, f"lane {report.lane}: {said}" if report.lane else said)


def _show_failure(console: Console, result: Result, alone: str, *, verbose: bool) -> None:
    """Show a drift: expected, came, how to run it alone, TLC's errors, the trace."""
    model = result.model
    console.rule(f"{model.name}: drift", style="red", align="left")
    plain(console, f"what      {model.what}")
    plain(console, f"expected  {expectation(model)}")
    for problem in result.problems + result.count_problems:
        plain(console, f"came      {problem}")
    came = "not run" if result.exit is None else f"exit {result.exit}, {result.outcome.kind}: {result.outcome.detail}"
    plain(console, f"TLC       {came}")
    plain(console, f"alone     {alone}")
    if result.problems:
        if result.outcome.kind == "broken":
            for error in result.outcome.errors:
                plain(console, _limit(error, None if verbose else ERROR_LINES))
        _show_trace(console, result.outcome.trace, verbose=verbose)


def _show_trace(console: Console, trace: tuple[str, ...], *, verbose: bool) -> None:
    """Show the states of an error trace as TLC printed them; the middle of a long one only if `verbose`."""
    if not trace:
        return
    plain(console, f"trace     {len(trace)} states")
    skipped = 0 if verbose else max(0, len(trace) - HEAD_STATES - TAIL_STATES)
    for index, state in enumerate(trace):
        if skipped and index == HEAD_STATES:
            plain(console, f"          ... {skipped} states left out, -v shows them ...")
        if index < HEAD_STATES or index >= HEAD_STATES + skipped:
            plain(console, _limit(state, None if verbose else STATE_LINES))


def _models(results: list[Result]) -> Table:
    table = columns(("model", "kind", "lane", "result"), ("distinct", "depth", "seconds"))
    for result in results:
        counts = result.outcome.counts
        table.add_row(
            Text(result.model.name),
            Text(result.model.kind),
            Text(result.model.lane),
            _coloured(result, brief(result)),
            "-" if counts.distinct is None else str(counts.distinct),
            "-" if counts.depth is None else str(counts.depth),
            f"{result.seconds:.1f}",
        )
    return table


def _controls(results: list[Result]) -> Table:
    """The change that each negative control makes to its model, and the result that it must have."""
    table = columns(("control", "of model", "changed", "exit", "has to fail", "result"), ("seconds",))
    for result in results:
        model = result.model
        table.add_row(
            Text(model.name),
            Text(model.base),
            Text("\n".join(map(_change, model.mutations)) or model.what),
            exit_codes(model),
            Text(model.expect.property or " or ".join(sorted(model.kinds))),
            _coloured(result, f"as pinned: exit {result.exit}, {result.outcome.kind}" if result.ok else brief(result)),
            f"{result.seconds:.1f}",
        )
    return table


def _coloured(result: Result, text: str) -> Text:
    return Text(text, style="green" if result.ok else "red")


def _change(mutation: Mutation) -> str:
    """The lines that a mutation changes, without the lines around them."""
    was, by = ([" ".join(line.split()) for line in text.split("\n")] for text in (mutation.replace, mutation.by))
    while was and by and was[0] == by[0]:
        was, by = was[1:], by[1:]
    while was and by and was[-1] == by[-1]:
        was, by = was[:-1], by[:-1]
    return f"{mutation.module}: {' '.join(was) or 'nothing'} -> {' '.join(by) or 'nothing'}"


def as_json(report: Report) -> dict[str, Any]:
    """Return the report as a JSON document."""
    tools, answers = report.tools, report.answers
    return {
        "ok": report.ok,
        "lane": report.lane,
        "seconds": round(report.seconds, 1),
        "not run again": len(report.before),
        "tlc": {"version": answers.version, "jar": tools.jar.name, "sha256": tools.sha256},
        "canaries": {
            c.module: {"issue": c.issue, "state": answers.answers[c.module], "defect": c.defect} for c in CANARIES
        },
        "drift": report.drift,
        "models": [*report.before, *(described(r.model) | came(r) for r in report.results)],
    }


def described(model: Model) -> dict[str, Any]:
    """Return what the manifest says of a model."""
    return {
        "name": model.name,
        "kind": model.kind,
        "lane": model.lane,
        "base": model.base or None,
        "what": model.what,
        "requirements": list(model.requirements),
    }


def came(result: Result) -> dict[str, Any]:
    """Return what TLC found."""
    outcome = result.outcome
    return {
        "ok": result.ok,
        "result": outcome.kind,
        "violated": list(outcome.names),
        "exit": result.exit,
        "states": outcome.counts.states,
        "distinct": outcome.counts.distinct,
        "depth": outcome.counts.depth,
        "workers": result.workers,
        "seconds": round(result.seconds, 1),
        "problems": [*result.problems, *result.count_problems],
    }


def _limit(text: str, lines: int | None) -> str:
    split = text.split("\n")
    if lines is None or len(split) <= lines:
        return text
    return "\n".join([*split[:lines], f"... {len(split) - lines} lines left out, -v shows them ..."])


def write_logs(file: Path, results: list[Result]) -> None:
    """Write the behaviour of each violation as a case; not of a lasso, and not of a model without System. OSError."""
    text = []
    for result in sorted(results, key=lambda result: result.model.name):
        if result.outcome.kind not in ("invariant", "action"):
            continue
        states = behaviour(result.outcome.trace)
        if all(map(of_system, states)):
            text += [f"== {result.model.name} A", *shorthand(as_log(states))]
    file.write_text("".join(f"{line}\n" for line in text), encoding="utf-8")
