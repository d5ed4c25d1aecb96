"""The engine's evaluator of TLA+ beside TLC's interpreter, on what every eighth of the shipped logs needs.

With ``tla.compare`` the engine evaluates every operator both ways, and a difference is an
error instead of a verdict.
"""

from pathlib import Path

import pytest

from evidence.common.cases import all_cases, difference
from s7check.engine.client import Engine
from s7check.judging.check import check_log

EACH = 8
"""One case in so many: all would take a minute and a half, and `s7spec logs agree` compares the two on random logs."""


def test_the_evaluator_agrees_with_tlc(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """No log of the sample shows a difference: each has its verdict and line."""
    monkeypatch.setenv("JDK_JAVA_OPTIONS", "-Dtla.compare=true")
    with Engine() as engine:
        wrong = [
            wanted
            for case in all_cases()[::EACH]
            if (wanted := difference(case, check_log(str(case.put(tmp_path)), engine, lambda _, __: None)))
        ]
    assert wrong == []
