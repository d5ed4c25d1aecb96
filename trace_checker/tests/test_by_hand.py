"""Logs that were judged by hand, from the requirements alone, before the checker saw them."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from s7check.judging.verdict import Report
from tests.by_hand.shorthand import HandLog, read
from tests.by_hand.situations.builder import FIRST_TWO
from tests.by_hand.situations.judge import all_cases, differences, letters_with_effect

ONE_IN = 16
"""One of so many logs of the situations is judged here; `make round` judges them all."""

DOCS = Path(__file__).parents[2] / "docs"
CONSTANTS = re.compile(
    r'<a id="(AMB-\d+)"></a>(?:(?!<a id).)*?Default (\w): (?:(?!<a id).)*?Specification: constant \(([a-d, ]+)\)'
)
"""The entries of readings.md whose letters the specification tells apart: name, default, letters."""

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


def test_every_letter_has_an_effect(judge: Callable[[Path], Report], tmp_path: Path) -> None:
    """The verdict of a log hangs on each letter that is no default and that the specification tells apart."""
    some = [(name, case) for name, case in all_cases() if case.variant < len(FIRST_TWO)]
    effective = letters_with_effect(some, judge, tmp_path)
    page = " ".join((DOCS / "rules" / "readings.md").read_text(encoding="utf-8").split())
    found = CONSTANTS.findall(page)
    assert len(found) > 70
    letters = {(name, letter) for name, default, choice in found for letter in choice.split(", ") if letter != default}
    assert letters - effective == {("AMB-04", "c")}  # bit 5 is 0 as under (a): there is no test function
