"""Reading and editing TLC's configuration files."""

from __future__ import annotations

import pytest

from evidence.tla.cfg import CfgError, override, parse, replace_section

TEXT = """\\* CONSTANT Wrong = 1
SPECIFICATION Spec
CONSTANTS
    Limit = 4 (* INVARIANT No (* nested *) *)
    Obs = {"OB10", "OB = 11"}
    Units <- [Clock] Few
    None = None
    Low = -1
INVARIANTS InRange
    TypeOK \\* both
PROPERTY Live
CONSTANT Last <- LastOne
"""


def test_sections_and_assignments() -> None:
    """Names and assignments are found in all sections of a keyword; comments and strings are not looked into."""
    cfg = parse(TEXT)
    assert cfg.names("INVARIANT") == ("InRange", "TypeOK")
    assert cfg.names("PROPERTY") == ("Live",)
    assert {(a.name, a.operator, a.value) for a in cfg.assignments} == {
        ("Limit", "=", "4"),
        ("Obs", "=", '{"OB10", "OB = 11"}'),
        ("Units", "<-", "[Clock] Few"),
        ("None", "=", "None"),
        ("Low", "=", "-1"),
        ("Last", "<-", "LastOne"),
    }


@pytest.mark.parametrize(
    ("name", "value", "line"),
    [
        ("Limit", "5", "    Limit = 5 (* INVARIANT No (* nested *) *)"),
        ("Limit", "<- Five", "    Limit <- Five (* INVARIANT No (* nested *) *)"),
        ("Obs", "{}", "    Obs = {}"),
        ("Units", "[Clock] All", "    Units <- [Clock] All"),
        ("Last", "= 3", "CONSTANT Last = 3"),
        ("NewOne", "<- Other", "CONSTANT NewOne <- Other"),
    ],
)
def test_override_changes_one_line(name: str, value: str, line: str) -> None:
    """An override changes or adds exactly one line and keeps the comments."""
    before, after = TEXT.splitlines(), override(TEXT, name, value).splitlines()
    assert [new for new in after if new not in before] == [line]
    assert len(after) in (len(before), len(before) + 1)


def test_override_of_a_constant_assigned_twice_is_an_error() -> None:
    """Which of two assignments counts is not for the harness to guess."""
    with pytest.raises(CfgError, match="2 times"):
        override(TEXT + "CONSTANT Limit = 5\n", "Limit", "6")


def test_replace_section() -> None:
    """All sections of a keyword give way to one; an empty list removes them."""
    assert parse(replace_section(TEXT, "INVARIANT", ["A", "B"])).names("INVARIANT") == ("A", "B")
    assert parse(replace_section(TEXT, "PROPERTY", [])).names("PROPERTY") == ()
    assert len(parse(replace_section(TEXT, "PROPERTY", [])).assignments) == 6


def test_text_before_the_first_keyword_is_an_error() -> None:
    """A misspelled keyword at the start is not taken for nothing."""
    with pytest.raises(CfgError, match="INVARANT"):
        parse("INVARANT A\nSPECIFICATION Spec\n")
