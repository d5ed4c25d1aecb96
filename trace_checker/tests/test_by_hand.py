"""Logs that were judged by hand, from the requirements alone, before the checker saw them."""

from collections.abc import Callable
from pathlib import Path

import pytest

from s7check.judging.verdict import Report
from tests.by_hand.shorthand import HandLog, read

LOGS = list(read(Path(__file__).parent / "by_hand" / "round.txt"))


@pytest.mark.parametrize("log", LOGS, ids=lambda log: log.name)
def test_verdict(log: HandLog, judge: Callable[[Path], Report], tmp_path: Path) -> None:
    """The verdict, and the line of a rejected log."""
    file = tmp_path / f"{log.name}.ndjson"
    file.write_text(log.text(), encoding="utf-8")
    report = judge(file)
    verdicts = {"accepted": "A", "rejected": f"R{report.line}"}
    assert verdicts.get(report.verdict, report.verdict) == log.expected, report.message
