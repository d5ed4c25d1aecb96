"""Which models run when, and all runs that a model needs for its result."""

from __future__ import annotations

import queue
import tempfile
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from evidence.common.processes import InterruptedRunError, Processes
from evidence.models.copies import StaleMutationError, prepare
from evidence.models.judge import Result, judge
from evidence.models.manifest import PROPERTY_KINDS, Manifest, Model
from evidence.tla import cfg, tlc
from evidence.tla.messages import Message, Outcome, progress
from evidence.tla.resident import Residents


@dataclass(frozen=True)
class Event:
    """Something to tell the user: a model started, went on (`text` says how far), or came to its result."""

    model: Model
    text: str = ""
    result: Result | None = None


TICK_SECONDS = 0.5
"""How often the user hears of running models; TLC itself may say nothing for a minute."""


@dataclass
class _Running:
    """A running model: since when (monotonic seconds), and the last progress message of TLC."""

    model: Model
    began: float
    text: str = "running"

    def event(self) -> Event:
        """Say how far it is."""
        return Event(self.model, f"{self.text}, {time.monotonic() - self.began:.0f} s")


@dataclass(frozen=True)
class Harness:
    """Shared by all runs.

    `workers` are the TLC workers of a model that allows several (None: its own number); `residents` run the negative
    controls of a model one after the other in one JVM (None: each run has its own).
    """

    manifest: Manifest
    tools: tlc.Toolchain
    processes: Processes
    workers: int | None = None
    residents: Residents | None = None

    def workers_of(self, model: Model) -> int:
        """Return the TLC workers of a model: 1 where the manifest says 1, even if the user asked for more."""
        return model.workers if self.workers is None or model.workers == 1 else self.workers


def check(harness: Harness, model: Model, listen: Callable[[Message], None] = lambda _: None) -> Result:
    """Run one model and judge it. Raises `InterruptedRunError`.

    A negative control that has to violate a PROPERTY is run with that one alone, beside all its invariants. What a
    JVM says that ran TLC before counts only if it is as pinned: else the control has a JVM of its own.
    """
    if harness.residents is not None and not _may_share(harness, model):
        harness = replace(harness, residents=None)
    narrow = model
    if model.kind == "negative" and model.expect.property in model.checked("PROPERTY"):
        narrow = _only(model, model.expect.property)
    try:
        run = _run(harness, narrow, listen)
    except StaleMutationError as stale:
        return Result(model, Outcome("broken", detail=str(stale)), None, 0.0, 0, (str(stale),))
    outcome = _attribute(harness, narrow, run)
    result = judge(model, outcome, run.exit, run.seconds, harness.workers_of(model), run.output)
    if harness.residents is None or (result.ok and not outcome.liveness_checked):
        return result
    return check(replace(harness, residents=None), model, listen)


def _may_share(harness: Harness, model: Model) -> bool:
    """Whether a JVM may run this after another control of the same model: TLC checks no liveness twice in a JVM."""
    base = next((m for m in harness.manifest.models if m.name == model.base), None)
    return model.kind == "negative" and model.brief and base is not None and base.kind == "model"


def _run(harness: Harness, model: Model, listen: Callable[[Message], None]) -> tlc.TlcRun:
    options = tlc.Options(
        workers=harness.workers_of(model),
        deadlock=model.deadlock,
        heap=model.heap,
        timeout=model.seconds[1],
        brief=model.brief,
        args=model.args,
    )
    with tempfile.TemporaryDirectory(prefix="s7check-", ignore_cleanup_errors=True) as temporary:
        space = prepare(Path(temporary).resolve(), harness.manifest.spec, harness.manifest.directory, model)
        shared = harness.residents and harness.residents.run(model.base, harness.tools, space, options, listen)
        return shared or tlc.run(harness.tools, space, options, harness.processes, listen)


def _only(model: Model, name: str) -> Model:
    return replace(model, config=cfg.replace_section(model.config, "PROPERTY", [name]))


def _attribute(harness: Harness, model: Model, run: tlc.TlcRun) -> Outcome:
    """Find out which PROPERTY was violated where TLC did not name it.

    TLC 2.18 names no temporal property, and any TLC gives only the place of a conjunct of a property such as another
    module's Spec. If the configuration has one PROPERTY it is that one. If it has several, each is run alone, until
    one is violated in the same way.
    """
    outcome = run.outcome
    if outcome.kind not in PROPERTY_KINDS or outcome.names:
        return outcome
    properties = model.checked("PROPERTY")
    if len(properties) == 1:
        return replace(outcome, names=properties)
    for name in properties:
        if _run(harness, _only(model, name), lambda _: None).outcome.kind == outcome.kind:
            return replace(outcome, names=(name,))
    return outcome


def run_all(harness: Harness, models: list[Model], jobs: int, tell: Callable[[Event], None]) -> list[Result]:
    """Run the models on `jobs` cores, the longest first, and return the results in the order of `models`.

    A model takes as many cores as it has TLC workers. `tell` is called in this thread. Whatever ends this call early,
    Ctrl-C too, kills all that runs.
    """
    # The controls of a model stand together, so that they find a JVM that ran the one before.
    waiting = sorted(models, key=lambda m: (-sum(m.seconds), m.base))
    events: queue.Queue[Event | BaseException] = queue.Queue()
    results: dict[str, Result] = {}
    free = jobs
    threads: list[threading.Thread] = []
    running: dict[str, _Running] = {}
    try:
        while len(results) < len(models):
            while waiting and (cores := min(harness.workers_of(waiting[0]), jobs)) <= free:
                free -= cores
                model = waiting.pop(0)
                running[model.name] = _Running(model, time.monotonic())
                tell(Event(model))
                threads.append(threading.Thread(target=_work, args=(harness, model, events), daemon=True))
                threads[-1].start()
            try:
                event = events.get(timeout=TICK_SECONDS)
            except queue.Empty:
                for going in running.values():
                    tell(going.event())
                continue
            if isinstance(event, BaseException):
                raise event
            if event.result is not None:
                free += min(harness.workers_of(event.model), jobs)
                results[event.model.name] = event.result
                del running[event.model.name]
                tell(event)
            else:
                running[event.model.name].text = event.text
    finally:
        if len(results) < len(models):
            harness.processes.close()
            for thread in threads:
                thread.join(timeout=5)
    return [results[m.name] for m in models]


def _work(harness: Harness, model: Model, events: queue.Queue[Event | BaseException]) -> None:
    def listen(message: Message) -> None:
        if text := progress(message):
            events.put(Event(model, text))

    try:
        events.put(Event(model, result=check(harness, model, listen)))
    except InterruptedRunError:
        pass
    except BaseException as error:
        events.put(error)  # the main thread raises it
