"""Fixtures of several test modules."""

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from s7check.engine import pool
from s7check.engine.client import Engine
from s7check.judging.check import check_log
from s7check.report.report import Report

FAKE_ENGINE = Path(__file__).with_name("fake_engine.py")


@pytest.fixture
def fake_command() -> list[str]:
    """The command of the fake engine."""
    return [sys.executable, str(FAKE_ENGINE)]


@pytest.fixture
def _fake_engine(fake_command: list[str], monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Has commands run with the fake engine."""
    pool.end()
    monkeypatch.setattr(pool, "Engine", lambda: Engine(lambda: fake_command))
    yield
    pool.end()


@pytest.fixture(scope="session")
def real_engine() -> Iterator[Engine]:
    """The real engine, one for all tests."""
    with Engine() as engine:
        yield engine


@pytest.fixture(scope="session")
def judge(real_engine: Engine) -> Callable[[Path], Report]:
    """A function that has the real engine judge a log."""
    return lambda log: check_log(str(log), real_engine, lambda _, __: None)
