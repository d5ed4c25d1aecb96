"""Programs as SCL source: its blocks, branches and operands.

STEP 7, which would compile it, is not at hand. A parser of Structured Text, of which SCL is a dialect, reads the
declarations and the statements.
"""

import json
import re

import pytest
from blark.parse import parse_source_code  # type: ignore[import-untyped]

from s7check.kit.collection import programs_of
from s7check.kit.program import read_program
from s7check.kit.scl import NotForCpuError, to_scl
from s7check.log.calls import OPERANDS, WITHOUT_NUMBER
from tests.kit.programs import PROGRAM, changed


def test_source() -> None:
    """Runs are branches, calls go through the logging FCs, events from outside stand in the comment."""
    source = to_scl(read_program(json.dumps(PROGRAM).encode()))
    assert "CASE DB110.ob_1 OF\n  1 :\n    ret := FC128(OB_NR := 10, SDT := DT#2026-02-30-06:00:00.000" in source
    assert "PERIOD := WORD#16#0201);" in source
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


_FRAMES = (
    (r"^DATA_BLOCK.*?^END_DATA_BLOCK", ""),
    (r"^BEGIN$", ""),
    (r"ORGANIZATION_BLOCK", "PROGRAM"),
    (r" : VOID", ""),
    (r"VAR_TEMP", "VAR"),
    (r"ELSE :", "ELSE"),
)
"""The words of SCL around declarations and statements for which Structured Text has others."""


def accepted(source: str) -> str:
    """The complaint of blark's parser about the source, empty if there is none."""
    for scl, st in _FRAMES:
        source = re.sub(scl, st, source, flags=re.DOTALL | re.MULTILINE)
    wrong = parse_source_code(source).exception
    return str(wrong) if wrong else ""


def test_a_parser_accepts_the_statements() -> None:
    """Of programs that together have every call, every kind of step and both kinds of branches."""
    steps = [{"event": "clock", "to": "2026-11-21T06:00"}, {"event": "state", "ob": 10}, {"wait": 5}, {"end": True}]
    rare = changed("bodies", [{"ob": 1, "run": 2, "steps": steps}, {"ob": 1, "steps": steps}])
    source = to_scl(read_program(json.dumps(rare).encode()))
    assert "ELSE :" in source
    assert accepted(source) == ""
    called = []
    for program in programs_of()[::5]:
        inside = [step for body in program.bodies for step in body.steps]
        if not any("by" in step for step in inside):  # SFC 0 knows dates only
            called.append((program, {step["call"] for step in inside if "call" in step}))
    wanted = {*OPERANDS} - {WITHOUT_NUMBER}
    while wanted:  # the program with the most calls that are new, for its size
        program, new = max(called, key=lambda one: len(one[1] & wanted) / len(one[0].line()))
        assert new & wanted
        assert accepted(to_scl(program)) == "", program.name
        wanted -= new


def test_the_parser_refuses() -> None:
    """A statement that is none."""
    source = to_scl(read_program(json.dumps(PROGRAM).encode()))
    assert accepted(source.replace("FC199(ms := 2000);", "FC199(ms := 2000;"))
