"""The kit in a test suite of its own: each program is a test of pytest."""

import json
import sys
from pathlib import Path

import pytest

from s7check.kit.suite import Kit
from tests.kit.test_run import ADAPTER, EVENTS, program
from tests.test_shipped_logs import PROJECT

pytest_plugins = "pytester"


def test_each_program_is_a_test(pytester: pytest.Pytester) -> None:
    """As docs/checking/python.md has it: passed, failed with the reason and no traceback, skipped."""
    page = (PROJECT / "docs" / "checking" / "python.md").read_text(encoding="utf-8")
    source = next(part for part in page.split("```")[1::2] if "s7check.kit.suite" in part)
    command = [sys.executable, str(ADAPTER), str(pytester.path)]
    for name, text in EVENTS.items():
        (pytester.path / f"{name}.events").write_text(text, encoding="utf-8")
    lines = [json.dumps(program(way)) for way in ("right", "wrong", "skip", "refused", "crash", "extra")]
    (pytester.path / "programs.ndjson").write_text("\n".join(lines), encoding="utf-8")
    old = 'Kit(["./my_cpu"], only=["AIRT-*"], offer="cpu.json")'
    assert old in source
    pytester.makepyfile(source.replace(old, f"Kit({command!r}, programs=['programs.ndjson'])"))
    result = pytester.runpytest_subprocess("-rs")
    result.assert_outcomes(passed=1, failed=4, skipped=1)
    result.stdout.fnmatch_lines_random(
        [
            "SKIPPED*no HOLD",
            "*test_program?AIRT-wrong?*",
            "E*failed: rejected: no behaviour*",
            "E*passed under profile 1997*",
            "E*failed: the adapter ended with exit code 7: out of cheese",
            "E*not the log of this program: line 3: no call of the program is left here",
        ]
    )
    result.stdout.no_fnmatch_line("*suite.py*")


def test_a_choice_of_none(tmp_path: Path) -> None:
    """No test is no success."""
    with pytest.raises(ValueError, match="no program fits it"):
        Kit(["cpu"], only=["nothing"])
    offer = tmp_path / "offer.json"
    offer.write_text('{"longest": 1}', encoding="utf-8")
    assert len(Kit(["cpu"], only=["AIRT-*"], offer=offer).names) > 1, "skipped programs are tests, too"
    with pytest.raises(ValueError, match="no program fits it"):
        Kit(["cpu"], only=["AIRT-*"], offer=offer, cover="requirements")
