"""How commands that run Java for long end: in order, with an exit code, and with no process left."""

from __future__ import annotations

import contextlib
import signal
import sys
from collections.abc import Iterator
from types import FrameType

import click
from rich.console import Console

from evidence.common.console import console
from evidence.common.processes import InterruptedRunError, Processes

USAGE, NO_TOOLS, INTERRUPTED = 2, 3, 130

_ENDING = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
"""Signals that end the command as Ctrl-C does; Windows has no SIGHUP."""

Errors = tuple[type[Exception], ...]


@contextlib.contextmanager
def session(processes: Processes, usage: Errors, tools: Errors, interrupted: str = "interrupted") -> Iterator[Console]:
    """Ends the command at an error of `usage` or `tools` and at a signal, and the processes in any case."""
    before = {number: signal.signal(number, _interrupt) for number in _ENDING}
    try:
        yield console()
    except usage as error:
        _end(f"Error: {error}", USAGE)
    except tools as error:
        _end(f"Error: {error}", NO_TOOLS)
    except (KeyboardInterrupt, InterruptedRunError):
        _end(interrupted, INTERRUPTED)
    finally:
        processes.close()
        for number, handler in before.items():
            signal.signal(number, handler)


def _end(said: str, code: int) -> None:
    click.echo(said, err=True)
    sys.exit(code)


def _interrupt(_signal: int, _frame: FrameType | None) -> None:
    raise KeyboardInterrupt
