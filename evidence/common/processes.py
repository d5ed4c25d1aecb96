"""Processes that end with the command that started them."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import threading
from collections.abc import Iterator
from pathlib import Path


class InterruptedRunError(RuntimeError):
    """The run was not started or was killed because the harness is ending."""


class Processes:
    """The running Java processes, so that the end of the harness is theirs too. Safe to use from several threads."""

    def __init__(self) -> None:
        """Start with none."""
        self._lock = threading.Lock()
        self._running: set[subprocess.Popen[str]] = set()
        self._closed = False

    def start(self, command: list[str], directory: Path, stdin: int = subprocess.DEVNULL) -> subprocess.Popen[str]:
        """Start a process in a group of its own. Raises `InterruptedRunError` after `close`."""
        with self._lock:
            if self._closed:
                raise InterruptedRunError
            process = subprocess.Popen(
                command,
                cwd=directory,
                stdin=stdin,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                encoding="utf-8",
                errors="replace",
                start_new_session=True,
            )
            self._running.add(process)
            return process

    def end(self, process: subprocess.Popen[str]) -> None:
        """Kill the rest of the process's group, close its output, and forget it."""
        kill(process)
        # What was not read yet cannot be delivered any more.
        with contextlib.suppress(BrokenPipeError), process:
            pass
        with self._lock:
            self._running.discard(process)

    @contextlib.contextmanager
    def limited(self, process: subprocess.Popen[str], seconds: float) -> Iterator[threading.Event]:
        """Kill a process after so many seconds, and end it with the block; the event says that its time was up.

        Raises `InterruptedRunError` after the block if `close` was called meanwhile.
        """
        try:
            with self.watched(process, seconds) as expired:
                yield expired
        finally:
            self.end(process)
        if self.closed:
            raise InterruptedRunError

    @contextlib.contextmanager
    def watched(self, process: subprocess.Popen[str], seconds: float) -> Iterator[threading.Event]:
        """Kill a process after so many seconds in the block; the event says that its time was up."""
        expired = threading.Event()

        def expire() -> None:
            expired.set()
            kill(process)

        watchdog = threading.Timer(seconds, expire)
        watchdog.daemon = True
        watchdog.start()
        try:
            yield expired
        finally:
            watchdog.cancel()

    def close(self) -> None:
        """Kill all and start no more."""
        with self._lock:
            self._closed = True
            for process in self._running:
                kill(process)

    @property
    def closed(self) -> bool:
        """Whether `close` was called."""
        return self._closed


def kill(process: subprocess.Popen[str]) -> None:
    """Kill the process with its whole group, which may be gone."""
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(process.pid, signal.SIGKILL)
