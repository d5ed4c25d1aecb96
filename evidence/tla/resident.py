"""TLC processes that stay for the next run.

A short run is mostly the start of Java and code that is not compiled yet. A process of the engine's class
``tla.tlc.Runs`` runs TLC again and again. TLC keeps much in static fields, so that a process takes only the runs of
one kind; who calls says which these are.
"""

from __future__ import annotations

import os
import subprocess
import tempfile
import threading
from collections.abc import Callable, Hashable
from dataclasses import dataclass
from pathlib import Path

from evidence.common.processes import InterruptedRunError, Processes
from evidence.tla import tlc
from evidence.tla.messages import Message
from s7check import resources

_MAIN_CLASS = "tla.tlc.Runs"
_EXIT = "@!@!@EXIT "
"""The line behind the output of a run, with TLC's exit code."""


@dataclass(frozen=True)
class _Resident:
    """A process between two runs, and its folder."""

    kind: Hashable
    process: subprocess.Popen[str]
    folder: tempfile.TemporaryDirectory[str]


class Residents:
    """At most so many processes at a time, each for the runs of one kind. Safe to use from that many threads."""

    def __init__(self, processes: Processes, most: int) -> None:
        """Start with none."""
        self._processes = processes
        self._most = most
        self._lock = threading.Lock()
        self._idle: list[_Resident] = []
        self._busy = 0

    def run(
        self,
        kind: Hashable,
        tools: tlc.Toolchain,
        space: tlc.Workspace,
        options: tlc.Options,
        listen: Callable[[Message], None] = lambda _: None,
    ) -> tlc.TlcRun | None:
        """Run TLC once, in a process that ran this kind before if there is one; None if the process ended.

        Raises `InterruptedRunError` if the harness is ending.
        """
        resident = self._take((kind, tools, options), tools, options)
        alive = False
        try:
            process = resident.process
            assert process.stdin is not None
            library = os.pathsep.join(str(path) for path in space.library)
            module = str(space.directory / space.module)
            with self._processes.watched(process, options.timeout) as expired:
                process.stdin.write("\t".join([library, *tlc.arguments(tools, space, options), module]) + "\n")
                process.stdin.flush()
                run = tlc.follow(process, space, expired, options, listen, until=_EXIT)
            alive = run is not None and not expired.is_set()
        except BrokenPipeError:
            run = None
        finally:
            self._give(resident, alive=alive)
        if self._processes.closed:
            raise InterruptedRunError
        return run

    def close(self) -> None:
        """End the processes that wait for a run."""
        with self._lock:
            idle, self._idle = self._idle, []
        for resident in idle:
            self._end(resident)

    def _take(self, kind: Hashable, tools: tlc.Toolchain, options: tlc.Options) -> _Resident:
        with self._lock:
            self._busy += 1
            found = next((r for r in self._idle if r.kind == kind), None)
            if found is not None:
                self._idle.remove(found)
                return found
            over = self._idle.pop(0) if self._idle and self._busy + len(self._idle) > self._most else None
        if over is not None:
            self._end(over)
        folder = tempfile.TemporaryDirectory(prefix="s7check-", ignore_cleanup_errors=True)
        root = Path(folder.name).resolve()
        jar = resources.ENGINE / "s7-trace-engine.jar"
        # TLC's jar comes first: the archive of classes is made for it, and the engine's jar has a class of its name.
        command = [*tlc.java(tools, options, root), "-cp", f"{tools.jar}{os.pathsep}{jar}", _MAIN_CLASS]
        try:
            process = self._processes.start(command, root, stdin=subprocess.PIPE)
        except BaseException:
            folder.cleanup()
            with self._lock:
                self._busy -= 1
            raise
        return _Resident(kind, process, folder)

    def _give(self, resident: _Resident, *, alive: bool) -> None:
        with self._lock:
            self._busy -= 1
            if alive:
                self._idle.append(resident)
        if not alive:
            self._end(resident)

    def _end(self, resident: _Resident) -> None:
        self._processes.end(resident.process)
        resident.folder.cleanup()
