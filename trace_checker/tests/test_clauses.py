"""The text of the requirements that reports show."""

from pathlib import Path

import pytest

from s7check import cli
from s7check.report import clauses

DOCS = Path(cli.__file__).parents[2] / "docs" / "rules"


def test_one() -> None:
    """A requirement has its text, its sources and their confidence, an ambiguity its letters."""
    assert clauses.clause("AIRT-07").confidence == "H"
    assert set(clauses.clause("AMB-13").letters) == {"a", "b", "c", "d"}
    assert clauses.clause("AIRT-99").text == ""


@pytest.mark.skipif(not DOCS.is_dir(), reason="no checkout: docs/rules is not there")
@pytest.mark.parametrize("name", ["AIRT-07", "AMB-49"])
def test_place(name: str) -> None:
    """The anchor to which reports point is in the page that they name."""
    page, _, anchor = clauses.clause(name).place.partition("#")
    assert f'<a id="{anchor}">' in (DOCS.parents[1] / page).read_text(encoding="utf-8")


def test_named() -> None:
    """The IDs in a text, without those that are none and those that do not exist."""
    assert clauses.named("AIRT-07, AMB-49 b and AIRT-07; UTF-16, AIRT-99") == ["AIRT-07", "AMB-49"]


def test_event_ids() -> None:
    """Every ID that the rules make has words; one that no source has, has none."""
    ids = [
        *range(0x3501, 0x3504),
        0x3505,
        0x3506,
        0x3507,
        *range(0x35A1, 0x35A4),
        0x4568,
        0x456D,
        0x454A,
        0x4562,
        0x5380,
    ]
    assert all(map(clauses.event_text, ids))
    assert clauses.event_text(0x5381) == ""
