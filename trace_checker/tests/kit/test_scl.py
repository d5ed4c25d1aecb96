"""Programs as SCL source: its blocks, branches and operands. STEP 7, which would compile it, is not at hand."""

import json
import re

import pytest

from s7check.kit.collection import programs_of
from s7check.kit.program import read_program
from s7check.kit.scl import NotForCpuError, to_scl
from tests.kit.programs import PROGRAM, changed


def test_source() -> None:
    """Runs are branches, calls go through the logging FCs, events from outside stand in the comment."""
    source = to_scl(read_program(json.dumps(PROGRAM).encode()))
    assert "CASE DB110.ob_1 OF\n  1 :\n    ret := FC128(OB_NR := 10, SDT := DT#2026-02-30-06:00:00.000" in source
    assert "PERIOD := W#16#0201);" in source
    assert "FC199(ms := 2000);" in source
    assert "after 1000 ms: interrupt ob 35" in source


def test_moved_clock() -> None:
    """SFC 0 knows dates only."""
    program = changed("bodies.1.steps.4", {"event": "clock", "by": 5})
    with pytest.raises(NotForCpuError, match="moved by a duration"):
        to_scl(read_program(json.dumps(program).encode()))


def test_every_program_of_the_kit() -> None:
    """Blocks begin and end in pairs, and only the FCs of s7log.scl and the wait are called."""
    for program in programs_of()[::10]:
        try:
            source = to_scl(program)
        except NotForCpuError:
            continue
        code = re.sub(r"\(\*.*?\*\)", "", source, flags=re.DOTALL)
        for begin in ("ORGANIZATION_BLOCK", "DATA_BLOCK", "FUNCTION", "CASE", "WHILE"):
            assert len(re.findall(rf"^\s*{begin}\b", code, re.MULTILINE)) == code.count(f"END_{begin}"), program.name
        assert {int(number) for number in re.findall(r"\bFC(\d+)\(", code)} <= {
            *(100, 110, 111, 151, 199),
            *range(128, 135),
            *range(139, 143),
        }
