"""The engine's evaluator of TLA+ beside TLC's interpreter, on everything that the shipped logs need.

With ``tla.compare`` the engine evaluates every operator both ways, and a difference is an
error instead of a verdict.
"""

from pathlib import Path

import pytest

from evidence.common.shipped import difference, shipped_logs
from s7check.engine.client import Engine
from s7check.judging.check import check_log

TRACES = Path(__file__).resolve().parents[2] / "traces"


def test_the_evaluator_agrees_with_tlc(monkeypatch: pytest.MonkeyPatch) -> None:
    """No shipped log shows a difference: each has its verdict and line."""
    monkeypatch.setenv("JDK_JAVA_OPTIONS", "-Dtla.compare=true")
    with Engine() as engine:
        wrong = [
            wanted
            for log in shipped_logs(TRACES)
            if (wanted := difference(log, check_log(str(TRACES / log.file), engine, lambda _, __: None)))
        ]
    assert wrong == []
