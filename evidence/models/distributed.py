"""TLC's own distributed mode: one server, which keeps the fingerprints, and workers that compute successors.

For safety models that must pass. The server ends with exit code 0 whatever it found and ignores liveness properties
without a word, so its messages are read and models with liveness are not run. Generated states and depth are not
comparable with a single process; the distinct states are, and must be as pinned.
"""

from __future__ import annotations

import os
import socket
import threading
import time
import zipfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from subprocess import Popen

from evidence.common.processes import InterruptedRunError, kill
from evidence.models.judge import Result
from evidence.models.manifest import Model
from evidence.models.runner import Event, Harness, StaleMutationError, prepare
from evidence.tla import tlc
from evidence.tla.messages import Message, Parser, interpret

SERVER = "tlc2.tool.distributed.TLCServer"
WORKER = "tlc2.tool.distributed.TLCWorker"
READY = 7000
"""Message code: the server waits for workers."""

LOOPBACK = "127.0.0.1"
PORT = 10997
"""TLC's default, to which workers elsewhere connect."""

PATIENCE = 3.0
"""How long the server may go on without any worker, in seconds: it would wait for ever."""

_EXCEPTION = "@!@!@STARTMSG 1000:1 "
"""Message code and class: the server ended by an exception."""

VIOLATED = "something is violated; TLC's server does not name it: run the model without --distributed"

TRIES = 3
"""How often a model is run whose server ends by an exception of its own.

When the work is done, the server tells each worker to exit, and does not expect every way in which the connection
to one that exits can end.
"""

SLACK = 4
"""A distributed run may take this many times the model's longest time: every block of states goes over the network."""


@dataclass(frozen=True)
class Cluster:
    """Workers to start here, and the name under which workers elsewhere reach the server (None: loopback only)."""

    workers: int
    host: str | None = None


def works(tools: tlc.Toolchain) -> bool:
    """Say whether this TLC's distributed mode works at all.

    Workers call the server's fingerprint set over the network. In the TLC of 2026 it is no longer an object that can
    be called so, and every worker ends with a NotSerializableException.
    """
    with zipfile.ZipFile(tools.jar) as archive:
        return b"java/rmi/server/UnicastRemoteObject" in archive.read("tlc2/tool/fp/FPSet.class")


def reason_against(model: Model) -> str | None:
    """Say why a model cannot be run in distributed mode; None if it can."""
    if model.kind == "liveness":
        return "TLC's distributed mode ignores liveness properties"
    return None if model.expect.exit == 0 else "only models that must pass are run in distributed mode"


def worker_command(java: str, jar: str, host: str, properties: tuple[str, ...] = ()) -> list[str]:
    """Return the command of one worker with one thread; it has the modules from the server."""
    return [java, *properties, f"-D{WORKER}.threadCount=1", "-cp", jar, WORKER, host]


def server_command(tools: tlc.Toolchain, space: tlc.Workspace, model: Model, cluster: Cluster, port: int) -> list[str]:
    """Return the command of the server."""
    return [
        tools.java,
        "-XX:+UseParallelGC",
        f"-Xmx{model.heap}m",
        f"-D{SERVER}.port={port}",
        f"-Djava.rmi.server.hostname={cluster.host or LOOPBACK}",
        f"-Djava.io.tmpdir={space.scratch}",
        f"-DTLA-Library={os.pathsep.join(str(path) for path in space.library)}",
        *("-cp", str(tools.jar)),
        *(SERVER, "-tool", "-fp", "0"),
        *("-metadir", str(space.scratch / "meta")),
        *(() if model.deadlock else ("-deadlock",)),
        *("-config", space.config.name),
        space.module.removesuffix(".tla"),
    ]


def run_all(harness: Harness, models: list[Model], cluster: Cluster, tell: Callable[[Event], None]) -> list[Result]:
    """Run one model after the other, since each takes all workers, and judge it. Raises `InterruptedRunError`."""
    return [_check(harness, model, cluster, tell) for model in models]


def _check(harness: Harness, model: Model, cluster: Cluster, tell: Callable[[Event], None]) -> Result:
    def say(text: str) -> None:
        tell(Event(model, text))

    tell(Event(model))
    for again in range(TRIES):
        result = _check_once(harness, model, cluster, say)
        if not _server_broke(result) or again == TRIES - 1:
            break
        say("TLC's server ended by an exception: the model is run again")
    tell(Event(model, result=result))
    return result


def _server_broke(result: Result) -> bool:
    """Whether the server ended by an exception, with nothing found: neither a violation nor a count."""
    outcome = result.outcome
    return outcome.kind == "broken" and not outcome.trace and _EXCEPTION in result.output


def _check_once(harness: Harness, model: Model, cluster: Cluster, tell: Callable[[str], None]) -> Result:
    began = time.monotonic()
    with tlc.temporary_folder() as root:
        try:
            space = prepare(root, harness.manifest, model)
        except StaleMutationError as stale:
            return _result(model, Parser(), None, 0.0, cluster, "", str(stale))
        run = _Run(harness, model, cluster, space, root, tell)
        try:
            code, problem = run.until_done(began + SLACK * model.seconds[1])
        finally:
            run.close()
    if harness.processes.closed:
        raise InterruptedRunError
    run.parser.finish()
    return _result(model, run.parser, code, time.monotonic() - began, cluster, "".join(run.lines), problem)


class _Run:
    """A server and its workers."""

    def __init__(
        self,
        harness: Harness,
        model: Model,
        cluster: Cluster,
        space: tlc.Workspace,
        root: Path,
        tell: Callable[[str], None],
    ) -> None:
        self.parser = Parser()
        self.lines: list[str] = []
        self._harness, self._cluster, self._root, self._tell = harness, cluster, root, tell
        self._space = space
        self._host = cluster.host or LOOPBACK
        self._port = PORT if cluster.host else _free_port()
        self._ready = threading.Event()
        self._workers: list[tuple[Popen[str], list[str]]] = []
        command = server_command(harness.tools, space, model, cluster, self._port)
        self._server = harness.processes.start(command, space.directory)
        self._readers: list[threading.Thread] = []
        self._read(self._read_server)

    def until_done(self, deadline: float) -> tuple[int | None, str]:
        """Start the workers when the server is ready; return the server's exit code, or None and the problem."""
        alone_since: float | None = None
        while self._server.poll() is None:
            time.sleep(0.05)
            now = time.monotonic()
            if now > deadline:
                return None, "timeout: killed"
            if self._ready.is_set() and not self._workers and self._cluster.workers:
                self._start_workers()
            alone = bool(self._workers) and all(worker.poll() is not None for worker, _ in self._workers)
            alone_since = (alone_since or now) if alone and self._cluster.host is None else None
            if alone_since is not None and now - alone_since > PATIENCE:
                said = " ".join(line.strip() for line in self._workers[0][1][-3:])
                return None, f"all workers ended before the server: {said}"
        self._readers[0].join(timeout=5)
        return self._server.returncode, ""

    def close(self) -> None:
        """End all processes."""
        for process in (self._server, *(worker for worker, _ in self._workers)):
            kill(process)
        for reader in self._readers:
            reader.join(timeout=5)
        for process in (self._server, *(worker for worker, _ in self._workers)):
            self._harness.processes.end(process)

    def _start_workers(self) -> None:
        for number in range(self._cluster.workers):
            scratch = self._root / f"worker{number}"
            scratch.mkdir()
            command = worker_command(
                self._harness.tools.java,
                str(self._harness.tools.jar),
                self._host,
                (
                    f"-D{SERVER}.port={self._port}",
                    f"-Djava.rmi.server.hostname={self._host}",
                    f"-Djava.io.tmpdir={scratch}",
                ),
            )
            process = self._harness.processes.start(command, scratch)
            said: list[str] = []
            self._read(partial(_read, process, said))
            self._workers.append((process, said))

    def _read(self, read: Callable[[], None]) -> None:
        self._readers.append(threading.Thread(target=read, daemon=True))
        self._readers[-1].start()

    def _read_server(self) -> None:
        assert self._server.stdout is not None
        for said in self._server.stdout:
            line = self._space.located(said)
            self.lines.append(line)
            for message in self.parser.feed(line):
                self._listen(message)

    def _listen(self, message: Message) -> None:
        if message.code == READY:
            self._ready.set()
            if self._cluster.host:
                self._tell(" ".join(worker_command("java", self._harness.tools.jar.name, self._host)))


def _read(process: Popen[str], said: list[str]) -> None:
    assert process.stdout is not None
    said.extend(line for line in process.stdout if line.strip())


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind((LOOPBACK, 0))
        port: int = probe.getsockname()[1]
        return port


def _result(
    model: Model, parser: Parser, code: int | None, seconds: float, cluster: Cluster, output: str, problem: str
) -> Result:
    outcome = interpret(parser, code if code is not None else -1)
    if problem:
        outcome = replace(outcome, kind="broken", detail=problem)
    elif outcome.kind == "broken" and outcome.trace:
        outcome = replace(outcome, detail=VIOLATED)
    problems = [] if outcome.kind == "passed" else [f"{outcome.kind}: {outcome.detail}"]
    counts = []
    if not problems and outcome.counts.distinct != model.expect.distinct:
        counts = [f"{outcome.counts.distinct} distinct, pinned {model.expect.distinct}"]
    return Result(model, outcome, code, seconds, cluster.workers, tuple(problems), tuple(counts), output)
