"""Engines that outlive the check that needed them: a second check need not start Java again."""

import atexit
import os
from collections import defaultdict
from collections.abc import Iterator
from contextlib import contextmanager
from threading import local

from s7check.engine.answer import Alternatives
from s7check.engine.client import Engine

_idle: defaultdict[int, list[Engine]] = defaultdict(list)
"""By process: a child process has no use for the engines that its parent has started."""

_held = local()


def take() -> Engine:
    """An engine that nobody else uses. ``give_back`` keeps it for the next one; the end of the process ends it."""
    try:
        return _idle[os.getpid()].pop()
    except IndexError:
        return Engine()


def give_back(engine: Engine) -> None:
    """Keeps an engine from ``take`` for the next one."""
    _idle[os.getpid()].append(engine)


@contextmanager
def engine() -> Iterator[Engine]:
    """An engine for a block of code; a block inside it, in the same thread, has the same one."""
    if hasattr(_held, "engine"):
        yield _held.engine
        return
    _held.engine = take()
    try:
        yield _held.engine
    finally:
        give_back(_held.engine)
        del _held.engine


def alternatives() -> Alternatives:
    """The words of a log. Raises EngineError."""
    with engine() as one:
        return one.alternatives()


@atexit.register
def end() -> None:
    """Ends the idle engines of this process."""
    engines = _idle[os.getpid()]
    while engines:
        engines.pop().__exit__(None, None, None)
