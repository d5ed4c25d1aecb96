"""Which models run when, and all runs that a model needs for its result, each on a copy of the specification."""

from __future__ import annotations

import contextlib
import os
import queue
import shutil
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from evidence.common.processes import InterruptedRunError, Processes
from evidence.models.entries import Mutation
from evidence.models.judge import Result, judge
from evidence.models.manifest import PROPERTY_KINDS, Manifest, Model
from evidence.tla import tlc
from evidence.tla.messages import Message, Outcome, progress
from evidence.tla.modules import module_folders
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
    thread: threading.Thread
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


class StaleMutationError(ValueError):
    """The text that a mutation replaces does not occur exactly once: the manifest is behind the specification."""


def run_all(harness: Harness, models: list[Model], jobs: int, tell: Callable[[Event], None]) -> list[Result]:
    """Run the models on `jobs` cores, the longest first, and return the results in the order of `models`.

    A model takes as many cores as it has TLC workers. `tell` is called in this thread. Whatever ends this call early,
    Ctrl-C too, kills all that runs.
    """
    # The controls of a model stand together, so that they find a JVM that ran the one before.
    waiting = sorted(models, key=lambda m: (-sum(m.seconds), m.base))
    running: dict[str, _Running] = {}
    results: dict[str, Result] = {}
    events: queue.Queue[Event | BaseException] = queue.Queue()

    def cores(model: Model) -> int:
        return min(harness.workers_of(model), jobs)

    with contextlib.closing(Residents(harness.processes, jobs)) as residents:
        try:
            while len(results) < len(models):
                while waiting and cores(waiting[0]) + sum(cores(going.model) for going in running.values()) <= jobs:
                    model = waiting.pop(0)
                    tell(Event(model))
                    running[model.name] = _start(replace(harness, residents=residents), model, events)
                for event in _next(events, running):
                    if event.result is not None:
                        results[event.model.name] = event.result
                        del running[event.model.name]
                    tell(event)
        finally:
            if running:
                harness.processes.close()
                for going in running.values():
                    going.thread.join(timeout=5)
    return [results[m.name] for m in models]


def _start(harness: Harness, model: Model, events: queue.Queue[Event | BaseException]) -> _Running:
    thread = threading.Thread(target=_work, args=(harness, model, events), daemon=True)
    thread.start()
    return _Running(model, thread, time.monotonic())


def _next(events: queue.Queue[Event | BaseException], running: dict[str, _Running]) -> list[Event]:
    """Wait for a result; else say how far each running model is."""
    try:
        event = events.get(timeout=TICK_SECONDS)
    except queue.Empty:
        return [going.event() for going in running.values()]
    if isinstance(event, BaseException):
        raise event
    if event.result is None:
        running[event.model.name].text = event.text
        return []
    return [event]


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


def check(harness: Harness, model: Model, listen: Callable[[Message], None] = lambda _: None) -> Result:
    """Run one model and judge it. Raises `InterruptedRunError`.

    What a JVM says that ran TLC before, or of a model in several modules, counts only if it is as pinned: else the
    model has a JVM of its own, and is one module.
    """
    if harness.residents is not None and model.brief:
        shared = _may_share(harness, model)
        result = _check(harness if shared else replace(harness, residents=None), model, listen, apart=True)
        if result.ok and not (shared and result.outcome.liveness_checked):
            return result
    return _check(replace(harness, residents=None), model, listen)


def _may_share(harness: Harness, model: Model) -> bool:
    """Whether a JVM may run this after another control of the same model: TLC checks no liveness twice in a JVM."""
    base = next((m for m in harness.manifest.models if m.name == model.base), None)
    return model.kind == "negative" and model.brief and base is not None and base.kind == "model"


def _check(harness: Harness, model: Model, listen: Callable[[Message], None], *, apart: bool = False) -> Result:
    try:
        run = _run(harness, model, listen, apart=apart)
    except StaleMutationError as stale:
        return Result(model, Outcome("broken", detail=str(stale)), None, 0.0, 0, (str(stale),))
    outcome = _attribute(harness, model, run.outcome, apart=apart)
    return judge(model, outcome, run.exit, run.seconds, harness.workers_of(model), run.output)


def _run(harness: Harness, model: Model, listen: Callable[[Message], None], *, apart: bool) -> tlc.TlcRun:
    options = tlc.Options(
        workers=harness.workers_of(model),
        deadlock=model.deadlock,
        heap=model.heap,
        timeout=model.seconds[1],
        brief=model.brief,
    )
    with tlc.temporary_folder() as root:
        space = prepare(root, harness.manifest, model, apart=apart)
        shared = harness.residents and harness.residents.run(model.base, harness.tools, space, options, listen)
        return shared or tlc.run(harness.tools, space, options, harness.processes, listen)


def _attribute(harness: Harness, model: Model, outcome: Outcome, *, apart: bool) -> Outcome:
    """Find out which PROPERTY was violated where TLC did not name it.

    TLC 2.18 names no temporal property, and any TLC gives only the place of a conjunct of a property such as another
    module's Spec. If the configuration has one PROPERTY it is that one. If it has several, each is run alone, until
    one is violated in the same way.
    """
    if outcome.kind not in PROPERTY_KINDS or outcome.names:
        return outcome
    if len(model.properties) == 1:
        return replace(outcome, names=model.properties)
    for name in model.properties:
        alone = _run(harness, model.with_property(name), lambda _: None, apart=apart)
        if alone.outcome.kind == outcome.kind:
            return replace(outcome, names=(name,))
    return outcome


def prepare(root: Path, manifest: Manifest, model: Model, *, apart: bool = False) -> tlc.Workspace:
    """Copy the modules below the empty directory `root`, and apply the mutations. Raises `StaleMutationError`.

    Every run has a copy, also one that changes nothing: TLC writes next to its input, and nothing of that is to get
    into the repository.
    """
    _copy_modules(manifest.spec, root / "spec")
    _copy_modules(manifest.directory, root / "models")
    for mutation in model.mutations:
        _apply(root, mutation)
    (root / "scratch").mkdir()
    library = (root / "models", *module_folders(root / "spec"))
    file = root / "models" / model.module
    space = tlc.Workspace(file.parent, file.name, library, root / "scratch")
    space.config.write_text(model.config, encoding="utf-8")
    return space.as_one_module(apart=apart)


def _copy_modules(source: Path, target: Path) -> None:
    target.mkdir(parents=True)
    for directory, folders, files in os.walk(source):
        # Directories that tools leave behind can be large and hold old copies of modules.
        folders[:] = sorted(f for f in folders if not f.startswith(".") and f not in ("states", "canaries"))
        for file in files:
            if file.endswith(".tla"):
                copy = target / Path(directory).relative_to(source) / file
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(Path(directory) / file, copy)


def _apply(root: Path, mutation: Mutation) -> None:
    path = next(path for place in ("spec", "models") for path in (root / place).rglob(mutation.module))
    text = path.read_text(encoding="utf-8")
    times = text.count(mutation.replace)
    if times != 1:
        raise StaleMutationError(
            f"stale: {mutation.replace!r} occurs {times} times in {mutation.module}, a mutation needs exactly one"
        )
    path.write_text(text.replace(mutation.replace, mutation.by), encoding="utf-8")
