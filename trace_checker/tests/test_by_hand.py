"""Logs that were judged by hand, from the requirements alone, before the checker saw them."""

from collections.abc import Callable
from pathlib import Path

import pytest

from s7check.judging.verdict import Report
from tests.by_hand.shorthand import HandLog, read
from tests.by_hand.situations.judge import all_cases, differences

ONE_IN = 16
"""One of so many logs of the situations is judged here; `make round` judges them all."""

LOGS = list(read(Path(__file__).parent / "by_hand" / "round.txt"))


@pytest.mark.parametrize("log", LOGS, ids=lambda log: log.name)
def test_verdict(log: HandLog, judge: Callable[[Path], Report], tmp_path: Path) -> None:
    """The verdict, and the line of a rejected log."""
    file = tmp_path / f"{log.name}.ndjson"
    file.write_text(log.text(), encoding="utf-8")
    report = judge(file)
    verdicts = {"accepted": "A", "rejected": f"R{report.line}"}
    assert verdicts.get(report.verdict, report.verdict) == log.expected, report.message


def test_situations(judge: Callable[[Path], Report], tmp_path: Path) -> None:
    """Verdict and line of every sixteenth log of the situations."""
    named = all_cases()
    assert len(named) == len({name for name, _ in named})
    found = differences(named[::ONE_IN], judge, tmp_path)
    assert [(name, case.expected, report.verdict, report.line) for name, case, report in found] == []
