"""docs/rules/book.md: sentences and formulas are held together."""

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from evidence.common.checkout import ROOT
from evidence.views.site.chapters import BOOK, actions, problems
from evidence.views.traceability.project import Project, read_project


@pytest.fixture(scope="module")
def project() -> Project:
    """The project as it is."""
    return read_project(ROOT)


@pytest.fixture
def book(tmp_path: Path) -> Callable[[str, str], Path]:
    """A checkout of the book alone, with a change."""

    def made(old: str, new: str) -> Path:
        text = (ROOT / BOOK).read_text(encoding="utf-8")
        assert old in text
        (tmp_path / BOOK).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / BOOK).write_text(text.replace(old, new, 1), encoding="utf-8")
        return tmp_path

    return made


def test_this_book_and_this_specification_agree(project: Project) -> None:
    """No name without a definition, no rule without a chapter, no action without a sentence."""
    assert problems(project) == []
    assert len(actions(project)) > 25


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("`CanTint`", "`CanTintel`", f"{BOOK}: `CanTintel`: no definition of spec/ has this name"),
        ("`GoesToRun` ends", "It ends", "System.tla:N: no sentence of docs/rules/book.md names GoesToRun"),
        ("OBS-30 to OBS-33", "OBS-30 to OBS-32", f"{BOOK}: OBS-33 stands in no chapter"),
        ("OBS-30 to OBS-33", "OBS-29 to OBS-33", f"{BOOK}: OBS-29 stands in 2 chapters"),
    ],
)
def test_what_parts_them_is_named(
    project: Project, book: Callable[[str, str], Path], old: str, new: str, said: str
) -> None:
    """With its place."""
    found = [re.sub(r"\.tla:\d+", ".tla:N", one) for one in problems(project, book(old, new))]
    assert found == [said]


def test_a_rule_that_does_not_exist_is_named(project: Project, book: Callable[[str, str], Path]) -> None:
    """At either end of a range."""
    with pytest.raises(ValueError, match="OBS-99 does not exist"):
        problems(project, book("OBS-30 to OBS-33", "OBS-30 to OBS-99"))


def test_a_formula_without_a_sentence_is_named(project: Project) -> None:
    """A tag of a rule that is in no document."""
    *others, last = next(m for m in project.spec if m.name == "System").definitions
    module = replace(project.spec[-1], name="System", definitions=(*others, replace(last, tags=("OBS-98",))))
    changed = replace(project, spec=(*(m for m in project.spec if m.name != "System"), module))
    assert problems(changed) == [f"System.tla:{last.line}: OBS-98 has no sentence"]
