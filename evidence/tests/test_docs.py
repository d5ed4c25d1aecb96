"""The pages of the project: their links lead somewhere."""

import re
from pathlib import Path
from urllib.parse import unquote

import pytest

from evidence.common.checkout import ROOT
from evidence.views.traceability.project import READINGS
from s7check.engine.client import Engine
from s7check.report.clauses import questions_of

PAGES = sorted(
    path
    for pattern in (
        "*.md",
        *(
            f"{folder}/**/*.md"
            for folder in ("docs", "traces", "bench", "examples", "instrumentation", "spec", "models", ".github")
        ),
    )
    for path in ROOT.glob(pattern)
)
LINK = re.compile(r"\]\(([^()\s]+)\)")
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)
ANCHOR = re.compile(r'<a id="([^"]+)">')
CODE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
FOLDERS = "bench|docs|evidence|examples|gallery|instrumentation|kit|models|spec|traces|trace_checker"
PLACE = re.compile(rf"`((?:{FOLDERS})/[\w./*-]*)`")
SETTLED = re.compile(r"Default ([a-f]): .*?Specification: (?:constant \(([a-f, ]+)\))?")
"""Of a question in readings.md the default, and the letters that are constants."""
EXAMPLES = {"models/MCName.tla", "models/MCName.cfg"}
"""Names that stand for others."""


def anchors(page: Path) -> set[str]:
    """The places of a page that a link can name."""
    return anchors_of(page.read_text(encoding="utf-8"))


def anchors_of(text: str) -> set[str]:
    """The places in a text that a link can name: its headings, as code hosts spell them, and its anchors."""
    headings = (
        re.sub(r"[^\w\- ]", "", found.lower()).replace(" ", "-") for found in HEADING.findall(CODE.sub("", text))
    )
    return {*headings, *ANCHOR.findall(text)}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_links(page: Path) -> None:
    """Each link to a file of the project, and to a place in a page, has an end."""
    dangling = []
    for link in LINK.findall(CODE.sub("", page.read_text(encoding="utf-8"))):
        target, _, place = unquote(link).partition("#")
        file = (page.parent / target) if target else page
        if "://" not in link and (not file.exists() or (place and place not in anchors(file))):
            dangling.append(link)
    assert dangling == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_files_that_are_named(page: Path) -> None:
    """Each file or folder of the project that a page names is there."""
    named = set(PLACE.findall(page.read_text(encoding="utf-8"))) - EXAMPLES
    missing = [name for name in sorted(named) if not (any(ROOT.glob(name)) or any(ROOT.glob(f"{name}.*")))]
    assert missing == []


def test_letters_of_readings(engine: Engine) -> None:
    """readings.md has the letters that a header may name, and as constants those that the specification tells apart."""
    text = (ROOT / READINGS).read_text(encoding="utf-8")
    entries = questions_of(text)
    page = " ".join(text.split())
    settled = dict(zip((entry.id for entry in entries), SETTLED.findall(page), strict=True))
    choices = engine.alternatives()
    assert {entry.id: sorted(entry.letters) for entry in entries} == choices.readings
    apart = {name: sorted(letters) for name, letters in choices.letters if len(letters) > 1}
    assert {name: constants.split(", ") for name, (_, constants) in settled.items() if constants} == apart
    assert {name: settled[name][0] for name in apart} == {
        name: letter for name, letter in choices.defaults if name in apart
    }


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_width(page: Path) -> None:
    """A line has at most 120 characters."""
    lines = page.read_text(encoding="utf-8").splitlines()
    assert [number for number, line in enumerate(lines, 1) if len(line) > 120] == []
